// Mesostructure of volumes in shells: each pixel's hit where closed forms say, no hole and no second
// hit on closed meshes, the same picture in any order of prisms, eyes inside the shell, open edges.

#include "MesoAOVChecks.h"
#include "MesoExpectedMessages.h"
#include "MesoTestVolume.h"

#include "vtkMesoGDMTable.h"
#include "vtkMesoPrismShell.h"
#include "vtkMesoShellMapper.h"

#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkTransform.h"

#include <numeric>
#include <random>

namespace
{
class ShellMapper : public testing::Test
{
protected:
  MesoTestScene Scene{ 120, 120 };
  vtkNew<vtkMesoShellMapper> Mapper;
  vtkNew<vtkMesoAOVPass> Pass;
  MesoMesostructureOptions Options;

  ShellMapper()
  {
    this->Scene.Actor->SetMapper(this->Mapper);
    this->Scene.AddDirectionalLight(0.3, -0.5, -1.);
    this->Options.Technique = MesoTechnique::ShellSDF;
  }

  ~ShellMapper() override { this->Pass->ReleaseGraphicsResources(this->Scene.Window); }

  void Use(vtkPolyData* mesh, vtkImageData* volume, double thickness, double tilesU = 1.,
    double tilesV = 1.)
  {
    vtkNew<vtkMesoPrismShell> shell;
    shell->SetInputData(mesh);
    shell->SetThickness(thickness);
    shell->SetTiles(tilesU, tilesV);
    shell->SetInnerFins(this->Options.Exits == MesoExits::Interpolated);
    shell->Update();
    this->Options.Scale = thickness;
    this->Options.Tiles = { tilesU, tilesV };
    this->Mapper->SetOptions(this->Options);
    this->Mapper->SetVolume(volume);
    this->Mapper->SetInputData(shell->GetOutput());
  }

  int Check()
  {
    MesoCapture(this->Scene, this->Pass);
    return MesoCheckEveryPixel(this->Pass);
  }

  float Value(const char* channel, int column, int row) const
  {
    return this->Pass->GetValue(channel, column, row);
  }

  /// From within matter, 0.3 thick on a plane: all is covered, at the near plane, and faces the eye.
  void LookOutOfMatter()
  {
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->SetPosition(0.1, -0.2, 0.1);
    camera->SetFocalPoint(0.1, 1., 0.1);
    camera->SetViewUp(0., 0., 1.);
    camera->SetClippingRange(0.01, 50.);
    EXPECT_EQ(this->Check(), 120 * 120);
    EXPECT_NEAR(this->Value("depth", 60, 60), 0.01, 1e-4);
    EXPECT_NEAR(this->Value("normal.y", 60, 60), -1., 1e-3);
  }

  /// Pixels that are not covered, with eight neighbours that are.
  int Holes() const
  {
    int holes = 0;
    for (int row = 1; row + 1 < this->Pass->GetHeight(); ++row)
    {
      for (int column = 1; column + 1 < this->Pass->GetWidth(); ++column)
      {
        int covered = 0;
        for (int k = 0; k < 9; ++k)
        {
          covered += this->Value("coverage", column + k % 3 - 1, row + k / 3 - 1) > 0.f ? 1 : 0;
        }
        holes += covered == 8 && this->Value("coverage", column, row) == 0.f ? 1 : 0;
      }
    }
    return holes;
  }

