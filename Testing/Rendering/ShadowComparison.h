#ifndef ShadowComparison_h
#define ShadowComparison_h

// A scene's shadows as its mappers draw them, beside those of the reference.

#include "MesoReference.h"
#include "MesoSceneBuilder.h"
#include "vtkMesoAOVPass.h"
#include "vtkMesoEGLRenderWindow.h"
#include "vtkMesoShadowMapPass.h"

#include "vtkImageData.h" // for the result
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

/// Pixels whose state of a light's shadow (threshold 0.5) is counted.
struct ShadowCount
{
  int Pixels = 0;  ///< of the object, in the truth and drawn
  int Both = 0;    ///< shadowed in both
  int Missing = 0; ///< in the truth alone
  int Extra = 0;   ///< drawn alone

  /// Intersection over union of the shadowed pixels.
  double Iou() const
  {
    return static_cast<double>(this->Both) / std::max(1, this->Both + this->Missing + this->Extra);
  }
};

/// A window with a scene.
class DrawnScene
{
public:
  DrawnScene(const MesoScene& scene, int width, int height)
  {
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(width, height);
    this->Window->AddRenderer(this->Renderer);
    this->Builder.Build(scene, this->Renderer);
    for (const auto& object : this->Builder.GetObjects())
    {
      this->Pass->SetObjectNumber(object.Actor, object.Number);
    }
  }

  ~DrawnScene()
  {
    this->Pass->ReleaseGraphicsResources(this->Window);
    if (this->Renderer->GetPass())
    {
      this->Renderer->GetPass()->ReleaseGraphicsResources(this->Window);
    }
  }

  /// The pass that the builder has set; null where the scene needs none.
  vtkMesoShadowMapPass* Shadows()
  {
    return vtkMesoShadowMapPass::SafeDownCast(this->Renderer->GetPass());
  }

  void Capture() { vtkMesoShadowMapPass::RenderThrough(this->Renderer, this->Pass); }

  std::vector<float> Channel(const std::string& name)
  {
    this->Capture();
    return this->Pass->GetChannel(name);
  }

  vtkNew<vtkMesoEGLRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  MesoSceneBuilder Builder;
  vtkNew<vtkMesoAOVPass> Pass;
};

inline MesoScene ShadowSceneOf(const std::string& rest)
{
  return MesoParseScene(R"({"meso": 1, )" + rest + "}", "test.json");
}

inline std::vector<float> ChannelOf(const MesoExrImage& image, const std::string& name)
{
  const auto place = std::find(image.ChannelNames.begin(), image.ChannelNames.end(), name);
  std::vector<float> values;
  for (std::size_t i = place - image.ChannelNames.begin();
       place != image.ChannelNames.end() && i < image.Data.size(); i += image.ChannelNames.size())
  {
    values.push_back(image.Data[i]);
  }
  return values;
}

/// The truth and what is drawn of a scene.
class ShadowComparison
{
public:
  ShadowComparison(const std::string& rest, int width, int height)
    : ShadowComparison(ShadowSceneOf(rest), ShadowSceneOf(rest), width, height)
  {
  }

  /// What is drawn may be another scene than the truth's.
  ShadowComparison(const MesoScene& truth, const MesoScene& drawn, int width, int height)
    : Truth(MesoReference(truth).Render(width, height))
    , Drawn(drawn, width, height)
  {
    this->Drawn.Capture();
  }

  ShadowCount Count(int object, int light = 0) const
  {
    const std::string shadow = "shadow." + std::to_string(light);
    const std::vector<float> truth = ChannelOf(this->Truth.AOVs, shadow);
    const std::vector<float> objects = ChannelOf(this->Truth.AOVs, "object");
    const std::vector<float> drawn = this->Drawn.Pass->GetChannel(shadow);
    const std::vector<float> drawnObjects = this->Drawn.Pass->GetChannel("object");
    ShadowCount count;
    EXPECT_EQ(truth.size(), drawn.size());
    for (std::size_t i = 0; i < truth.size() && i < drawn.size(); ++i)
    {
      if (objects[i] != float(object) || drawnObjects[i] != float(object))
      {
        continue;
      }
      ++count.Pixels;
      const bool isTrue = truth[i] > 0.5f;
      const bool isDrawn = drawn[i] > 0.5f;
      count.Both += isTrue && isDrawn ? 1 : 0;
      count.Missing += isTrue && !isDrawn ? 1 : 0;
      count.Extra += !isTrue && isDrawn ? 1 : 0;
    }
    return count;
  }

  MesoReferenceResult Truth;
  DrawnScene Drawn;
};

inline std::ostream& operator<<(std::ostream& stream, const ShadowCount& count)
{
  return stream << count.Pixels << " pixels, shadowed in both " << count.Both << ", missing "
                << count.Missing << ", extra " << count.Extra << ", IoU " << count.Iou();
}

#endif
