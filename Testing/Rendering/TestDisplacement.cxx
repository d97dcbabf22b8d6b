// The technique `displacement` as it is drawn: the diced mesh of `tessellated` where both cut alike,
// whatever is asked of VTK beside it; closed where levels are mixed; and it follows its input.

#include "MesoAOVChecks.h"
#include "MesoBaseline.h"
#include "MesoExpectedMessages.h"

#include "vtkMesoDisplacedMesh.h"
#include "vtkMesoDisplacementMapper.h"
#include "vtkMesoHorizonMap.h"
#include "vtkMesoShadowMapPass.h"
#include "vtkMesoSurfaceFrames.h"
#include "vtkMesoTessellatedMapper.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkLookupTable.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkTexture.h"

#include <cmath>
#include <set>

namespace
{
class Displacement : public testing::Test
{
protected:
  MesoTestScene Scene;
  vtkNew<vtkMesoDisplacementMapper> Mapper;
  vtkNew<vtkMesoTessellatedMapper> Diced;
  vtkNew<vtkMesoAOVPass> Pass;
  vtkSmartPointer<vtkPolyData> Base;
  vtkSmartPointer<vtkImageData> Map;
  MesoMesostructureOptions Options;

  Displacement()
  {
    this->Options.Technique = MesoTechnique::Displacement;
    this->Options.Scale = 0.1;
    this->Options.FacetPixels = 0.; // the map alone decides
    this->Scene.Actor->SetMapper(this->Mapper);
    this->Scene.AddDirectionalLight(-1., -2., -1.);
    this->Scene.LookFrom(1., 3., 5.);
  }
  ~Displacement() override { this->Pass->ReleaseGraphicsResources(this->Scene.Window); }

  /// Quads of 8 x 8 texels: all edges are cut alike.
  void UseTorus(const char* pattern = "brick")
  {
    this->Base = MesoTestScene::Shape("torus", { { "rings", { 24. } }, { "sides", { 12. } } });
    this->Map = MesoTestScene::Pattern(pattern, 32, 32);
    this->Options.Tiles = { 6., 3. };
    this->Use();
  }

  void Use()
  {
    this->Mapper->SetInputData(this->Base);
    this->Mapper->SetHeightMap(this->Map);
    this->Mapper->SetOptions(this->Options);
    vtkNew<vtkMesoDisplacedMesh> filter;
    filter->SetInputData(this->Base);
    filter->SetHeightMapData(this->Map);
    filter->SetScale(this->Options.Scale);
    filter->SetReference(this->Options.Reference);
    filter->SetTiles(this->Options.Tiles[0], this->Options.Tiles[1]);
    filter->SetWrap(this->Options.Wrap);
    if (this->Base->GetPointData()->HasArray("number"))
    {
      filter->AddCarriedArray("number");
    }
    filter->SetFacetsPerTexel(MesoFacetsPerTexel(this->Options.Quality));
    filter->Update();
    this->Diced->SetInputData(filter->GetOutput());
    MesoMesostructureOptions options = this->Options;
    options.Technique = MesoTechnique::Tessellated;
    options.Effects = {};
    this->Diced->SetOptions(options);
  }

  vtkSmartPointer<vtkImageData> Grab(vtkMapper* mapper)
  {
    this->Scene.Actor->SetMapper(mapper);
    const auto image = MesoGrabWindow(this->Scene.Window);
    this->Scene.Actor->SetMapper(this->Mapper);
    return image;
  }

  /// The picture is that of the diced mesh, whose normals along the base's edges are means.
  void ExpectDicedPicture(const char* what)
  {
    const auto expected = this->Grab(this->Diced);
    const auto ours = this->Grab(this->Mapper);
    EXPECT_TRUE(this->Mapper->GetWhyPlain().empty()) << this->Mapper->GetWhyPlain();
    MesoImageLimits limits;
    limits.SmallDifference = 6;
    limits.SmallFraction = 0.01;
    limits.LargeFraction = 0.001;
    const auto difference = MesoCompareImages(ours, expected, limits);
    EXPECT_TRUE(difference.Within) << what << ": " << difference.Describe();
    this->Scene.Actor->VisibilityOff();
    EXPECT_FALSE(MesoCompareImages(MesoGrabWindow(this->Scene.Window), ours).Within) << what;
    this->Scene.Actor->VisibilityOn();
  }

