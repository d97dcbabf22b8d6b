// What a VTK program does with any mapper: cell colours, translucency, hardware selection, several
// renderers, one mapper on two actors, copies, changes between frames.

#include "MesoBaseline.h"
#include "MesoExpectedMessages.h"
#include "MesoReliefTechniques.h"
#include "MesoTiltedPlane.h"

#include "vtkAssembly.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkLightCollection.h"
#include "vtkLookupTable.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkTexture.h"
#include "vtkWorldPointPicker.h"

namespace
{
constexpr int Size = 90;

class MapperHabits : public testing::TestWithParam<MesoTechnique>
{
protected:
  MesoTestScene Scene{ Size, Size };
  vtkNew<vtkMesoReliefMapper> Mapper;

  MapperHabits()
  {
    this->Use(this->Mapper);
    this->Scene.Actor->SetMapper(this->Mapper);
    this->Scene.AddDirectionalLight(-1., -2., -1.);
    this->Scene.LookFrom(1., 3., 5.);
  }

  void Use(vtkMesoReliefMapper* mapper) const
  {
    MesoUse(mapper, this->GetParam(), MesoTestScene::Shape("torus"));
    mapper->SetHeightMap(MesoTestScene::Pattern("brick"));
    mapper->SetScale(0.1);
    mapper->SetTiles(6., 3.);
  }

  vtkSmartPointer<vtkImageData> Picture() { return MesoGrabWindow(this->Scene.Window); }

  static bool Equal(vtkImageData* one, vtkImageData* other)
  {
    return MesoCompareImages(one, other, MesoImageLimits::Exact()).Within;
  }
};

MESO_FOR_RELIEF_TECHNIQUES(MapperHabits);

std::array<int, 3> ColorAt(vtkImageData* picture, int column, int rowFromTop)
{
  const int row = picture->GetDimensions()[1] - 1 - rowFromTop;
  const auto* value = static_cast<unsigned char*>(picture->GetScalarPointer(column, row, 0));
  return { value[0], value[1], value[2] };
}

/// Without light, so that the colour is the material's own.
void MakeUnlit(vtkActor* actor)
{
  actor->GetProperty()->SetAmbient(1.);
  actor->GetProperty()->SetDiffuse(0.);
}
}

TEST_P(MapperHabits, CellColorsAreThoseOfTheTable)
{
  vtkNew<vtkPolyData> mesh;
  mesh->ShallowCopy(this->Mapper->GetInput());
  vtkNew<vtkFloatArray> numbers;
  numbers->SetName("cell number");
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(static_cast<float>(i % 5));
  }
  mesh->GetCellData()->SetScalars(numbers);
  const auto color = [&](vtkMapper* mapper)
  {
    vtkNew<vtkLookupTable> table;
    table->SetNumberOfTableValues(5);
    table->Build();
    mapper->SetLookupTable(table);
    mapper->SetScalarRange(0., 4.);
    mapper->SetScalarModeToUseCellData();
    mapper->ScalarVisibilityOn();
  };
  this->Mapper->SetInputData(mesh);
  const auto uncolored = this->Picture();
  color(this->Mapper);
  EXPECT_FALSE(Equal(this->Picture(), uncolored));
  this->Mapper->SetHeightMap(MesoTestScene::Constant(1.f));
  const auto flat = this->Picture();
  vtkNew<vtkPolyDataMapper> theirs;
  theirs->SetInputData(mesh);
  color(theirs);
  this->Scene.Actor->SetMapper(theirs);
  EXPECT_TRUE(Equal(flat, this->Picture()));
}

