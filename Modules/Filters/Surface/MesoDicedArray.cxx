#include "MesoDicedArray.h"

#include "vtkDataArray.h"

vtkSmartPointer<vtkDataArray> MesoDicedArray(
  const MesoDicePlan& plan, const MesoTriangleMesh& mesh, vtkDataArray* array, int type)
{
  const auto diced = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  const int components = array->GetNumberOfComponents();
  diced->SetName(array->GetName());
  diced->SetNumberOfComponents(components);
  diced->SetNumberOfTuples(plan.NumberOfPoints());
  const auto set = [&](
                     std::int64_t to, const std::array<std::int64_t, 3>& points, double i, double j)
  {
    for (int k = 0; k < components; ++k)
    {
      const double value = (1. - i - j) * array->GetComponent(points[0], k) +
        i * array->GetComponent(points[1], k) + j * array->GetComponent(points[2], k);
      diced->SetComponent(to, k, value);
    }
  };
  for (vtkIdType point = 0; point < array->GetNumberOfTuples(); ++point)
  {
    if (plan.NumberOf(point) >= 0)
    {
      set(plan.NumberOf(point), { point, point, point }, 0., 0.);
    }
  }
  for (const MesoDicePlan::Side& side : plan.GetSides())
  {
    for (std::int64_t segment = 1; segment < side.Segments; ++segment)
    {
      const double along = static_cast<double>(segment) / static_cast<double>(side.Segments);
      set(plan.PointOn(side, segment), { side.Ends[0], side.Ends[1], side.Ends[0] }, along, 0.);
    }
  }
  for (const MesoDicePlan::Grid& grid : plan.GetGrids())
  {
    const std::int64_t corner = 3 * grid.Triangle;
    const std::array<std::int64_t, 3> points = { mesh.PointOf(corner), mesh.PointOf(corner + 1),
      mesh.PointOf(corner + 2) };
    for (std::int64_t row = 0; row < grid.Rows; ++row)
    {
      for (std::int64_t place = 0; place < grid.Inside(row); ++place)
      {
        const MesoDicePlan::Inner inner = MesoDicePlan::InnerAt(grid, row, place);
        set(inner.Point, points, inner.I, inner.J);
      }
    }
  }
  return diced;
}
