// Volumes drawn in shells, against the truth: more segments come nearer, no hole, open edges and overhangs
// right; and a height field as a volume is what relief draws of it.

#include "DrawnAOVs.h"
#include "MesoTestVolume.h"
#include "ReferenceWorld.h"

#include "MesoGeometryError.h"
#include "MesoTestScene.h"
#include "vtkMesoMovedMesh.h"
#include "vtkMesoPrismShell.h"
#include "vtkMesoReliefMapper.h"
#include "vtkMesoShellMapper.h"

namespace
{
constexpr int Size = 96;

MesoScene Scene(const std::string& mesh, const std::string& mesostructure,
  const std::string& camera = R"("position": [1, 2, 3.5])")
{
  return SceneOf(R"("camera": {)" + camera +
    R"(}, "lights": [{"type": "directional", "direction": [-0.3, -0.6, -1]}], "nodes": [{"mesh": )" +
    mesh + R"(, "mesostructure": {)" + mesostructure + "}}]");
}

MesoGeometryError ErrorOf(const MesoScene& scene)
{
  const MesoReference reference(scene);
  return MesoCompareGeometry(
    MesoAOVsOfImage(reference.Render(Size, Size).AOVs), DrawnAOVs(scene, Size, Size));
}
}

TEST(VolumesAgainstReference, MoreSegmentsComeNearer)
{
  // Coarse, so that a ray's way through a prism bends.
  const auto scene = [](int segments)
  {
    return Scene(R"({"shape": "torus", "rings": 24, "sides": 12})",
      R"("technique": "shell-sdf", "volume": {"pattern": "chain", "size": [48, 48, 24]}, "scale": 0.15,
        "tiles": [6, 3], "quality": "high", "segments": )" +
        std::to_string(segments));
  };
  double last = 1.;
  for (const int segments : { 1, 4, 16 })
  {
    const MesoGeometryError error = ErrorOf(scene(segments));
    std::cout << segments << " segments: depth p95 " << error.Depth.P95 << ", texel p95 "
              << error.Texcoord.P95 << ", normal " << error.Normal.Mean << ", iou "
              << error.CoverageIou << "\n";
    EXPECT_EQ(error.NanPixels, 0u);
    EXPECT_EQ(error.BoundaryPixels, 0u);
    EXPECT_LT(error.Depth.P95, 0.3 * last);
    last = error.Depth.P95;
    if (segments == 16)
    {
      EXPECT_GT(error.CoverageIou, 0.997);
      EXPECT_LT(error.Depth.P95, 2e-3);
      EXPECT_LT(error.Texcoord.P95, 0.1);
      EXPECT_LT(error.Normal.Mean, 0.6);
    }
  }
}

TEST(VolumesAgainstReference, InterpolatedExitsComeNearTheExactOnes)
{
  // The exit of a ray between vertices is not quite what theirs say, in a perspective and at concave fins.
  const auto scene = [](const char* exits, int rings)
  {
    return Scene(R"({"shape": "torus", "rings": )" + std::to_string(rings) + R"(, "sides": )" +
        std::to_string(rings / 2) + "}",
      std::string(
        R"("technique": "shell-sdf", "volume": {"pattern": "chain", "size": [48, 48, 24]}, "scale": 0.12,
        "tiles": [8, 4], "quality": "high", "exits": ")") +
        exits + "\"");
  };
  double lost[2];
  for (const int k : { 0, 1 })
  {
    const int rings = k == 0 ? 24 : 48;
    const MesoGeometryError exact = ErrorOf(scene("exact", rings));
    const MesoGeometryError interpolated = ErrorOf(scene("interpolated", rings));
    for (const MesoGeometryError* error : { &exact, &interpolated })
    {
      std::cout << rings << (error == &exact ? " exact" : " interpolated") << ": depth p95 "
                << error->Depth.P95 << ", texel p95 " << error->Texcoord.P95 << ", normal "
                << error->Normal.Mean << ", iou " << error->CoverageIou << ", holes "
                << error->HolePixels << "\n";
    }
    lost[k] = exact.CoverageIou - interpolated.CoverageIou;
    // Thin wires leave holes of their own.
    EXPECT_NEAR(double(exact.HolePixels), double(interpolated.HolePixels), 4.);
    EXPECT_GT(interpolated.CoverageIou, 0.95);
    EXPECT_LT(interpolated.Normal.Mean, 1.3 * exact.Normal.Mean);
    EXPECT_LT(interpolated.Depth.P95, 1.3 * exact.Depth.P95);
    EXPECT_NE(interpolated.Depth.P95, exact.Depth.P95);
  }
  EXPECT_LT(lost[1], 0.02);
}