TEST(MapperScalars, PointColorsAreThoseWhereTheRayHits)
{
  // A ramp along u, coloured at the hit, which lies 3/4 of the travel aside from the fragment.
  MesoTiltedPlane scene(50., 0.1, MesoTestScene::Constant(0.25f), Size);
  MakeUnlit(scene.Actor);
  vtkNew<vtkPolyData> mesh;
  mesh->DeepCopy(scene.Mapper->GetInput());
  vtkNew<vtkFloatArray> ramp;
  ramp->SetName("ramp");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    ramp->InsertNextValue(static_cast<float>(mesh->GetPointData()->GetTCoords()->GetTuple(i)[0]));
  }
  mesh->GetPointData()->AddArray(ramp);
  scene.Mapper->SetInputData(mesh);
  vtkNew<vtkLookupTable> grey;
  grey->SetNumberOfTableValues(256);
  for (int i = 0; i < 256; ++i)
  {
    grey->SetTableValue(i, i / 255., i / 255., i / 255.);
  }
  grey->SetRange(0., 1.);
  scene.Mapper->SetLookupTable(grey);
  scene.Mapper->SetScalarRange(0., 1.);
  scene.Mapper->SetScalarModeToUsePointFieldData();
  scene.Mapper->SelectColorArray("ramp");
  scene.Mapper->ScalarVisibilityOn();
  for (const bool texture : { true, false })
  {
    scene.Mapper->SetInterpolateScalarsBeforeMapping(texture);
    const auto picture = MesoGrabWindow(scene.Window);
    int looked = 0;
    for (int column = 0; column < Size; column += 3)
    {
      const double u = scene.EntryU(column) + 0.75 * scene.TravelU();
      if (scene.EntryU(column) > 0.02 && u < 0.98)
      {
        // A step of the table, and another for the rounding of its ends.
        EXPECT_NEAR(ColorAt(picture, column, 30)[0], 255. * u, 2.)
          << column << (texture ? " by texture" : " at vertices");
        ++looked;
      }
    }
    EXPECT_GT(looked, 10);
  }
}

TEST(MapperTranslucency, DepthPeelingSortsByTheReliefsDepth)
{
  // The relief's only surface, red, is 0.2 below its mesh; a blue pane lies between the two.
  MesoTiltedPlane scene(0., 0.2, MesoTestScene::Constant(0.f), Size);
  MakeUnlit(scene.Actor);
  scene.Actor->GetProperty()->SetColor(1., 0., 0.);
  scene.Actor->GetProperty()->SetOpacity(0.5);
  vtkNew<vtkPlaneSource> pane;
  pane->SetCenter(0., 0., -0.1);
  vtkNew<vtkPolyDataMapper> paneMapper;
  paneMapper->SetInputConnection(pane->GetOutputPort());
  vtkNew<vtkActor> paneActor;
  paneActor->SetMapper(paneMapper);
  MakeUnlit(paneActor);
  paneActor->GetProperty()->SetColor(0., 0., 1.);
  paneActor->GetProperty()->SetOpacity(0.5);
  scene.Renderer->AddActor(paneActor);
  scene.Renderer->SetBackground(0., 1., 0.);
  scene.Renderer->UseDepthPeelingOn();
  scene.Renderer->SetMaximumNumberOfPeels(8);
  scene.Renderer->SetOcclusionRatio(0.);
  const auto color = [&]() { return ColorAt(MesoGrabWindow(scene.Window), Size / 2, Size / 2); };
  const auto expect = [&](int red, int green, int blue, const char* what)
  {
    const auto seen = color();
    EXPECT_NEAR(seen[0], red, 2) << what;
    EXPECT_NEAR(seen[1], green, 2) << what;
    EXPECT_NEAR(seen[2], blue, 2) << what;
  };
  expect(64, 64, 128, "the pane over the relief");
  EXPECT_TRUE(scene.Renderer->GetLastRenderingUsedDepthPeeling());
  scene.Mapper->SetHeightMap(MesoTestScene::Constant(1.f));
  expect(128, 64, 64, "the relief over the pane");
}

