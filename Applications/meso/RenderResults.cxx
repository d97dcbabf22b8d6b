#include "RenderResults.h"

#include "FiguresJson.h"
#include "MesoFrameCost.h"
#include "MesoRadicalInverse.h"
#include "MesoSceneBuilder.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkLightCollection.h"
#include "vtkMesoAOVPass.h"
#include "vtkMesoEGLRenderWindow.h"
#include "vtkMesoPolyDataMapper.h"
#include "vtkMesoShadowMapPass.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace
{
/// The picture that the window holds, RGB, row 0 at the bottom.
void ReadPixels(vtkMesoEGLRenderWindow* window, vtkUnsignedCharArray* pixels)
{
  const int* size = window->GetSize();
  vtkRenderWindow* reader = window; // whose overloads the window hides
  if (reader->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels) == VTK_ERROR)
  {
    throw MesoInputError("the picture could not be read back from the device");
  }
}

/// The value itself where all objects agree, else a list of the different ones.
nlohmann::json OneOrList(const std::set<std::string>& values)
{
  return values.size() == 1 ? nlohmann::json(*values.begin()) : nlohmann::json(values);
}
}

vtkSmartPointer<vtkImageData> RenderPicture(vtkMesoEGLRenderWindow* window, vtkRenderer* renderer,
  int samples, const std::function<void(double)>& progress)
{
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  std::vector<double> sum;
  for (int sample = 0; sample < samples; ++sample)
  {
    // One sample lies at the pixel's centre; several spread over the pixel.
    const double x = samples == 1 ? 0. : MesoRadicalInverse(sample + 1, 2) - 0.5;
    const double y = samples == 1 ? 0. : MesoRadicalInverse(sample + 1, 3) - 0.5;
    renderer->GetActiveCamera()->SetWindowCenter(2. * x / size[0], 2. * y / size[1]);
    window->Render();
    ReadPixels(window, pixels);
    sum.resize(pixels->GetNumberOfValues(), 0.);
    for (vtkIdType i = 0; i < pixels->GetNumberOfValues(); ++i)
    {
      sum[i] += pixels->GetValue(i);
    }
    progress((sample + 1.) / samples);
  }
  renderer->GetActiveCamera()->SetWindowCenter(0., 0.);

  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size[0], size[1], 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* out = static_cast<unsigned char*>(image->GetScalarPointer());
  for (std::size_t i = 0; i < sum.size(); ++i)
  {
    out[i] = static_cast<unsigned char>(std::lround(sum[i] / samples));
  }
  return image;
}

void CaptureAOVs(vtkRenderer* renderer, const MesoSceneBuilder& builder, vtkMesoAOVPass* pass)
{
  for (const auto& object : builder.GetObjects())
  {
    if (object.Actor->HasTranslucentPolygonalGeometry())
    {
      throw MesoInputError("what each pixel knows (AOVs, fetches of the stats) of translucent "
                           "objects is not available yet (node " +
        std::to_string(object.Number) + " '" + object.Name + "')");
    }
    pass->SetObjectNumber(object.Actor, object.Number);
  }
  const int lights = renderer->GetLights()->GetNumberOfItems();
  if (lights > vtkMesoAOVPass::MostLights)
  {
    throw MesoInputError("what each pixel knows (AOVs, fetches of the stats) holds the shadows of "
                         "at most " +
      std::to_string(vtkMesoAOVPass::MostLights) + " lights; the scene has " +
      std::to_string(lights));
  }
  vtkMesoShadowMapPass::RenderThrough(renderer, pass);
  if (pass->GetInterleaved({ "coverage" }).empty())
  {
    throw MesoInputError("the AOVs could not be rendered");
  }
}

PixelCounts CountsOfChannel(const vtkMesoAOVPass* pass, const std::string& channel)
{
  PixelCounts counts;
  const std::vector<float> pixels = pass->GetInterleaved({ "coverage", channel });
  for (std::size_t i = 0; i < pixels.size(); i += 2)
  {
    counts.Covered += pixels[i];
    counts.Mean += pixels[i + 1];
    counts.Maximum = std::max(counts.Maximum, static_cast<double>(pixels[i + 1]));
  }
  counts.Mean = counts.Covered > 0. ? counts.Mean / counts.Covered : 0.;
  return counts;
}

SceneSize SizeOfScene(const MesoSceneBuilder& builder)
{
  SceneSize size;
  for (const auto& object : builder.GetObjects())
  {
    size.GpuBytes += object.Mapper->GetGPUBytes();
    size.Triangles += object.Mapper->GetNumberOfTrianglesDrawn();
  }
  return size;
}

void WriteAOVs(const vtkMesoAOVPass* pass, const std::vector<std::string>& channels,
  const MesoExrAttributes& attributes, const std::string& fileName)
{
  MesoWriteExr(fileName, pass->GetWidth(), pass->GetHeight(), channels,
    pass->GetInterleaved(channels).data(), attributes);
}

std::string MeasureStats(vtkMesoEGLRenderWindow* window, const MesoSceneBuilder& builder,
  const vtkMesoAOVPass* pass, double prepareSeconds)
{
  std::vector<vtkProp*> props;
  std::set<std::string> techniques;
  std::set<std::string> qualities;
  std::set<std::string> effects;
  for (const auto& object : builder.GetObjects())
  {
    props.push_back(object.Actor);
  }
  const MesoFrameCost cost = MesoMeasureFrames(window, { props }).front();
  for (const auto& object : builder.GetObjects())
  {
    techniques.insert(MesoName(object.Options.Technique));
    qualities.insert(MesoName(object.Options.Quality));
    for (const std::string& name : object.Mapper->GetEffectsDrawn().Names())
    {
      effects.insert(name);
    }
  }
  const SceneSize size = SizeOfScene(builder);
  const PixelCounts fetches = CountsOfChannel(pass, "fetches");

  nlohmann::ordered_json stats;
  stats["technique"] = OneOrList(techniques);
  stats["quality"] = OneOrList(qualities);
  stats["effects"] = effects;
  stats["size"] = { pass->GetWidth(), pass->GetHeight() };
  stats["gpu_ms"] = JsonOfMilliseconds(cost.Gpu);
  stats["frame_ms"] = JsonOfMilliseconds(cost.Frame);
  stats["clock"] = cost.Clock;
  stats["runs"] = cost.Runs;
  stats["covered_pixels"] = static_cast<long long>(fetches.Covered);
  stats["fetches_mean"] = fetches.Mean;
  stats["fetches_max"] = fetches.Maximum;
  stats["gpu_bytes"] = size.GpuBytes;
  stats["prepare_s"] = prepareSeconds;
  stats["triangles"] = size.Triangles;
  stats["device"] = window->GetGLRenderer();
  stats["version"] = MESO_VERSION;
  return stats.dump(2) + "\n";
}