  int Covered()
  {
    MesoCapture(this->Scene, this->Pass);
    return MesoCheckEveryPixel(this->Pass);
  }

  std::vector<float> Channel(vtkMapper* mapper, const char* name)
  {
    this->Scene.Actor->SetMapper(mapper);
    this->Covered();
    this->Scene.Actor->SetMapper(this->Mapper);
    return this->Pass->GetChannel(name);
  }
};
}

TEST_F(Displacement, IsTheDicedMeshWhereBothCutAlike)
{
  this->UseTorus();
  this->ExpectDicedPicture("brick");
  EXPECT_EQ(this->Mapper->GetNumberOfTrianglesDrawn(), this->Diced->GetInput()->GetNumberOfPolys());
  EXPECT_EQ(this->Mapper->GetNumberOfTrianglesDrawn(), 2 * 24 * 12 * 64);
  for (const char* channel : { "coverage", "depth", "relief", "texcoord.u", "texcoord.v" })
  {
    const auto theirs = this->Channel(this->Diced, channel);
    const auto ours = this->Channel(this->Mapper, channel);
    int apart = 0;
    for (std::size_t i = 0; i < ours.size(); ++i)
    {
      apart += std::abs(ours[i] - theirs[i]) > 2e-4f ? 1 : 0;
    }
    // Pixels whose centre lies on an outline to within rounding.
    EXPECT_LE(apart, int(ours.size() / 2000)) << channel;
  }
  this->Options.Quality = MesoQuality::High;
  this->Use();
  this->ExpectDicedPicture("two facets a texel");
  this->Options.Reference = 0.3; // both ways
  this->Use();
  this->ExpectDicedPicture("signed");
  this->Options.Wrap = MesoWrap::Mirror;
  this->Use();
  this->ExpectDicedPicture("mirrored");
}

TEST_F(Displacement, IsSeenWithWhateverElseIsAsked)
{
  this->UseTorus();
  vtkProperty* property = this->Scene.Actor->GetProperty();
  this->Scene.AddHeadlight();
  property->SetSpecular(0.3);
  property->SetSpecularPower(20.);
  this->ExpectDicedPicture("specular");
  property->EdgeVisibilityOn();
  this->Grab(this->Diced); // edges of VTK are antialiased by a geometry shader
  this->ExpectDicedPicture("edges");
  property->EdgeVisibilityOff();
  property->SetInterpolationToFlat();
  this->ExpectDicedPicture("flat");
  property->SetInterpolationToPhong();

  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const unsigned char colours[] = { 250, 20, 20, 20, 250, 20, 20, 20, 250, 250, 250, 20 };
  std::copy(
    std::begin(colours), std::end(colours), static_cast<unsigned char*>(image->GetScalarPointer()));
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOn();
  this->Scene.Actor->SetTexture(texture);
  this->ExpectDicedPicture("textured");
  this->Scene.Actor->SetTexture(nullptr);

  vtkNew<vtkPlane> plane;
  plane->SetNormal(1., 0.3, 0.);
  this->Mapper->AddClippingPlane(plane);
  this->Diced->AddClippingPlane(plane);
  this->ExpectDicedPicture("clipped");
  this->Mapper->RemoveAllClippingPlanes();
  this->Diced->RemoveAllClippingPlanes();

  this->Scene.Actor->SetScale(-1., 0.7, 1.2);
  this->Scene.Actor->RotateX(40.);
  property->BackfaceCullingOff();
  this->ExpectDicedPicture("moved, mirrored and seen from both sides");
}

