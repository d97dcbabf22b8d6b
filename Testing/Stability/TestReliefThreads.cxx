// How many threads prepare a relief makes no difference: what filters compute of mesh and map, and the picture, are the
// same bytes.

#include "MesoBaseline.h"
#include "MesoReliefTechniques.h"

#include "MesoHeightPyramid.h"
#include "vtkMesoConeMap.h"
#include "vtkMesoQuadricFit.h"
#include "vtkMesoSurfaceFrames.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <cstring>

namespace
{
using Bytes = std::vector<unsigned char>;

void Append(Bytes& bytes, const void* from, std::size_t count)
{
  const auto* first = static_cast<const unsigned char*>(from);
  bytes.insert(bytes.end(), first, first + count);
}

/// Every number of the points and their arrays.
void Append(Bytes& bytes, vtkDataSet* data)
{
  for (int i = 0; i < data->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetPointData()->GetArray(i);
    Append(bytes, array->GetVoidPointer(0),
      std::size_t(array->GetNumberOfValues()) * std::size_t(array->GetDataTypeSize()));
  }
}

/// What is computed of a mesh and a map before they are drawn.
Bytes Prepared()
{
  Bytes bytes;
  vtkNew<vtkMesoSurfaceFrames> frames;
  frames->SetInputData(MesoTestScene::Shape("torus"));
  vtkNew<vtkMesoQuadricFit> quadrics;
  quadrics->SetInputConnection(frames->GetOutputPort());
  quadrics->Update();
  Append(bytes, quadrics->GetOutput());
  Append(bytes, MesoTestScene::BaseImage(quadrics->GetOutput()));
  const auto map = MesoTestScene::Pattern("stone", 100, 60);
  Append(bytes, map);
  vtkNew<vtkMesoConeMap> cones;
  cones->SetInputData(map);
  cones->Update();
  Append(bytes, cones->GetOutput());
  const auto* heights = static_cast<const float*>(map->GetScalarPointer());
  for (const MesoHeightLevel& level : MesoMakeHeightPyramid(100, 60, heights))
  {
    Append(bytes, level.Heights.data(), level.Heights.size() * sizeof(float));
  }
  return bytes;
}

Bytes Drawn(const MesoReliefArm& arm)
{
  MesoTestScene scene(80, 80);
  vtkNew<vtkMesoReliefMapper> mapper;
  mapper->SetHeightMap(MesoTestScene::Pattern("stone", 100, 60));
  MesoUse(mapper, arm, MesoTestScene::Shape("torus"));
  MesoMesostructureOptions options = mapper->GetOptions();
  options.Scale = 0.08;
  options.Tiles = { 6., 3. };
  options.Search = MesoSearch::Cone;
  mapper->SetOptions(options);
  scene.Actor->SetMapper(mapper);
  scene.AddDirectionalLight(-1., -2., -1.);
  scene.LookFrom(1., 3., 5.);
  const auto picture = MesoGrabWindow(scene.Window);
  Bytes bytes;
  Append(bytes, picture);
  return bytes;
}

/// What some threads make.
template <typename Make>
Bytes With(int threads, const Make& make)
{
  Bytes bytes;
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads }, [&]() { bytes = make(); });
  return bytes;
}
}

TEST(ReliefThreads, PrepareTheSameNumbers)
{
  const Bytes one = With(1, &Prepared);
  EXPECT_GT(one.size(), 100000u);
  EXPECT_TRUE(With(2, &Prepared) == one);
  EXPECT_TRUE(With(7, &Prepared) == one);
}

TEST(ReliefThreads, DrawTheSamePicture)
{
  const auto draw = [] { return Drawn({ MesoTechnique::ReliefQuadric, MesoCurvedKind::Surface }); };
  const Bytes one = With(1, draw);
  EXPECT_EQ(one.size(), 3u * 80u * 80u);
  EXPECT_TRUE(With(2, draw) == one);
  EXPECT_TRUE(With(7, draw) == one);
}