  std::vector<float> Numbers() const
  {
    return this->Pass->GetInterleaved(this->Pass->GetChannelNames());
  }
};

/// The prisms of a shell in another order: their faces are drawn in it.
vtkSmartPointer<vtkPolyData> Shuffled(vtkPolyData* shell)
{
  std::vector<vtkIdType> order(shell->GetNumberOfPolys());
  std::iota(order.begin(), order.end(), vtkIdType(0));
  std::shuffle(order.begin(), order.end(), std::mt19937(7));
  vtkNew<vtkCellArray> faces;
  for (vtkIdType cell : order)
  {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    shell->GetPolys()->GetCellAtId(cell, count, points);
    faces->InsertNextCell(count, points);
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(shell);
  result->SetPolys(faces);
  return result;
}
}

TEST_F(ShellMapper, HitsOfASlabAreExact)
{
  // Matter up to z = 0.4 of a shell of thickness 0.5 over the plane z = 0: its top is at 0.2.
  this->Use(MesoTestScene::Shape("plane", { { "segments", { 3., 3. } }, { "size", { 4., 4. } } }),
    MesoTestSlab(0.4), 0.5, 3., 3.);
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  this->Scene.LookFrom(1.5, -1., 2.5);
  this->Check();
  int inside = 0;
  for (int row = 0; row < 120; row += 3)
  {
    for (int column = 0; column < 120; column += 3)
    {
      // The pixel's ray.
      const double half = std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
      const double x = (2. * (column + 0.5) / 120. - 1.) * half;
      const double y = (1. - 2. * (row + 0.5) / 120.) * half;
      double eye[3];
      double forward[3];
      double right[3];
      double up[3];
      camera->GetPosition(eye);
      camera->GetDirectionOfProjection(forward);
      vtkMath::Cross(forward, camera->GetViewUp(), right);
      vtkMath::Normalize(right);
      vtkMath::Cross(right, forward, up);
      double ray[3];
      for (int k = 0; k < 3; ++k)
      {
        ray[k] = forward[k] + x * right[k] + y * up[k];
      }
      const double depth = (0.2 - eye[2]) / ray[2];
      const double place[2] = { eye[0] + depth * ray[0], eye[1] + depth * ray[1] };
      if (std::max(std::abs(place[0]), std::abs(place[1])) > 1.95)
      {
        continue;
      }
      ++inside;
      ASSERT_EQ(this->Value("coverage", column, row), 1.f);
      EXPECT_NEAR(this->Value("depth", column, row), depth, 2e-5);
      EXPECT_NEAR(this->Value("texcoord.u", column, row), 3. * (place[0] / 4. + 0.5), 2e-5);
      EXPECT_NEAR(this->Value("texcoord.v", column, row), 3. * (place[1] / 4. + 0.5), 2e-5);
      EXPECT_NEAR(this->Value("relief", column, row), 0.6, 2e-5);
      EXPECT_NEAR(this->Value("normal.z", column, row), 1., 1e-5);
      EXPECT_EQ(this->Value("shadow.0", column, row), 0.f);
    }
  }
  EXPECT_GT(inside, 500);
}

TEST_F(ShellMapper, ClosedMeshesHaveNoHole)
{
  for (const char* shape : { "torus", "sphere", "vase" })
  {
    this->Use(MesoTestScene::Shape(shape), MesoTestSlab(0.5), 0.1, 4., 4.);
    for (const double angle : { 0.1, 0.7, 1.3, 2.2 })
    {
      this->Scene.LookFrom(4. * std::cos(angle), 2., 4. * std::sin(angle));
      EXPECT_GT(this->Check(), 1000) << shape;
      EXPECT_EQ(this->Holes(), 0) << shape << " " << angle;
    }
  }
}

TEST_F(ShellMapper, MatterOfTheWholeShellIsItsOutside)
{
  // Full to the top: every ray meets matter where it comes in, and shows the cut's normal.
  this->Use(MesoTestScene::Shape("sphere"), MesoTestSlab(2.), 0.25);
  this->Scene.LookFrom(0., 0., 5.);
  EXPECT_GT(this->Check(), 1000);
  EXPECT_EQ(this->Holes(), 0);
  EXPECT_NEAR(this->Value("depth", 60, 60), 5. - 1.25, 5e-3);
  EXPECT_NEAR(this->Value("relief", 60, 60), 0., 1e-5);
  EXPECT_GT(this->Value("normal.z", 60, 60), 0.99);
  // Empty: nothing.
  this->Mapper->SetVolume(MesoTestSlab(-1.));
  EXPECT_EQ(this->Check(), 0);
}

TEST_F(ShellMapper, CutsByTheTopAreWhole)
{
  // Walls along y that the top cuts: what is seen of them at the top has the top's normal, over each edge of the
  // mesh as well, and no light is blocked there.
  const auto walls = MesoTestVolume(
    { 32, 8, 16 }, 0.5, [](double x, double, double) { return std::abs(x - 0.5) - 0.35; });
  for (int turn = 0; turn < 16; ++turn)
  {
    this->Options.Exits = turn < 8 ? MesoExits::Exact : MesoExits::Interpolated;
    this->Use(MesoTestScene::Shape("plane", { { "segments", { 9., 7. } }, { "size", { 3., 3. } } }),
      walls, 0.4, 3., 3.);
    int cuts = 0;
    const double angle = 0.7853981633974483 * turn;
    this->Scene.LookFrom(2. * std::cos(angle), 2. * std::sin(angle), 2.5);
    this->Check();
    for (int pixel = 0; pixel < 120 * 120; ++pixel)
    {
      const int column = pixel % 120;
      const int row = pixel / 120;
      const double across = this->Value("texcoord.u", column, row);
      const double inWall = 0.34 - std::abs(across - std::floor(across) - 0.5);
      if (this->Value("coverage", column, row) > 0.f && inWall > 0. &&
        this->Value("relief", column, row) < 1e-5f)
      {
        ++cuts;
        EXPECT_NEAR(this->Value("normal.z", column, row), 1., 1e-4)
          << turn << " " << column << " " << row;
        EXPECT_EQ(this->Value("shadow.0", column, row), 0.f);
      }
    }
    EXPECT_GT(cuts, 1000) << turn;
  }
}

TEST_F(ShellMapper, AnyOrderOfPrismsGivesTheSamePicture)
{
  this->Use(MesoTestScene::Shape("torus"), MesoTestBars(), 0.2, 10., 4.);
  this->Scene.LookFrom(1., 2., 3.5);
  EXPECT_GT(this->Check(), 1000);
  const std::vector<float> numbers = this->Numbers();
  this->Mapper->SetInputData(Shuffled(this->Mapper->GetInput()));
  this->Check();
  EXPECT_EQ(this->Numbers(), numbers);
}

TEST_F(ShellMapper, AnEyeInTheShellSeesWhatIsBeforeIt)
{
  for (const MesoExits exits : { MesoExits::Exact, MesoExits::Interpolated })
  {
    this->Options.Exits = exits;
    // The shell is 1 thick, matter fills 0.3 of it, and the eye is at 0.6 over the middle.
    this->Use(MesoTestScene::Shape("plane", { { "segments", { 4., 4. } }, { "size", { 8., 8. } } }),
      MesoTestSlab(0.3), 1., 8., 8.);
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    for (const double near : { 0.01, 0.2 })
    {
      camera->ParallelProjectionOff();
      camera->SetPosition(0.1, -0.2, 0.6);
      camera->SetFocalPoint(0.1, 1., 0.);
      camera->SetViewUp(0., 0., 1.);
      camera->SetClippingRange(near, 50.);
      EXPECT_EQ(this->Check(), 120 * 120) << near;
      if (exits == MesoExits::Exact) // corners behind the eye say nothing of the rays between them
      {
        // Straight ahead: down by 0.3 on a way that falls by 0.6 in sqrt(1.2^2 + 0.6^2).
        EXPECT_NEAR(0.5 * (this->Value("depth", 60, 59) + this->Value("depth", 59, 60)),
          0.5 * std::hypot(1.2, 0.6), 0.02);
        EXPECT_NEAR(this->Value("relief", 60, 60), 0.7, 1e-4);
      }
    }
    // In matter all is covered, at the near plane.
    this->LookOutOfMatter();
    // Backs of faces that lie before the near plane have nothing to say.
    camera->SetPosition(0.1, -0.2, 0.6);
    camera->SetFocalPoint(0.1, 1., 0.6);
    camera->SetClippingRange(0.01, 50.);
    this->Check();
    EXPECT_EQ(this->Value("coverage", 60, 10), 0.f);
    // Parallel views are cut by the near plane likewise.
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.5);
    camera->SetPosition(0., 0., 0.6);
    camera->SetFocalPoint(0., 0., 0.);
    camera->SetViewUp(0., 1., 0.);
    camera->SetClippingRange(0.1, 50.);
    EXPECT_EQ(this->Check(), 120 * 120);
    EXPECT_NEAR(this->Value("depth", 60, 60), 0.3, 1e-4);
  }
}