TEST_F(Displacement, ColoursByPointArrays)
{
  this->Base = MesoTestScene::Shape("torus", { { "rings", { 24. } }, { "sides", { 12. } } });
  vtkNew<vtkFloatArray> array;
  array->SetName("number");
  for (vtkIdType i = 0; i < this->Base->GetNumberOfPoints(); ++i)
  {
    array->InsertNextValue(float(this->Base->GetPoint(i)[0]));
  }
  this->Base->GetPointData()->AddArray(array);
  this->Map = MesoTestScene::Pattern("brick", 32, 32);
  this->Options.Tiles = { 6., 3. };
  this->Use();
  const auto grey = this->Grab(this->Mapper);
  vtkNew<vtkLookupTable> table;
  // Greys that grow evenly: the same, looked up before or after they are interpolated.
  table->SetRange(-1.5, 1.5);
  table->SetSaturationRange(0., 0.);
  table->SetValueRange(0., 1.);
  table->SetNumberOfTableValues(1024);
  table->Build();
  for (vtkMesoPolyDataMapper* mapper : { static_cast<vtkMesoPolyDataMapper*>(this->Mapper),
         static_cast<vtkMesoPolyDataMapper*>(this->Diced) })
  {
    mapper->SetScalarModeToUsePointFieldData();
    mapper->SelectColorArray("number");
    mapper->SetLookupTable(table);
    mapper->UseLookupTableScalarRangeOn();
    mapper->ScalarVisibilityOn();
    mapper->InterpolateScalarsBeforeMappingOff();
  }
  this->ExpectDicedPicture("colours at corners");
  EXPECT_FALSE(MesoCompareImages(this->Grab(this->Mapper), grey).Within);
  this->Mapper->InterpolateScalarsBeforeMappingOn();
  this->Diced->InterpolateScalarsBeforeMappingOn();
  this->ExpectDicedPicture("colours looked up where they are seen");
}

TEST_F(Displacement, NoReliefIsTheBaseMesh)
{
  this->UseTorus();
  vtkNew<vtkMesoPolyDataMapper> plain;
  plain->SetInputData(this->Base);
  const auto expected = this->Grab(plain);
  EXPECT_FALSE(MesoCompareImages(this->Grab(this->Mapper), expected).Within);
  this->Mapper->SetScale(0.);
  // Cut finer, triangles cover the same pixels to rounding, and normals are interpolated in pieces.
  MesoImageLimits rounding;
  rounding.LargeFraction = 1e-3;
  auto difference = MesoCompareImages(this->Grab(this->Mapper), expected, rounding);
  EXPECT_TRUE(difference.Within) << difference.Describe();
  this->Mapper->SetScale(0.1);
  this->Mapper->SetHeightMap(MesoTestScene::Constant(1.f));
  difference = MesoCompareImages(this->Grab(this->Mapper), expected, rounding);
  EXPECT_TRUE(difference.Within) << difference.Describe();
  this->Mapper->SetHeightMap(nullptr);
  EXPECT_TRUE(
    MesoCompareImages(this->Grab(this->Mapper), expected, MesoImageLimits::Exact()).Within);
  this->Mapper->SetHeightMap(this->Map);
  MesoMesostructureOptions none = this->Options;
  none.Effects.Auto = false;
  this->Mapper->SetOptions(none);
  EXPECT_TRUE(
    MesoCompareImages(this->Grab(this->Mapper), expected, MesoImageLimits::Exact()).Within);
  EXPECT_TRUE(this->Mapper->GetEffectsDrawn().Empty());
}

TEST_F(Displacement, MixedLevelsLeaveNoHoles)
{
  // A coarse torus whose near edges are cut many times as fine as the far ones.
  std::set<std::int64_t> levels;
  this->Base = MesoTestScene::Shape("torus", { { "rings", { 12. } }, { "sides", { 7. } } });
  this->Map = MesoTestScene::Pattern("noise", 64, 64);
  this->Options.Tiles = { 6., 3. };
  this->Options.Scale = 0.05;
  this->Options.FacetPixels = 5.;
  this->Use();
  // Inside the tube there is surface all around, seen from behind, seams and all.
  this->Scene.Actor->GetProperty()->BackfaceCullingOff();
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  camera->SetViewAngle(70.);
  for (int turn = 0; turn < 16; ++turn)
  {
    const double angle = 0.4 * turn;
    camera->SetPosition(1.2 * std::cos(angle), 0.1, 1.2 * std::sin(angle));
    camera->SetFocalPoint(1.2 * std::cos(angle) + std::cos(3. * turn), 0.3 * std::sin(5. * turn),
      1.2 * std::sin(angle) + std::sin(3. * turn));
    camera->SetViewUp(0., 1., 0.);
    camera->SetClippingRange(0.005, 10.);
    EXPECT_EQ(this->Covered(), 150 * 150) << turn;
    levels.insert(this->Mapper->GetNumberOfTrianglesDrawn());
  }
  EXPECT_GT(levels.size(), 10u) << "each view cuts in its own way";
}

