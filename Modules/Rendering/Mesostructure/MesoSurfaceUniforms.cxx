#include "MesoSurfaceUniforms.h"

#include "MesoContourLines.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <vector>

void MesoSetContourUniforms(vtkShaderProgram* program, const MesoContourLines& lines)
{
  if (!program->IsUniformUsed("mesoContourColor"))
  {
    return;
  }
  const float color[3] = { static_cast<float>(lines.Color[0]), static_cast<float>(lines.Color[1]),
    static_cast<float>(lines.Color[2]) };
  program->SetUniform3f("mesoContourColor", color);
  program->SetUniformf("mesoContourWidth", static_cast<float>(lines.Width));
  program->SetUniformf("mesoContourSpacing", static_cast<float>(lines.Spacing));
  program->SetUniformf("mesoContourOffset", static_cast<float>(lines.Offset));
  if (!lines.Heights.empty())
  {
    const std::vector<float> heights(lines.Heights.begin(), lines.Heights.end());
    program->SetUniform1fv("mesoContourHeights", static_cast<int>(heights.size()), heights.data());
  }
}

void MesoSetClipUniforms(
  vtkShaderProgram* program, vtkPlaneCollection* planes, vtkRenderer* renderer)
{
  if (!program->IsUniformUsed("mesoClipPlanes"))
  {
    return;
  }
  vtkMatrix4x4* view = renderer->GetActiveCamera()->GetModelViewTransformMatrix();
  float equations[MesoMostClippingPlanes][4];
  const int count = std::min(planes->GetNumberOfItems(), MesoMostClippingPlanes);
  for (int i = 0; i < count; ++i)
  {
    vtkPlane* plane = planes->GetItem(i);
    const double* origin = plane->GetOrigin();
    const double* normal = plane->GetNormal();
    const double point[4] = { origin[0], origin[1], origin[2], 1. };
    double pointVC[4];
    view->MultiplyPoint(point, pointVC);
    double distance = 0.;
    for (int row = 0; row < 3; ++row)
    {
      // The view turns and moves, so normals go as directions do.
      double turned = 0.;
      for (int column = 0; column < 3; ++column)
      {
        turned += view->GetElement(row, column) * normal[column];
      }
      equations[i][row] = static_cast<float>(turned);
      distance -= turned * pointVC[row];
    }
    equations[i][3] = static_cast<float>(distance);
  }
  program->SetUniformi("mesoClipPlaneCount", count);
  program->SetUniform4fv("mesoClipPlanes", count, equations);
}