TEST_P(MapperHabits, HardwareSelectionSeesWhatIsDrawn)
{
  this->Scene.Window->Render();
  vtkNew<vtkFloatArray> depths;
  this->Scene.Window->GetZbufferData(0, 0, Size - 1, Size - 1, depths);
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(this->Scene.Renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  selector->SetArea(0, 0, Size - 1, Size - 1);
  ASSERT_TRUE(selector->CaptureBuffers());
  int wrong = 0;
  int covered = 0;
  const vtkIdType cells = this->Mapper->GetInput()->GetNumberOfCells();
  for (unsigned int row = 0; row < Size; ++row)
  {
    for (unsigned int column = 0; column < Size; ++column)
    {
      const unsigned int place[2] = { column, row };
      const auto info = selector->GetPixelInformation(place);
      const bool drawn = depths->GetValue(static_cast<vtkIdType>(row) * Size + column) < 1.f;
      covered += drawn ? 1 : 0;
      wrong += info.Valid == drawn &&
          (!drawn || (info.Prop == this->Scene.Actor.Get() && info.AttributeID < cells))
        ? 0
        : 1;
    }
  }
  EXPECT_GT(covered, 1000);
  EXPECT_EQ(wrong, 0);
}

TEST(MapperDepth, TheWorldPointUnderAPixelLiesOnTheRelief)
{
  MesoTiltedPlane scene(50., 0.1, MesoTestScene::Constant(0.25f), Size);
  scene.Window->Render();
  vtkNew<vtkWorldPointPicker> picker;
  for (const auto& pixel : { std::array<int, 2>{ 45, 40 }, { 20, 70 } })
  {
    picker->Pick(pixel[0] + 0.5, Size - 1 - pixel[1] + 0.5, 0., scene.Renderer);
    const double* point = picker->GetPickPosition();
    const double x = scene.EntryU(pixel[0]) + 0.75 * scene.TravelU() - 0.5;
    // The depth buffer has 24 bits or a float's, over a range of about 1; the picker takes whole
    // pixels, so the ray is half a pixel off.
    EXPECT_NEAR(point[0], x, 1.01 * MesoTiltedPlane::HalfHeight / Size / std::cos(scene.Angle));
    EXPECT_NEAR(point[2], -0.075, 1e-4 + MesoTiltedPlane::HalfHeight / Size);
  }
}

TEST_P(MapperHabits, ResizingGivesThePictureOfANewWindow)
{
  this->Picture();
  this->Scene.Window->SetSize(60, 110);
  const auto resized = this->Picture();
  MesoTestScene fresh(60, 110);
  vtkNew<vtkMesoReliefMapper> mapper;
  this->Use(mapper);
  fresh.Actor->SetMapper(mapper);
  fresh.AddDirectionalLight(-1., -2., -1.);
  fresh.LookFrom(1., 3., 5.);
  EXPECT_TRUE(Equal(resized, MesoGrabWindow(fresh.Window)));
}

TEST_P(MapperHabits, OneActorInTwoRenderers)
{
  const auto alone = this->Picture();
  this->Scene.Window->SetSize(2 * Size, Size);
  this->Scene.Renderer->SetViewport(0., 0., 0.5, 1.);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.5, 0., 1., 1.);
  other->SetBackground(this->Scene.Renderer->GetBackground());
  other->AutomaticLightCreationOff();
  other->AddLight(vtkLight::SafeDownCast(this->Scene.Renderer->GetLights()->GetItemAsObject(0)));
  other->SetActiveCamera(this->Scene.Renderer->GetActiveCamera());
  other->AddActor(this->Scene.Actor);
  this->Scene.Window->AddRenderer(other);
  const auto both = this->Picture();
  int different = 0;
  for (int row = 0; row < Size; ++row)
  {
    for (int column = 0; column < Size; ++column)
    {
      const auto expected = ColorAt(alone, column, row);
      different += ColorAt(both, column, row) == expected ? 0 : 1;
      different += ColorAt(both, column + Size, row) == expected ? 0 : 1;
    }
  }
  // Half a window further on, a rasteriser may round a vertex to the next of its 1/256 pixels.
  EXPECT_LE(different, Size * Size / 500);
}

TEST_P(MapperHabits, OneMapperOnTwoActors)
{
  vtkNew<vtkActor> second;
  second->SetScale(0.4, 0.7, 0.5);
  second->SetPosition(0., 0.9, 0.);
  second->GetProperty()->SetColor(0.3, 0.5, 0.9);
  second->GetProperty()->SetSpecular(0.5); // another shader
  vtkNew<vtkMesoReliefMapper> own;
  this->Use(own);
  second->SetMapper(own);
  this->Scene.Renderer->AddActor(second);
  const auto expected = this->Picture();
  second->SetMapper(this->Mapper);
  for (int frame = 0; frame < 3; ++frame)
  {
    EXPECT_TRUE(Equal(this->Picture(), expected)) << frame;
  }
}

