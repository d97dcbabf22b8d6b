// Clipping planes cut the relief that is seen, not the base mesh above it.

#include "MesoAOVChecks.h"
#include "MesoTiltedPlane.h"

#include "vtkPlane.h"

namespace
{
constexpr int Size = 90;

void Cut(vtkMesoReliefMapper* mapper, double x, double y, double z, double nx, double ny, double nz)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(x, y, z);
  plane->SetNormal(nx, ny, nz);
  mapper->AddClippingPlane(plane);
}
}

TEST(ClippingPlanes, CutWhereTheRayHits)
{
  // Constant height 1/4: the hit lies 3/4 of the travel aside from the base.
  MesoTiltedPlane scene(50., 0.2, MesoTestScene::Constant(0.25f), Size);
  scene.Capture();
  const auto before = scene.Pass->GetChannel("coverage");
  Cut(scene.Mapper, 0.05, 0., 0., 1., 0., 0.);
  Cut(scene.Mapper, 0., 0.1, 0., 0., -2., 0.);
  scene.Capture();
  int kept = 0;
  for (int row = 0; row < Size; ++row)
  {
    for (int column = 0; column < Size; ++column)
    {
      const double x = scene.EntryU(column) - 0.5 + 0.75 * scene.TravelU();
      const double y = scene.EntryV(row) - 0.5;
      if (std::abs(x - 0.05) < 1e-4 || std::abs(y - 0.1) < 1e-4)
      {
        continue;
      }
      const bool expected = before[std::size_t(row) * Size + column] > 0.f && x > 0.05 && y < 0.1;
      EXPECT_EQ(scene.Pass->GetValue("coverage", column, row), expected ? 1.f : 0.f)
        << column << " " << row;
      kept += expected ? 1 : 0;
    }
  }
  EXPECT_GT(kept, 500);
}
