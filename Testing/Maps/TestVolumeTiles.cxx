// Tiles cut out of volumes, made to repeat, resampled; closed meshes made volumes.

#include "ErrorRecorder.h"
#include "MesoVolume.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMesoMeshTile.h"
#include "vtkMesoVolumeTile.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{
vtkSmartPointer<vtkImageData> Image(
  std::array<int, 3> size, const std::function<double(int, int, int)>& number)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size.data());
  image->SetSpacing(2., 2., 3.);
  image->AllocateScalars(VTK_DOUBLE, 1);
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        image->SetScalarComponentFromDouble(i, j, k, 0, number(i, j, k));
      }
    }
  }
  return image;
}

double At(vtkImageData* image, int i, int j, int k)
{
  return image->GetScalarComponentAsDouble(i, j, k, 0);
}

/// A closed box of triangles that face outwards.
vtkSmartPointer<vtkPolyData> Box(const std::vector<std::array<double, 6>>& boxes)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polys;
  for (const auto& box : boxes)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    for (int c = 0; c < 8; ++c)
    {
      points->InsertNextPoint(box[c & 1], box[2 + ((c >> 1) & 1)], box[4 + (c >> 2)]);
    }
    const int quads[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
      { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
    for (const auto& quad : quads)
    {
      for (int half = 0; half < 2; ++half)
      {
        const vtkIdType triangle[3] = { first + quad[0], first + quad[1 + half],
          first + quad[2 + half] };
        polys->InsertNextCell(3, triangle);
      }
    }
  }
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  return mesh;
}

MesoVolumeField Voxels(vtkPolyData* mesh, std::array<double, 6> box, std::array<int, 3> size)
{
  vtkNew<vtkMesoMeshTile> tile;
  tile->SetInputData(mesh);
  tile->SetBox(box.data());
  tile->SetSize(size.data());
  tile->Update();
  EXPECT_EQ(MesoVolumeProblem(tile->GetOutput()), "");
  return MesoVolumeField(tile->GetOutput());
}
}

TEST(VolumeTile, IsTheSamplesOfTheCrop)
{
  vtkNew<vtkMesoVolumeTile> tile;
  tile->SetInputData(Image({ 5, 4, 3 }, [](int i, int j, int k) { return i + 10 * j + 100 * k; }));
  tile->SetCrop(1, 4, 2, 4, 0, 2);
  tile->Update();
  vtkImageData* output = tile->GetOutput();
  int size[3];
  output->GetDimensions(size);
  EXPECT_EQ(size[0], 3);
  EXPECT_EQ(size[1], 2);
  EXPECT_EQ(size[2], 2);
  EXPECT_EQ(At(output, 2, 1, 1), 133.);
  EXPECT_EQ(output->GetSpacing()[2], 3.);
}

TEST(VolumeTile, BlendsItsEndIntoItsBeginning)
{
  // A ramp: the step over the border is the tile's width before, and like those inside after.
  vtkNew<vtkMesoVolumeTile> tile;
  tile->SetInputData(Image({ 40, 1, 1 }, [](int i, int, int) { return i; }));
  tile->SetBlend(0.25);
  tile->Update();
  vtkImageData* output = tile->GetOutput();
  EXPECT_EQ(output->GetDimensions()[0], 30);
  EXPECT_LT(std::abs(At(output, 0, 0, 0) - At(output, 29, 0, 0)), 3.);
  for (int i = 10; i < 30; ++i)
  {
    EXPECT_EQ(At(output, i, 0, 0), i);
  }
}

TEST(VolumeTile, AveragesWhatASparserGridCannotHold)
{
  // Every other sample is 1: a sparser grid holds a half everywhere, not 0 or 1.
  vtkNew<vtkMesoVolumeTile> tile;
  tile->SetInputData(Image({ 32, 4, 8 }, [](int i, int, int) { return i % 2; }));
  tile->SetSize(8, 4, 4);
  tile->Update();
  vtkImageData* output = tile->GetOutput();
  EXPECT_EQ(output->GetDimensions()[0], 8);
  EXPECT_EQ(output->GetSpacing()[0], 8.);
  EXPECT_EQ(output->GetSpacing()[2], 6.);
  for (int i = 0; i < 8; ++i)
  {
    EXPECT_NEAR(At(output, i, 2, 1), 0.5, 0.05) << i;
  }
}

