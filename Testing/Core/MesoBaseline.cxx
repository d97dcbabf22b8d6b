#include "MesoBaseline.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"

#include <cstdlib>      // for std::getenv
#include <filesystem>   // for removing old pictures
#include <system_error> // for removing old pictures

namespace
{
bool UpdateAsked()
{
  const char* value = std::getenv("MESO_UPDATE_BASELINES");
  return value && std::string(value) == "1";
}

testing::AssertionResult Update(vtkImageData* image, const std::string& path)
{
  return MesoWritePNG(image, path)
    ? testing::AssertionSuccess() << "baseline written: " << path
    : testing::AssertionFailure() << "the baseline cannot be written: " << path;
}

testing::AssertionResult Written(
  testing::AssertionResult result, const char* what, vtkImageData* image, const std::string& path)
{
  const bool done = MesoWritePNG(image, path);
  return result << "\n  " << what << ": " << path << (done ? "" : " (cannot be written)");
}
}

testing::AssertionResult MesoCompareWithBaseline(vtkImageData* image, const std::string& name,
  const MesoImageLimits& limits, const MesoTestFolders& folders)
{
  const std::string baselinePath = folders.Baseline + "/" + name + ".png";
  const std::string imagePath = folders.Output + "/" + name + ".png";
  const std::string differencePath = folders.Output + "/" + name + ".diff.png";
  // What an earlier run left must not be taken for this run's.
  std::error_code error;
  std::filesystem::remove(imagePath, error);
  std::filesystem::remove(differencePath, error);

  if (!image)
  {
    return testing::AssertionFailure() << name << ": there is no image";
  }
  const auto baseline = MesoReadPNG(baselinePath);
  if (UpdateAsked())
  {
    return MesoCompareImages(image, baseline, MesoImageLimits::Exact()).Within
      ? testing::AssertionSuccess()
      : Update(image, baselinePath);
  }
  if (!baseline)
  {
    return Written(testing::AssertionFailure() << name << ": no baseline " << baselinePath
                                               << "; look at the image, then accept it with "
                                                  "MESO_UPDATE_BASELINES=1",
      "image", image, imagePath);
  }
  const MesoImageDifference difference = MesoCompareImages(image, baseline, limits);
  if (difference.Within)
  {
    return testing::AssertionSuccess() << name << ": " << difference.Describe();
  }
  auto result = testing::AssertionFailure()
    << name << ": " << difference.Describe() << "\n  baseline: " << baselinePath;
  result = Written(result, "image", image, imagePath);
  return difference.Problem.empty()
    ? Written(result, "difference x16", MesoDifferencePicture(image, baseline), differencePath)
    : result;
}

vtkSmartPointer<vtkImageData> MesoGrabWindow(vtkRenderWindow* window, bool alpha)
{
  window->Render();
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  const int last[] = { size[0] - 1, size[1] - 1 };
  const int got = alpha ? window->GetRGBACharPixelData(0, 0, last[0], last[1], 1, pixels)
                        : window->GetPixelData(0, 0, last[0], last[1], 1, pixels, 0);
  if (got != VTK_OK)
  {
    return nullptr;
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size[0], size[1], 1);
  image->GetPointData()->SetScalars(pixels);
  return image;
}