TEST_F(Displacement, FarAwayItDrawsFewTriangles)
{
  this->UseTorus();
  this->Options.FacetPixels = 2.;
  this->Mapper->SetOptions(this->Options);
  this->Scene.LookFrom(1., 3., 5.);
  MesoGrabWindow(this->Scene.Window);
  const auto near = this->Mapper->GetNumberOfTrianglesDrawn();
  const std::size_t bytes = this->Mapper->GetGPUBytes();
  this->Scene.LookFrom(10., 30., 50.);
  MesoGrabWindow(this->Scene.Window);
  EXPECT_LT(10 * this->Mapper->GetNumberOfTrianglesDrawn(), near);
  EXPECT_GT(this->Mapper->GetNumberOfTrianglesDrawn(), 100);
  // What is held does not depend on how fine is cut.
  EXPECT_LE(this->Mapper->GetGPUBytes(), bytes);
  EXPECT_LT(bytes, 300000u); // 36864 points would take 1.2 MB
}

TEST_F(Displacement, FollowsAnInputThatMoves)
{
  this->UseTorus();
  this->Grab(this->Mapper);
  // The torus bends like a leaf in the wind; its frames are refitted.
  const auto bent = [&](double phase)
  {
    vtkNew<vtkPolyData> moved;
    moved->DeepCopy(MesoTestScene::Shape("torus", { { "rings", { 24. } }, { "sides", { 12. } } }));
    for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
    {
      double p[3];
      moved->GetPoint(i, p);
      moved->GetPoints()->SetPoint(i, p[0], p[1] + 0.3 * std::sin(2. * p[0] + phase), p[2]);
    }
    moved->GetPointData()->RemoveArray("Normals"); // to be made anew
    vtkNew<vtkMesoSurfaceFrames> frames;
    frames->SetInputData(moved);
    frames->Update();
    return vtkSmartPointer<vtkPolyData>(frames->GetOutput());
  };
  for (const double phase : { 0., 1., 2. })
  {
    const auto before = this->Grab(this->Mapper);
    this->Base->ShallowCopy(bent(phase)); // the same object with other points
    const auto after = this->Grab(this->Mapper);
    EXPECT_FALSE(MesoCompareImages(after, before).Within) << phase;
    this->Use();
    this->ExpectDicedPicture("moved");
  }
  // Another map in place.
  const auto before = this->Grab(this->Mapper);
  this->Map->DeepCopy(MesoTestScene::Pattern("smooth", 32, 32));
  EXPECT_FALSE(MesoCompareImages(this->Grab(this->Mapper), before).Within);
}

