// What mappers cannot take: composite data, of which nothing is drawn, and maps, images, volumes and tables that are
// larger than the device's textures, in whose place the base mesh is. Each is said once, with its class or size.

#include "MesoAOVChecks.h"
#include "MesoExpectedMessages.h"
#include "MesoTestVDM.h"
#include "MesoTestVolume.h"

#include "vtkMesoBumpMapper.h"
#include "vtkMesoGDMTable.h"
#include "vtkMesoPrismShell.h"
#include "vtkMesoShellMapper.h"
#include "vtkMesoVDMMapper.h"

#include "vtkCompositeDataGeometryFilter.h"
#include "vtkDataArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkTextureObject.h"
#include "vtkTrivialProducer.h"

namespace
{
/// A text with a number in place of its #.
std::string With(int number, const std::string& text)
{
  const auto place = text.find('#');
  return text.substr(0, place) + std::to_string(number) + text.substr(place + 1);
}

/// A map of one height.
vtkSmartPointer<vtkImageData> Level(int width, int height, int components = 1)
{
  auto map = vtkSmartPointer<vtkImageData>::New();
  map->SetDimensions(width, height, 1);
  map->AllocateScalars(VTK_FLOAT, components);
  map->GetPointData()->GetScalars()->Fill(0.5);
  return map;
}

class ReliefRefusedInputs : public testing::Test
{
protected:
  MesoTestScene Scene{ 64, 64 };
  int Limit = 0; ///< texels a side
  int Limit3D = 0;

  ReliefRefusedInputs()
  {
    this->Scene.AddHeadlight();
    this->Scene.LookFrom(0., 0., 3.);
    this->Scene.Window->Render();
    this->Limit = vtkTextureObject::GetMaximumTextureSize(this->Scene.Window);
    this->Limit3D = vtkTextureObject::GetMaximumTextureSize3D(this->Scene.Window);
  }

  static vtkSmartPointer<vtkPolyData> Plane()
  {
    return MesoTestScene::Prepared(MesoTestScene::Shape("plane"), MesoTechnique::ReliefQuadric);
  }

  static void Use(vtkMesoPolyDataMapper* mapper, MesoTechnique technique,
    MesoSearch search = MesoSearch::LinearBinary, MesoCurvedKind curved = MesoCurvedKind::Quadric)
  {
    MesoMesostructureOptions options;
    options.Technique = technique;
    options.Curved = curved;
    options.Search = search;
    options.Scale = 0.05;
    mapper->SetOptions(options);
  }

  /// Draws two frames, in which the reason is said once, and the base mesh.
  void ExpectRefused(vtkMesoPolyDataMapper* mapper, const std::string& reason)
  {
    this->Scene.Actor->SetMapper(mapper);
    MesoExpectedMessages expected(reason);
    this->Scene.Window->Render();
    this->Scene.Window->Render();
    EXPECT_EQ(expected.GetCount(), 1);
    EXPECT_NE(mapper->GetWhyPlain().find(reason), std::string::npos) << mapper->GetWhyPlain();
    this->ExpectCovered(true);
  }

  void ExpectCovered(bool covered)
  {
    vtkNew<vtkMesoAOVPass> pass;
    MesoCapture(this->Scene, pass);
    EXPECT_EQ(MesoCheckEveryPixel(pass) > 500, covered);
    pass->ReleaseGraphicsResources(this->Scene.Window);
  }
};
}

TEST_F(ReliefRefusedInputs, CompositeDataIsDrawnAsOneMeshOnly)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Plane());
  blocks->SetBlock(2, Plane()); // and none in between
  vtkNew<vtkPartitionedDataSet> parts;
  parts->SetPartition(0, Plane());
  for (vtkDataObject* data :
    { static_cast<vtkDataObject*>(blocks), static_cast<vtkDataObject*>(parts) })
  {
    vtkNew<vtkMesoReliefMapper> mapper;
    Use(mapper, MesoTechnique::Relief);
    mapper->SetHeightMap(MesoTestScene::Pattern("smooth"));
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(data);
    mapper->SetInputConnection(producer->GetOutputPort());
    this->Scene.Actor->SetMapper(mapper);
    {
      const std::string reason = "The input is a " + std::string(data->GetClassName());
      MesoExpectedMessages expected(reason);
      this->Scene.Window->Render();
      this->Scene.Window->Render();
      EXPECT_EQ(expected.GetCount(), 1);
      this->ExpectCovered(false);
    }
    vtkNew<vtkCompositeDataGeometryFilter> surfaces;
    surfaces->SetInputDataObject(data);
    mapper->SetInputConnection(surfaces->GetOutputPort());
    this->ExpectCovered(true);
    EXPECT_FALSE(mapper->GetEffectsDrawn().Empty()) << mapper->GetWhyPlain();
  }
}

TEST_F(ReliefRefusedInputs, AHeightMapLargerThanTextures)
{
  vtkNew<vtkMesoReliefMapper> mapper;
  mapper->SetInputData(Plane());
  Use(mapper, MesoTechnique::Relief);
  for (const bool high : { false, true })
  {
    mapper->SetHeightMap(high ? Level(1, this->Limit + 1) : Level(this->Limit + 1, 1));
    this->ExpectRefused(mapper,
      With(this->Limit + 1, high ? "the height map of 1 x #" : "the height map of # x 1") +
        With(this->Limit, " is larger than the # that this device takes"));
  }
  // Once it fits, it is drawn.
  mapper->SetHeightMap(Level(this->Limit, 1));
  this->Scene.Window->Render();
  EXPECT_EQ(mapper->GetWhyPlain(), "");
}