TEST(VolumesAgainstReference, ClosedMatterHasNoHole)
{
  for (const char* shape : { "sphere", "vase" })
  {
    const MesoGeometryError error = ErrorOf(Scene(std::string(R"({"shape": ")") + shape + "\"}",
      R"("technique": "shell-sdf", "volume": {"pattern": "scales", "size": [32, 32, 16]},
        "scale": 0.1, "tiles": [8, 4], "segments": 2)"));
    EXPECT_EQ(error.HolePixels, 0u) << shape;
    EXPECT_GT(error.CoverageIou, 0.998) << shape;
    EXPECT_LT(error.Depth.P95, 0.02) << shape;
  }
}

TEST(VolumesAgainstReference, OpenEdgesAndOverhangsAreRight)
{
  // An undulating sheet, seen so that its edges and its underside are in view.
  const MesoGeometryError error = ErrorOf(Scene(R"({"shape": "undulating"})",
    R"("technique": "shell-sdf", "volume": {"pattern": "weave", "size": [32, 32, 16]},
      "scale": 0.1, "tiles": [3, 3], "quality": "high", "segments": 4)",
    R"("position": [2, -2.5, 0.6], "view_up": [0, 0, 1])"));
  EXPECT_EQ(error.BoundaryPixels, 0u);
  EXPECT_GT(error.BothPixels, 1000u);
  EXPECT_GT(error.CoverageIou, 0.995);
  EXPECT_LT(error.Depth.P95, 0.01);
  EXPECT_LT(error.Normal.Mean, 1.);
}

TEST(VolumesAgainstReference, LocalShadowsAreThoseOfThePlane)
{
  // On a flat base the straight way of light is no approximation. Without the map, which knows as much.
  const auto error = [](const char* shadow)
  {
    return ErrorOf(Scene(R"({"shape": "plane", "size": [2, 2]})",
      std::string(
        R"("technique": "shell-sdf", "volume": {"pattern": "weave", "size": [32, 32, 16]},
      "scale": 0.6, "tiles": [2, 2], "quality": "high", "effects": ["shading", "occlusion", "depth",
        "silhouette", "curvature", "open_boundary", "non_height_field")") +
        shadow + "]",
      R"("position": [0.5, -1.5, 2.5], "view_up": [0, 1, 0])"));
  };
  const MesoGeometryError with = error(R"(, "self_shadow")");
  const MesoGeometryError without = error("");
  std::cout << "wrong shadows: " << with.ShadowCast << ", without any: " << without.ShadowCast
            << "\n";
  EXPECT_GT(with.CoverageIou, 0.998);
  EXPECT_LT(with.ShadowCast, 0.1 * without.ShadowCast);
  EXPECT_GT(without.ShadowCast, 0.01);
}

TEST(VolumesAgainstReference, LightLeavesByTheEdges)
{
  // The side of a thick weave, under light from there: it comes in by the edge, and not through tiles that are not there.
  MesoScene scene = Scene(R"({"shape": "plane", "size": [2, 2]})",
    R"("technique": "shell-sdf", "volume": {"pattern": "weave", "size": [32, 32, 16]},
      "scale": 0.6, "tiles": [2, 2], "quality": "high", "effects": ["shading", "occlusion", "depth",
        "silhouette", "curvature", "open_boundary", "non_height_field", "self_shadow"])",
    R"("position": [1.2, -3.2, 0.9], "view_up": [0, 0, 1])");
  scene.Lights[0].Direction = { -0.3, 1., -0.1 };
  const MesoGeometryError error = ErrorOf(scene);
  std::cout << "wrong shadows: " << error.ShadowCast << "\n";
  EXPECT_GT(error.CoverageIou, 0.998);
  EXPECT_LT(error.ShadowCast, 0.01);
}