TEST_F(Displacement, PicksTheBasesTriangles)
{
  this->UseTorus();
  this->Grab(this->Mapper);
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(this->Scene.Renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  const auto cellAt = [&](vtkMapper* mapper, unsigned int x, unsigned int y)
  {
    this->Scene.Actor->SetMapper(mapper);
    selector->SetArea(x, y, x, y);
    const auto selection = vtk::TakeSmartPointer(selector->Select());
    this->Scene.Actor->SetMapper(this->Mapper);
    if (selection->GetNumberOfNodes() == 0)
    {
      return vtkIdType(-1);
    }
    return vtkIdTypeArray::SafeDownCast(selection->GetNode(0)->GetSelectionList())->GetValue(0);
  };
  vtkNew<vtkMesoPolyDataMapper> plain;
  plain->SetInputData(this->Base);
  this->Mapper->SetScale(1e-4);
  int hits = 0;
  for (unsigned int y = 20; y < 130; y += 18)
  {
    for (unsigned int x = 20; x < 130; x += 18)
    {
      const vtkIdType cell = cellAt(this->Mapper, x, y);
      EXPECT_EQ(cell, cellAt(plain, x, y)) << x << " " << y;
      hits += cell >= 0 ? 1 : 0;
    }
  }
  EXPECT_GT(hits, 10);
}

TEST_F(Displacement, WireframeAndPointsShowTheBase)
{
  this->UseTorus();
  vtkNew<vtkMesoPolyDataMapper> plain;
  plain->SetInputData(this->Base);
  for (const int representation : { VTK_WIREFRAME, VTK_POINTS })
  {
    this->Scene.Actor->GetProperty()->SetRepresentation(representation);
    EXPECT_TRUE(
      MesoCompareImages(this->Grab(this->Mapper), this->Grab(plain), MesoImageLimits::Exact())
        .Within);
  }
}

TEST_F(Displacement, HorizonsShadeIt)
{
  this->UseTorus();
  const auto unshaded = this->Grab(this->Mapper);
  vtkNew<vtkMesoHorizonMap> horizons;
  horizons->SetInputData(this->Map);
  horizons->SetAzimuths(16);
  horizons->SetScale(0.1);
  horizons->Update();
  this->Mapper->SetHorizonMap(horizons->GetOutput(), 0.1);
  const auto shaded = this->Grab(this->Mapper);
  EXPECT_FALSE(MesoCompareImages(shaded, unshaded).Within);
  EXPECT_TRUE(this->Mapper->GetEffectsDrawn().Has(MesoEffect::SelfShadow));
  const auto blocked = this->Channel(this->Mapper, "shadow.0");
  double sum = 0.;
  for (const float value : blocked)
  {
    sum += value;
  }
  this->Mapper->SetHorizonMap(nullptr, 0.1);
  double attached = 0.;
  for (const float value : this->Channel(this->Mapper, "shadow.0"))
  {
    attached += value;
  }
  EXPECT_GT(sum, 1.1 * attached);
  EXPECT_TRUE(
    MesoCompareImages(this->Grab(this->Mapper), unshaded, MesoImageLimits::Exact()).Within);
}

TEST_F(Displacement, SaysWhatTheInputLacks)
{
  this->UseTorus();
  vtkNew<vtkPolyData> bare;
  bare->DeepCopy(this->Base);
  bare->GetPointData()->SetTCoords(nullptr);
  bare->GetPointData()->RemoveArray("TextureCoordinates");
  this->Mapper->SetInputData(bare);
  const MesoExpectedMessages messages("named texture coordinates");
  vtkNew<vtkMesoPolyDataMapper> plain;
  plain->SetInputData(bare);
  EXPECT_TRUE(
    MesoCompareImages(this->Grab(this->Mapper), this->Grab(plain), MesoImageLimits::Exact())
      .Within);
  EXPECT_NE(this->Mapper->GetWhyPlain().find("named texture coordinates"), std::string::npos)
    << this->Mapper->GetWhyPlain();
}

TEST_F(Displacement, HoldsFarFromTheOrigin)
{
  this->UseTorus();
  const auto expected = this->Grab(this->Mapper);
  // VTK moves and scales the buffer's positions there.
  const double far = 1000.;
  vtkNew<vtkPolyData> moved;
  moved->DeepCopy(this->Base);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    double p[3];
    moved->GetPoint(i, p);
    points->InsertNextPoint(p[0] + far, p[1] - far, p[2] + far);
  }
  moved->SetPoints(points);
  this->Mapper->SetInputData(moved);
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  camera->SetPosition(1. + far, 3. - far, 5. + far);
  camera->SetFocalPoint(far, -far, far);
  this->Scene.Renderer->ResetCameraClippingRange();
  MesoImageLimits limits;
  limits.SmallDifference = 6;
  limits.SmallFraction = 0.01;
  limits.LargeFraction = 0.002;
  const auto difference = MesoCompareImages(this->Grab(this->Mapper), expected, limits);
  EXPECT_TRUE(difference.Within) << difference.Describe();
}