TEST_F(ShellMapper, AnOpenEdgeShowsTheCut)
{
  this->Scene.Renderer->RemoveAllLights();
  this->Scene.AddDirectionalLight(0.2, 1., -0.2);
  for (const MesoExits exits : { MesoExits::Exact, MesoExits::Interpolated })
  {
    this->Options.Exits = exits;
    // A plane of size 2 seen from its side, at the height of the shell: its fin at y = -1 shows matter up
    // to 0.4 of 0.5, cut.
    this->Use(MesoTestScene::Shape("plane", { { "segments", { 4., 4. } }, { "size", { 2., 2. } } }),
      MesoTestSlab(0.8), 0.5);
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->SetPosition(0., -5., 0.25);
    camera->SetFocalPoint(0., 0., 0.25);
    camera->SetViewUp(0., 0., 1.);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.2);
    camera->SetClippingRange(0.1, 20.);
    EXPECT_NEAR(this->Check(), 100 * 20, 2 * 120);
    EXPECT_NEAR(this->Value("depth", 60, 60), 4., 1e-4);
    EXPECT_NEAR(this->Value("normal.y", 60, 60), -1., 1e-4);
    EXPECT_NEAR(this->Value("relief", 60, 60), 0.5, 0.03);
    EXPECT_EQ(this->Value("shadow.0", 60, 60), 0.f); // the light comes in by the cut
  }
}

