// Colours in texture space: what is drawn of them is what the reference sees, in every technique that draws
// volumes; and what is no volume of colours is refused.

#include "ReferenceWorld.h"
#include "TemporaryFolder.h"
#include "TinyTiff.h"

#include "MesoMessage.h"
#include "MesoSceneBuilder.h"
#include "vtkMesoEGLRenderWindow.h"

#include "vtkImageData.h"
#include "vtkRenderer.h"
#include "vtkWindowToImageFilter.h"

#include <cmath>
#include <sstream>

namespace
{
constexpr int Size = 96;

/// Of 8 x 4 x 4: red grows along x and back, green is below, blue above.
std::array<int, 3> ColorAt(int x, int z)
{
  return { 255 * std::min(x, 7 - x) / 3, z < 2 ? 220 : 20, z < 2 ? 40 : 255 };
}

/// A file of them.
std::string ColorFile(const TemporaryFolder& folder, int components = 3)
{
  std::ostringstream text;
  text << R"(<VTKFile type="ImageData" version="1.0"><ImageData WholeExtent="0 7 0 3 0 3" )"
       << R"(Origin="0 0 0" Spacing="1 1 1"><Piece Extent="0 7 0 3 0 3"><PointData Scalars="c">)"
       << R"(<DataArray type="UInt8" Name="c" NumberOfComponents=")" << components
       << R"(" format="ascii">)";
  for (int i = 0; i < 8 * 4 * 4; ++i)
  {
    const std::array<int, 3> color = ColorAt(i % 8, i / 32);
    for (int k = 0; k < components; ++k)
    {
      text << color[k] << " ";
    }
  }
  text << "</DataArray></PointData></Piece></ImageData></VTKFile>";
  return folder.Write("colors.vti", text.str());
}

MesoScene SceneWith(const std::string& technique, const std::string& more)
{
  return SceneOf(R"("camera": {"position": [0.3, -1.2, 2.2]},
    "lights": [{"type": "directional", "direction": [0.3, 0.4, -1]}],
    "nodes": [{"mesh": {"shape": "plane", "size": [2, 2], "segments": [2, 2]},
      "material": {"color": [0.9, 0.9, 0.9], "ambient": 0.2, "specular": 0.3},
      "mesostructure": {"technique": ")" +
    technique + R"(", "scale": 0.2, "tiles": [2, 2], "quality": "high",
      "volume": {"pattern": "weave", "size": [32, 32, 16]})" +
    more + "}}]");
}

vtkSmartPointer<vtkImageData> Drawn(const MesoScene& scene)
{
  vtkNew<vtkMesoEGLRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(Size, Size);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  MesoSceneBuilder builder;
  builder.Build(scene, renderer);
  window->Render();
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  picture->Update();
  return picture->GetOutput();
}

/// Mean difference of two pictures' channels, and the part of the pixels that differ by more than 24.
std::array<double, 2> Difference(vtkImageData* one, vtkImageData* two)
{
  const auto* a = static_cast<unsigned char*>(one->GetScalarPointer());
  const auto* b = static_cast<unsigned char*>(two->GetScalarPointer());
  double sum = 0.;
  int off = 0;
  for (int i = 0; i < 3 * Size * Size; ++i)
  {
    sum += std::abs(a[i] - b[i]);
    off += std::abs(a[i] - b[i]) > 24 ? 1 : 0;
  }
  return { sum / (3. * Size * Size), off / (3. * Size * Size) };
}
}

TEST(VolumeColors, AreThoseOfTheReference)
{
  const TemporaryFolder folder;
  const std::string colors = R"(, "volume_colors": ")" + ColorFile(folder) + "\"";
  const MesoReference reference(SceneWith("shell-sdf", colors));
  const auto truth = reference.Render(Size, Size).Picture;
  const MesoReference grey(SceneWith("shell-sdf", ""));
  EXPECT_GT(Difference(truth, grey.Render(Size, Size).Picture)[0], 15.);
  // Mean differences allowed: a table errs, and slices are steps.
  const std::pair<const char*, double> techniques[] = { { "shell-sdf", 0.8 }, { "gdm", 4. },
    { "slices", 6. } };
  for (const auto& [technique, limit] : techniques)
  {
    const auto difference = Difference(truth, Drawn(SceneWith(technique, colors)));
    std::cout << technique << ": " << difference[0] << ", off " << difference[1] << "\n";
    EXPECT_LT(difference[0], limit) << technique;
  }
  EXPECT_LT(Difference(truth, Drawn(SceneWith("shell-sdf", colors)))[1], 0.01);
}

TEST(VolumeColors, MayBeAStackOfImages)
{
  // The same numbers as an image for each slice, each from its last row up.
  const TemporaryFolder folder;
  std::vector<TinyTiffImage> images;
  for (int z = 0; z < 4; ++z)
  {
    TinyTiffImage image = { 8, 4, 3, "" };
    for (int i = 0; i < 8 * 4; ++i)
    {
      for (const int number : ColorAt(i % 8, z))
      {
        image.Numbers.push_back(static_cast<char>(number));
      }
    }
    images.push_back(image);
  }
  const std::string stack = folder.Write("colors.tif", TinyTiff(images));
  const auto drawn = [](const std::string& file)
  { return Drawn(SceneWith("shell-sdf", R"(, "volume_colors": ")" + file + "\"")); };
  EXPECT_EQ(Difference(drawn(stack), drawn(ColorFile(folder)))[0], 0.);
}

TEST(VolumeColors, OfOneNumberAreNone)
{
  const TemporaryFolder folder;
  const std::string file = ColorFile(folder, 1);
  for (const std::string& name : { file, folder.PathOf("missing.vti") })
  {
    try
    {
      Drawn(SceneWith("shell-sdf", R"(, "volume_colors": ")" + name + "\""));
      ADD_FAILURE() << name;
    }
    catch (const MesoInputError& problem)
    {
      const std::string text = problem.what();
      EXPECT_NE(text.find("volume_colors: " + name + ": "), std::string::npos) << text;
      EXPECT_EQ(text.find("three numbers") != std::string::npos, name == file) << text;
    }
  }
}