TEST(VolumesAgainstReference, ShadowsFromAfarAreInTheMap)
{
  // Through the gaps of a chain the inside of the torus is seen, which its other side shades.
  const auto scene = [](const char* effects)
  {
    return Scene(R"({"shape": "torus"})",
      std::string(
        R"("volume": {"pattern": "chain", "size": [48, 48, 24]}, "scale": 0.14, "tiles": [6, 3],
        "segments": 2, "technique": "shell-sdf")") +
        effects);
  };
  const MesoReference reference(scene(""));
  const MesoAOVs truth = MesoAOVsOfImage(reference.Render(Size, Size).AOVs);
  const auto error = [&](const char* effects)
  { return MesoCompareGeometry(truth, DrawnAOVs(scene(effects), Size, Size)).ShadowCast; };
  const double near = error(R"(, "effects": ["shading", "occlusion", "self_shadow", "depth",
    "silhouette", "curvature", "open_boundary", "non_height_field"])");
  const double all = error("");
  std::cout << "along the shell alone: " << near << ", with the map: " << all << "\n";
  EXPECT_GT(near, 0.12);
  EXPECT_LT(all, 0.4 * near);
}

TEST(VolumesAgainstReference, AHeightFieldIsWhatReliefDraws)
{
  constexpr int texels = 32;
  constexpr double thickness = 0.3;
  MesoTestScene scene(Size, Size);
  scene.AddDirectionalLight(0.4, 0.3, -1.);
  const auto heights = MesoTestScene::Pattern("smooth", texels, texels);
  auto* height = static_cast<float*>(heights->GetScalarPointer());
  for (int i = 0; i < texels * texels; ++i)
  {
    height[i] = 0.1f + 0.8f * height[i]; // between the volume's first and last slice
  }
  // Linear in z: its zeros are the bilinear heights. A quarter, lest steps pass the slopes.
  const auto volume = MesoTestVolume({ texels, texels, 16 }, 0.3,
    [&](double x, double y, double z)
    {
      const int i = static_cast<int>(x * texels);
      const int j = static_cast<int>(y * texels);
      return 0.25 * (z - 0.3 * height[j * texels + i]);
    });
  const auto plane = MesoTestScene::Shape("plane", { { "size", { 1., 1. } } });
  vtkNew<vtkMesoMovedMesh> moved;
  moved->SetInputData(plane);
  moved->SetDistance(thickness);
  moved->Update();
  vtkNew<vtkMesoReliefMapper> relief;
  MesoMesostructureOptions options;
  options.Technique = MesoTechnique::Relief;
  options.Quality = MesoQuality::Certified;
  options.Scale = thickness;
  relief->SetOptions(options);
  relief->SetHeightMap(heights);
  relief->SetInputData(moved->GetOutput());
  vtkNew<vtkMesoPrismShell> prisms;
  prisms->SetInputData(plane);
  prisms->SetThickness(thickness);
  prisms->Update();
  vtkNew<vtkMesoShellMapper> shell;
  options.Technique = MesoTechnique::ShellSDF;
  options.Quality = MesoQuality::High;
  shell->SetOptions(options);
  shell->SetVolume(volume);
  shell->SetInputData(prisms->GetOutput());
  scene.LookFrom(0.3, -0.4, 1.6);
  vtkNew<vtkMesoAOVPass> pass;
  std::vector<std::vector<float>> seen;
  for (vtkMesoPolyDataMapper* mapper :
    { static_cast<vtkMesoPolyDataMapper*>(relief), static_cast<vtkMesoPolyDataMapper*>(shell) })
  {
    scene.Actor->SetMapper(mapper);
    scene.Renderer->SetPass(pass);
    scene.Window->Render();
    scene.Renderer->SetPass(nullptr);
    seen.push_back(pass->GetInterleaved(
      { "coverage", "depth", "texcoord.u", "relief", "normal.x", "shadow.0" }));
  }
  int both = 0;
  int shadows = 0;
  for (std::size_t i = 0; i < seen[0].size(); i += 6)
  {
    // Past the plane's border relief goes on, the volume does not.
    const bool inside = seen[0][i] > 0.f && seen[0][i + 2] > 0.02f && seen[0][i + 2] < 0.98f;
    if (inside && seen[1][i] > 0.f && std::abs(seen[0][i + 1] - seen[1][i + 1]) < 0.01)
    {
      ++both;
      EXPECT_NEAR(seen[0][i + 1], seen[1][i + 1], 1e-3);
      EXPECT_NEAR(seen[0][i + 2], seen[1][i + 2], 2e-3);
      EXPECT_NEAR(seen[0][i + 3], seen[1][i + 3], 4e-3);
      EXPECT_NEAR(seen[0][i + 4], seen[1][i + 4], 0.02);
      shadows += seen[0][i + 5] == seen[1][i + 5] ? 0 : 1;
    }
  }
  EXPECT_GT(both, 1000);
  EXPECT_LT(shadows, both / 50);
  pass->ReleaseGraphicsResources(scene.Window);
}