TEST_F(ShellMapper, MirroredAndMovedNodesShowTheSame)
{
  this->Use(MesoTestScene::Shape("torus"), MesoTestBars(), 0.2, 10., 4.);
  this->Scene.LookFrom(0., 1.5, 4.);
  const int covered = this->Check();
  const std::vector<float> numbers = this->Numbers();
  // A mirror in x turns winding; vtkReverseSense is the scene builder's work, here the corners' order.
  vtkNew<vtkTransform> far;
  far->Translate(2000., 1000., -500.);
  this->Scene.Actor->SetUserTransform(far);
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  camera->SetPosition(2000., 1001.5, -496.);
  camera->SetFocalPoint(2000., 1000., -500.);
  this->Scene.Renderer->ResetCameraClippingRange();
  EXPECT_NEAR(this->Check(), covered, covered / 100);
  EXPECT_LT(this->Holes(), covered / 100);
}

TEST_F(ShellMapper, LightIsBlockedByMatterAbove)
{
  // Light from straight above; a bar along y, over one along x, shades it.
  this->Scene.Renderer->RemoveAllLights();
  this->Scene.AddDirectionalLight(0., 0., -1.);
  this->Use(MesoTestScene::Shape("plane", { { "size", { 2., 2. } } }), MesoTestBars(), 1.);
  // From aside, so that the part of the lower bar below the upper one is seen.
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  camera->SetPosition(-3., -1., 2.);
  camera->SetFocalPoint(0., 0., 0.3);
  camera->SetViewUp(0., 0., 1.);
  this->Scene.Renderer->ResetCameraClippingRange();
  this->Check();
  int shaded = 0;
  int lit = 0;
  for (int row = 0; row < 120; ++row)
  {
    for (int column = 0; column < 120; ++column)
    {
      const double z = 1. - this->Value("relief", column, row);
      const bool low = this->Value("coverage", column, row) > 0.f && z < 0.5 &&
        this->Value("normal.z", column, row) > 0.2f;
      if (low)
      {
        // The upper bar is above u in [0.4, 0.6].
        const double u = this->Value("texcoord.u", column, row);
        const bool below = std::abs(u - 0.5) < 0.09;
        if (below || std::abs(u - 0.5) > 0.11)
        {
          EXPECT_EQ(this->Value("shadow.0", column, row), below ? 1.f : 0.f) << u << " " << z;
          ++(below ? shaded : lit);
        }
      }
    }
  }
  EXPECT_GT(shaded, 20);
  EXPECT_GT(lit, 100);
  // Without the effect only what turns away is dark.
  this->Options.Effects.Auto = false;
  this->Options.Effects.Named =
    MesoEffectsOfTechnique(MesoTechnique::ShellSDF).Without({ MesoEffect::SelfShadow });
  this->Mapper->SetOptions(this->Options);
  this->Check();
  int dark = 0;
  for (int pixel = 0; pixel < 120 * 120; ++pixel)
  {
    const bool up = this->Value("normal.z", pixel % 120, pixel / 120) > 0.4;
    const bool blocked = this->Value("shadow.0", pixel % 120, pixel / 120) > 0.f;
    dark += up && blocked ? 1 : 0; // where the two bars meet, a facet's normal may be any
  }
  EXPECT_LT(dark, 5);
}

TEST_F(ShellMapper, SlicesOfASlabAreOnTheirHeights)
{
  // Matter up to 0.4 of 0.5: of 8 slices the third, at 2.5/8, is the highest in it.
  this->Use(MesoTestScene::Shape("plane", { { "size", { 4., 4. } } }), MesoTestSlab(0.4), 0.5);
  vtkNew<vtkMesoPrismShell> slices;
  slices->SetInputData(MesoTestScene::Shape("plane", { { "size", { 4., 4. } } }));
  slices->SetThickness(0.5);
  slices->SetSlices(8);
  slices->Update();
  this->Options.Technique = MesoTechnique::Slices;
  this->Mapper->SetOptions(this->Options);
  this->Mapper->SetInputData(slices->GetOutput());
  this->Scene.LookFrom(0., 0., 5.);
  EXPECT_EQ(this->Check(), 120 * 120);
  EXPECT_NEAR(this->Value("depth", 60, 60), 5. - 0.5 * 2.5 / 8., 1e-4);
  EXPECT_NEAR(this->Value("relief", 60, 60), 1. - 2.5 / 8., 1e-5);
  EXPECT_NEAR(this->Value("normal.z", 60, 60), 1., 1e-5);
  EXPECT_EQ(this->Value("shadow.0", 60, 60), 0.f); // the slab above a slice is no shade
  // From below the lowest slice is seen, from its back.
  this->Scene.LookFrom(0., 0., -5.);
  EXPECT_EQ(this->Check(), 120 * 120);
  EXPECT_NEAR(this->Value("depth", 60, 60), 5. + 0.5 * 0.5 / 8., 1e-4);
}