TEST(VolumeTile, InterpolatesOverTheBorderWhereTheGridIsFiner)
{
  vtkNew<vtkMesoVolumeTile> tile;
  tile->SetInputData(Image({ 4, 1, 2 }, [](int i, int, int k) { return i + 10 * k; }));
  tile->SetSize(8, 1, 4);
  tile->Update();
  vtkImageData* output = tile->GetOutput();
  EXPECT_NEAR(At(output, 0, 0, 0), 0.25 * 3., 1e-6); // between the last and the first
  EXPECT_NEAR(At(output, 3, 0, 0), 1.25, 1e-6);
  EXPECT_NEAR(At(output, 3, 0, 3), 11.25, 1e-6); // and no further in z
}

TEST(VolumeTile, TellsTheNextFilterHowLargeItIs)
{
  vtkNew<vtkMesoVolumeTile> tile;
  tile->SetInputData(Image({ 40, 20, 9 }, [](int i, int, int) { return i; }));
  tile->SetCrop(0, 20, 0, 0, 1, 9);
  tile->SetBlend(0.25);
  tile->SetSize(0, 0, 4);
  tile->UpdateInformation();
  const int* extent =
    tile->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
  tile->Update();
  for (int k = 0; k < 6; ++k)
  {
    EXPECT_EQ(extent[k], tile->GetOutput()->GetExtent()[k]) << k;
  }
  EXPECT_EQ(extent[1], 14);
  EXPECT_EQ(extent[3], 14);
  EXPECT_EQ(extent[5], 3);
}

