#include "CommandCompare.h"

#include "CommandLine.h"
#include "FiguresJson.h"
#include "MesoAtomicFile.h"
#include "MesoErrorPictures.h"
#include "MesoScene.h" // for MesoInputError
#include "vtkImageData.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>

namespace
{
bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

bool IsExr(const std::string& fileName)
{
  return EndsWith(fileName, ".exr");
}

MesoAOVs ReadAOVs(const std::string& fileName)
{
  const MesoExrImage image = MesoReadExr(fileName);
  try
  {
    return MesoAOVsOfImage(image);
  }
  catch (const MesoInputError& problem)
  {
    throw MesoInputError(fileName + ": " + problem.what());
  }
}

std::string CheckPng(const std::string& name)
{
  return EndsWith(name, ".png") ? "" : "'" + name + "' is no file name that ends in .png";
}
}

CommandCompare::CommandCompare(CLI::App& app)
{
  CLI::App* command =
    app.add_subcommand("compare", "Print the figures of error of a rendering against the truth.");
  command
    ->add_option("TRUTH", this->Truth,
      "Picture (PNG), or what its pixels know (EXR as render --aov all writes it)")
    ->required();
  command
    ->add_option("TEST", this->Test,
      "The same of what is to be judged. Two pictures x.png with x.aov.exr beside both are "
      "compared "
      "in everything")
    ->required();
  command->add_flag("--json", this->Json, "Print one JSON object; what is not known is null");
  command
    ->add_option("--difference", this->DifferenceFile,
      "PNG for the FLIP error of each pixel, from black (0) to pale yellow (1)")
    ->check(CheckPng);
  command
    ->add_option(
      "--classes", this->ClassesFile,
      "PNG for the class of each pixel: " +
        []
        {
          std::string text;
          for (int kind = 1; kind <= static_cast<int>(MesoPixelClass::Equal); ++kind)
          {
            text += std::string(kind > 1 ? ", " : "") +
              MesoNameOfClass(static_cast<MesoPixelClass>(kind));
          }
          return text;
        }())
    ->check(CheckPng);
  command->footer("Example: meso compare truth.png test.png --difference difference.png");
}

MesoImageError CommandCompare::Compare() const
{
  MesoRendering truth{ this->Truth, {}, {} };
  MesoRendering test{ this->Test, {}, {} };
  std::string truthAOVs = this->Truth;
  std::string testAOVs = this->Test;
  if (!IsExr(this->Truth))
  {
    truth.Picture = MesoReadPicture(this->Truth);
    test.Picture = MesoReadPicture(this->Test);
    truthAOVs = AOVFileName(this->Truth);
    testAOVs = AOVFileName(this->Test);
    const bool hasTruth = std::filesystem::exists(truthAOVs);
    const bool hasTest = std::filesystem::exists(testAOVs);
    if (!hasTruth || !hasTest)
    {
      const MesoImageError error = MesoCompareRenderings(truth, test);
      if (hasTruth != hasTest)
      {
        std::cerr << "meso: warning: there is no " << (hasTruth ? testAOVs : truthAOVs)
                  << ", so that pictures alone are compared\n";
      }
      return error;
    }
  }
  truth.AOVs = ReadAOVs(truthAOVs);
  test.AOVs = ReadAOVs(testAOVs);
  return MesoCompareRenderings(truth, test);
}

void CommandCompare::WritePictures(const MesoImageError& error) const
{
  const auto write = [](const std::string& fileName, vtkImageData* image)
  {
    const std::string bytes = PictureBytes(image);
    MesoAtomicFile::Write(fileName, bytes.data(), bytes.size());
  };
  if (!this->DifferenceFile.empty())
  {
    write(
      this->DifferenceFile, MesoPictureOfErrors(error.Picture->FlipMap, error.Width, error.Height));
  }
  if (!this->ClassesFile.empty())
  {
    write(
      this->ClassesFile, MesoPictureOfClasses(error.Geometry->Classes, error.Width, error.Height));
  }
}

int CommandCompare::Run()
{
  if (IsExr(this->Truth) != IsExr(this->Test))
  {
    throw CLI::ValidationError("TEST", "a picture and an EXR file cannot be compared");
  }
  if (IsExr(this->Truth) && !this->DifferenceFile.empty())
  {
    throw CLI::ValidationError("--difference", "needs two pictures, not EXR files");
  }
  CheckFileNames({ this->DifferenceFile, this->ClassesFile }, { this->Truth, this->Test });
  const MesoImageError error = this->Compare();
  if (!this->ClassesFile.empty() && !error.Geometry)
  {
    throw MesoInputError(this->ClassesFile + ": classes need " + AOVFileName(this->Truth) +
      " and " + AOVFileName(this->Test));
  }
  this->WritePictures(error);

  if (this->Json)
  {
    std::cout << JsonOfError(error).dump(2) << "\n";
    return 0;
  }
  for (const MesoFigure& figure : MesoFiguresOfError(error))
  {
    if (!std::isnan(figure.Value))
    {
      std::printf("%-20s %-12.6g %s\n", figure.Name.c_str(), figure.Value,
        figure.Unit == "1" ? "" : figure.Unit.c_str());
    }
  }
  return 0;
}