TEST_P(MapperHabits, PartsOfAssembliesWithUnevenScale)
{
  this->Scene.Actor->SetScale(0.5, 0.9, 0.7);
  this->Scene.Actor->SetPosition(0.3, -0.2, 0.);
  const auto expected = this->Picture();
  this->Scene.Renderer->RemoveActor(this->Scene.Actor);
  this->Scene.Actor->SetScale(1., 0.6, 1.);
  this->Scene.Actor->SetPosition(0.6, -0.4 / 1.5 * 0.5, 0.);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(this->Scene.Actor);
  assembly->SetScale(0.5, 1.5, 0.7);
  this->Scene.Renderer->AddActor(assembly);
  // The matrices' products differ in their last bits.
  const auto difference = MesoCompareImages(this->Picture(), expected);
  EXPECT_TRUE(difference.Within) << difference.Describe();
}

TEST_P(MapperHabits, ACopyDrawsTheSame)
{
  MesoMesostructureOptions options = this->Mapper->GetOptions();
  options.Quality = MesoQuality::Low;
  options.Wrap = MesoWrap::Mirror;
  this->Mapper->SetOptions(options);
  vtkNew<vtkLookupTable> table;
  table->SetRange(0., 1.);
  this->Mapper->SetHeightColors(table);
  MesoContourLines lines;
  lines.Spacing = 0.25;
  this->Mapper->SetContourLines(lines);
  this->Mapper->SetMapNumbers(3., 7.);
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1., 0.2, 0.);
  this->Mapper->AddClippingPlane(plane);
  const auto expected = this->Picture();
  vtkNew<vtkMesoReliefMapper> copy;
  copy->ShallowCopy(this->Mapper);
  EXPECT_EQ(copy->GetMapNumbers(), this->Mapper->GetMapNumbers());
  EXPECT_EQ(copy->GetHeightMap(), this->Mapper->GetHeightMap());
  this->Scene.Actor->SetMapper(copy);
  EXPECT_TRUE(Equal(this->Picture(), expected));
  this->Mapper->SetScale(0.01); // the copy's options are its own
  EXPECT_TRUE(Equal(this->Picture(), expected));
}

TEST_P(MapperHabits, ChangesBetweenFramesAreSeenAndNothingPilesUp)
{
  const auto brick = this->Picture();
  const auto bytes = this->Mapper->GetGPUBytes();
  this->Mapper->SetHeightMap(MesoTestScene::Pattern("smooth"));
  const auto smooth = this->Picture();
  EXPECT_FALSE(Equal(smooth, brick));
  for (int frame = 0; frame < 10; ++frame)
  {
    this->Mapper->SetHeightMap(MesoTestScene::Pattern(frame % 2 == 0 ? "brick" : "smooth"));
    MesoMesostructureOptions options = this->Mapper->GetOptions();
    options.Quality = frame % 2 == 0 ? MesoQuality::Draft : MesoQuality::Medium;
    this->Mapper->SetOptions(options);
    const auto picture = this->Picture();
    EXPECT_FALSE(Equal(picture, frame % 2 == 0 ? smooth : brick)) << frame;
    EXPECT_EQ(this->Mapper->GetGPUBytes(), bytes) << frame;
  }
  EXPECT_TRUE(Equal(this->Picture(), smooth));
  // The same image with other heights.
  vtkImageData* map = this->Mapper->GetHeightMap();
  auto* heights = static_cast<float*>(map->GetScalarPointer());
  std::fill_n(heights, map->GetNumberOfPoints(), 1.f);
  map->Modified();
  const auto flat = this->Picture();
  this->Mapper->SetScale(0.);
  EXPECT_TRUE(Equal(flat, this->Picture()));
}

TEST_P(MapperHabits, ANormalTextureOfThePropertyIsRefused)
{
  const auto before = this->Picture();
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::fill_n(
    static_cast<unsigned char*>(image->GetScalarPointer()), 12, static_cast<unsigned char>(200));
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  this->Scene.Actor->GetProperty()->SetNormalTexture(texture);
  MesoExpectedMessages expected("normal texture");
  EXPECT_TRUE(Equal(this->Picture(), before));
  EXPECT_EQ(expected.GetCount(), 1);
}