TEST_F(ShellMapper, SlicesOnScreenShowMatterThatTheNearPlaneCuts)
{
  this->Options.Technique = MesoTechnique::Slices;
  this->Options.Stack = MesoStack::Screen;
  this->Use(MesoTestScene::Shape("plane", { { "segments", { 4., 4. } }, { "size", { 8., 8. } } }),
    MesoTestSlab(0.3), 1., 8., 8.);
  this->LookOutOfMatter();
}

TEST_F(ShellMapper, ATableMeetsWhatTheDistanceMeets)
{
  // Thick bars, of which a table of 16 factors knows most; against shell-sdf.
  const auto bars = MesoTestVolume({ 24, 24, 12 }, 0.5,
    [](double, double y, double z) { return std::hypot(y - 0.5, z - 0.25) - 0.2; });
  const auto plane =
    MesoTestScene::Shape("plane", { { "segments", { 2., 2. } }, { "size", { 2., 2. } } });
  this->Use(plane, bars, 1., 2., 2.);
  this->Scene.LookFrom(0.6, -1.2, 3.);
  const int covered = this->Check();
  const std::vector<float> depths = this->Pass->GetChannel("depth");
  vtkNew<vtkMesoGDMTable> table;
  table->SetInputData(bars);
  this->Options.Technique = MesoTechnique::GDM;
  this->Options.Quality = MesoQuality::High;
  for (const int rank : { 16, 0 })
  {
    table->SetRank(rank);
    table->SetBits(rank > 0 ? 16 : 8);
    table->Update();
    this->Mapper->SetTable(table->GetOutput());
    this->Mapper->SetOptions(this->Options);
    EXPECT_NEAR(this->Check(), covered, covered / 50) << rank;
    const std::vector<float> looked = this->Pass->GetChannel("depth");
    int both = 0;
    int off = 0;
    for (std::size_t i = 0; i < depths.size(); ++i)
    {
      both += depths[i] > 0.f && looked[i] > 0.f ? 1 : 0;
      off += depths[i] > 0.f && looked[i] > 0.f && std::abs(depths[i] - looked[i]) > 0.02f ? 1 : 0;
    }
    EXPECT_GT(both, 3000);
    EXPECT_LT(off, both / 10) << rank; // at the bars' outlines
  }
  // Without a table the shell's faces are drawn.
  this->Mapper->SetTable(nullptr);
  this->Scene.Window->Render();
  EXPECT_TRUE(this->Mapper->GetEffectsDrawn().Empty());
}

TEST_F(ShellMapper, EveryCombinationIsDrawn)
{
  this->Scene.LookFrom(1., 2., 3.5);
  const auto torus = MesoTestScene::Shape("torus", { { "rings", { 16. } }, { "sides", { 8. } } });
  const auto look = [&](const char* what)
  {
    this->Use(torus, MesoTestBars(), 0.2, 10., 4.);
    EXPECT_GT(this->Check(), 500) << what;
    this->Scene.Window->Render();
  };
  this->Options.Quality = MesoQuality::Draft;
  this->Options.Segments = 3;
  look("draft, three segments");
  this->Scene.Actor->GetProperty()->SetSpecular(0.5);
  this->Scene.Renderer->RemoveAllLights();
  look("no light");
  this->Scene.AddHeadlight();
  this->Options.Effects.Auto = false;
  this->Options.Effects.Named =
    MesoEffectsOfTechnique(MesoTechnique::ShellSDF).Without({ MesoEffect::Shading });
  look("headlight, specular, no shading");
  this->Options.Effects.Auto = true;
  this->Scene.Actor->GetProperty()->SetInterpolationToPBR();
  this->Scene.Actor->GetProperty()->EdgeVisibilityOn();
  look("PBR, edges");
}

TEST_F(ShellMapper, WithoutAShellItSaysSo)
{
  MesoExpectedMessages expected("no shell of prisms");
  this->Use(MesoTestScene::Shape("torus"), MesoTestBars(), 0.2);
  vtkNew<vtkPolyData> bare;
  bare->ShallowCopy(this->Mapper->GetInput());
  bare->SetFieldData(vtkNew<vtkFieldData>());
  this->Mapper->SetInputData(bare);
  this->Scene.LookFrom(1., 2., 3.5);
  this->Scene.Window->Render();
  EXPECT_NE(this->Mapper->GetWhyPlain(), "");
}