TEST(VolumeTile, RefusesACropBeyondTheVolume)
{
  vtkNew<vtkMesoVolumeTile> tile;
  ErrorRecorder errors;
  errors.Watch(tile);
  tile->SetInputData(Image({ 4, 4, 4 }, [](int, int, int) { return 1.; }));
  tile->SetCrop(0, 5, 0, 4, 0, 4);
  tile->Update();
  ASSERT_EQ(errors.Errors.size(), 1u);
  EXPECT_NE(errors.Errors[0].find("axis 0"), std::string::npos);
  EXPECT_EQ(tile->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(MeshTile, PlacesFacesBetweenVoxels)
{
  // A slab whose faces lie a third of the way between samples, twice as large as its tile is.
  const auto mesh = Box({ { -1., 3., -1., 3., 0.31, 0.66 } });
  const MesoVolumeField field = Voxels(mesh, { 0., 2., 0., 2., 0., 1. }, { 8, 8, 10 });
  EXPECT_EQ(field.GetDepth(), 0.5);
  for (int k = 0; k < 10; ++k)
  {
    const double z = (k + 0.5) / 10.;
    const double distance = 0.5 * std::max(0.31 - z, z - 0.66);
    EXPECT_NEAR(field.Sample(3, 4, k), distance, 1e-3) << k;
  }
}

TEST(MeshTile, TakesInWhatLiesBeyondTheBox)
{
  // A block across the border in x: its other half is at the other end of the tile.
  const auto mesh = Box({ { 0.75, 1.25, 0.3, 0.7, 0.1, 0.4 } });
  const MesoVolumeField field = Voxels(mesh, { 0., 1., 0., 1., 0., 0.5 }, { 16, 16, 8 });
  EXPECT_LT(field.At({ 0.9, 0.5, 0.5 }), 0.);
  EXPECT_LT(field.At({ 0.1, 0.5, 0.5 }), 0.);
  EXPECT_LT(field.At({ 0., 0.5, 0.5 }), -0.05); // nothing parts the halves
  EXPECT_GT(field.At({ 0.5, 0.5, 0.5 }), 0.2);
}

TEST(MeshTile, JoinsPartsThatAreCutAtTheBorder)
{
  // Two ends that touch across the border, each with a face of its own there.
  const auto mesh = Box({ { 0., 0.25, 0.3, 0.7, 0.1, 0.4 }, { 0.75, 1., 0.3, 0.7, 0.1, 0.4 } });
  const MesoVolumeField field = Voxels(mesh, { 0., 1., 0., 1., 0., 0.5 }, { 16, 16, 8 });
  EXPECT_LT(field.At({ 0., 0.5, 0.5 }), -0.05);
  EXPECT_NEAR(field.At({ 0.5, 0.5, 0.5 }), 0.25 - 0.5 / 16., 1e-3); // of the samples beside it
}

TEST(MeshTile, RefusesWhatHasNoInside)
{
  vtkNew<vtkMesoMeshTile> tile;
  ErrorRecorder errors;
  errors.Watch(tile);
  vtkNew<vtkPolyData> empty;
  tile->SetInputData(empty);
  tile->Update();
  EXPECT_EQ(errors.Errors.size(), 1u);
  auto turned = Box({ { 0.1, 0.9, 0.1, 0.9, 0.1, 0.9 } });
  turned->GetPoints()->GetData(); // inside out, by a mirror
  for (vtkIdType i = 0; i < turned->GetNumberOfPoints(); ++i)
  {
    double p[3];
    turned->GetPoint(i, p);
    turned->GetPoints()->SetPoint(i, 1. - p[0], p[1], p[2]);
  }
  tile->SetInputData(turned);
  tile->SetBox(0., 1., 0., 1., 0., 1.);
  tile->Update();
  ASSERT_EQ(errors.Errors.size(), 2u);
  EXPECT_NE(errors.Errors[1].find("inside out"), std::string::npos);
}

TEST(VolumeColors, AreResampledToTheVolume)
{
  const auto volume = MesoMakeVolume({ 4, 2, 2 }, 0.5, std::vector<float>(16, 1.f));
  EXPECT_EQ(MesoVolumeColors(volume), nullptr);
  const auto colors = [](int type, int components, double red)
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(8, 2, 2);
    image->AllocateScalars(type, components);
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      for (int k = 0; k < components; ++k)
      {
        // Red in the tile's right half, green everywhere, blue none.
        image->GetPointData()->GetScalars()->SetComponent(
          i, k, k == 0 ? (i % 8 < 4 ? 0. : red) : (k == 1 ? red : 0.));
      }
    }
    return image;
  };
  const std::pair<int, double> types[] = { { VTK_UNSIGNED_CHAR, 255. },
    { VTK_UNSIGNED_SHORT, 65535. }, { VTK_FLOAT, 1. }, { VTK_DOUBLE, 7. } };
  for (const auto& [type, most] : types)
  {
    EXPECT_EQ(MesoSetVolumeColors(volume, colors(type, 4, most)), "");
    EXPECT_EQ(MesoVolumeProblem(volume), "");
    vtkFloatArray* result = MesoVolumeColors(volume);
    ASSERT_NE(result, nullptr);
    ASSERT_EQ(result->GetNumberOfTuples(), 16);
    for (int i = 0; i < 16; ++i)
    {
      // A tent of two samples' width: at the border it takes some of what is beside it.
      const double red = result->GetComponent(i, 0);
      EXPECT_TRUE(i % 4 < 2 ? red < 0.5 : red > 0.5 * std::min(most, 1.)) << type << " " << i;
      EXPECT_NEAR(result->GetComponent(i, 1), 1., 1e-6);
      EXPECT_EQ(result->GetComponent(i, 2), 0.);
    }
  }
  EXPECT_NE(MesoSetVolumeColors(volume, colors(VTK_FLOAT, 2, 1.)), "");
  EXPECT_NE(MesoSetVolumeColors(volume, colors(VTK_FLOAT, 3, std::nan(""))), "");
}