TEST_F(ReliefRefusedInputs, AHeightMapLargerThanTexturesWithItsCones)
{
  vtkNew<vtkMesoReliefMapper> mapper;
  mapper->SetInputData(Plane());
  Use(mapper, MesoTechnique::Relief, MesoSearch::Certified);
  // Of one column, so that the levels' texture is one and a half times as high.
  mapper->SetHeightMap(Level(1, this->Limit));
  this->ExpectRefused(mapper, With(this->Limit, "the height map of 1 x # is larger than the "));
}

TEST_F(ReliefRefusedInputs, ANormalMapLargerThanTextures)
{
  vtkNew<vtkMesoReliefMapper> mapper;
  mapper->SetInputData(Plane());
  Use(mapper, MesoTechnique::Relief);
  mapper->SetHeightMap(Level(4, 4));
  mapper->SetNormalMap(Level(this->Limit + 1, 1, 3));
  this->ExpectRefused(mapper,
    With(this->Limit + 1, "the normal map of # x 1 is larger than the ") +
      std::to_string(this->Limit));
}

TEST_F(ReliefRefusedInputs, AnImageOfTheBaseLargerThanTextures)
{
  vtkNew<vtkMesoReliefMapper> mapper;
  const auto plane = Plane();
  mapper->SetInputData(plane);
  Use(mapper, MesoTechnique::ReliefQuadric, MesoSearch::LinearBinary, MesoCurvedKind::Surface);
  mapper->SetHeightMap(Level(4, 4));
  // More than vtkMesoBaseImage makes: texels of its arrays, with what else is in the image.
  const auto image = MesoTestScene::BaseImage(plane);
  image->SetDimensions(this->Limit + 1, 2, 1);
  for (int i = 0; i < image->GetPointData()->GetNumberOfArrays(); ++i)
  {
    image->GetPointData()->GetArray(i)->SetNumberOfTuples(2 * (vtkIdType(this->Limit) + 1));
  }
  mapper->SetBaseImage(image);
  this->ExpectRefused(mapper,
    With(this->Limit + 1, "the image of the base, # x 2, is larger than the ") +
      std::to_string(this->Limit));
}

TEST_F(ReliefRefusedInputs, AHorizonMapLargerThanTextures)
{
  vtkNew<vtkMesoBumpMapper> mapper;
  mapper->SetInputData(Plane());
  Use(mapper, MesoTechnique::Horizon);
  mapper->SetHeightMap(Level(4, 4));
  mapper->SetHorizonMap(Level(this->Limit3D + 1, 1, 4), 0.05);
  this->ExpectRefused(mapper,
    With(this->Limit3D + 1, "the horizon map of # x 1 texels and 4 azimuths is larger than the ") +
      std::to_string(this->Limit3D));
}

TEST_F(ReliefRefusedInputs, AVolumeOrItsTableLargerThanTextures)
{
  vtkNew<vtkMesoPrismShell> shell;
  shell->SetInputData(MesoTestScene::Shape("plane"));
  shell->SetThickness(0.05);
  shell->Update();
  const auto slab = MesoTestVolume(
    { this->Limit3D + 1, 2, 2 }, 0.5, [](double, double, double z) { return z - 0.25; });
  vtkNew<vtkMesoShellMapper> mapper;
  mapper->SetInputData(shell->GetOutput());
  Use(mapper, MesoTechnique::ShellSDF);
  mapper->SetVolume(slab);
  this->ExpectRefused(mapper,
    With(this->Limit3D + 1, "the volume has # voxels in a row, and this device takes ") +
      std::to_string(this->Limit3D));
  vtkNew<vtkMesoGDMTable> table;
  table->SetInputData(slab);
  table->SetAzimuths(1);
  table->SetPolars(2);
  for (const int rank : { 0, 1 })
  {
    table->SetRank(rank);
    table->Update();
    Use(mapper, MesoTechnique::GDM);
    mapper->SetVolume(MesoTestBars()); // of a size that fits
    mapper->SetTable(table->GetOutput());
    this->ExpectRefused(mapper, With(this->Limit3D + 1, "the table takes a texture of # x "));
  }
}

TEST_F(ReliefRefusedInputs, ATableOfDisplacementsLargerThanTextures)
{
  MesoVDMLayout layout;
  layout.Width = layout.Height = 2;
  layout.Azimuths = 127;
  layout.Polars = 4;
  layout.Curvatures = 64;
  layout.Depth = 0.1;
  const int slices = layout.Curvatures * (layout.Azimuths + 1);
  if (slices <= this->Limit3D)
  {
    GTEST_SKIP() << "this device takes them";
  }
  vtkNew<vtkMesoVDMMapper> mapper;
  mapper->SetInputData(Plane());
  Use(mapper, MesoTechnique::VDM);
  const auto heights = Level(4, 4);
  mapper->SetHeightMap(heights);
  vtkNew<vtkMesoVDM> filter;
  filter->SetInputData(heights);
  filter->SetLayout(layout);
  filter->SetRanks(0, 0);
  filter->Update();
  mapper->SetTable(filter->GetOutput());
  this->ExpectRefused(mapper,
    With(slices, "the table of 2 x 2 texels and # slices is larger than the ") +
      std::to_string(this->Limit3D));
}
