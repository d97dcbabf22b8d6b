#include "MesoViewMatrices.h"

#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLCamera.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

void MesoSetViewMatrices(vtkShaderProgram* program, vtkRenderer* renderer, vtkActor* actor,
  vtkMatrix4x4* bufferToModel, const double* centre)
{
  // A shader that needs no position (directional lights, neither occlusion nor depth) still needs
  // the normal.
  if (!program->IsUniformUsed("mesoMCVCMatrix") && !program->IsUniformUsed("mesoNormalMatrix") &&
    !program->IsUniformUsed("mesoModelToView") && !program->IsUniformUsed("mesoViewToModel"))
  {
    return;
  }
  // VTK hands these matrices out transposed, so that products read from model to view.
  auto* camera = static_cast<vtkOpenGLCamera*>(renderer->GetActiveCamera());
  vtkMatrix4x4* wcvc;
  vtkMatrix3x3* viewNormals;
  vtkMatrix4x4* vcdc;
  vtkMatrix4x4* wcdc;
  camera->GetKeyMatrices(renderer, wcvc, viewNormals, vcdc, wcdc);
  vtkMatrix4x4* mcwc;
  vtkMatrix3x3* modelNormals;
  static_cast<vtkOpenGLActor*>(actor)->GetKeyMatrices(mcwc, modelNormals);

  vtkNew<vtkMatrix4x4> mcvc;
  vtkNew<vtkMatrix3x3> normals;
  mcvc->DeepCopy(wcvc);
  normals->DeepCopy(viewNormals);
  if (!actor->GetIsIdentity())
  {
    vtkMatrix4x4::Multiply4x4(mcwc, wcvc, mcvc);
    vtkMatrix3x3::Multiply3x3(modelNormals, viewNormals, normals);
  }
  vtkNew<vtkMatrix3x3> linear;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      linear->SetElement(i, j, mcvc->GetElement(i, j));
    }
  }
  if (centre && program->IsUniformUsed("mesoBaseCentreVC"))
  {
    // Transposed: a point times the matrix. In double, so that a model far from its origin is right.
    float centreVC[3];
    for (int j = 0; j < 3; ++j)
    {
      double sum = mcvc->GetElement(3, j);
      for (int i = 0; i < 3; ++i)
      {
        sum += centre[i] * mcvc->GetElement(i, j);
      }
      centreVC[j] = static_cast<float>(sum);
    }
    program->SetUniform3f("mesoBaseCentreVC", centreVC);
  }
  if (bufferToModel)
  {
    vtkMatrix4x4::Multiply4x4(bufferToModel, mcvc, mcvc);
  }
  program->SetUniformMatrix("mesoMCVCMatrix", mcvc);
  program->SetUniformMatrix("mesoNormalMatrix", normals);
  if (program->IsUniformUsed("mesoModelToView"))
  {
    program->SetUniformMatrix("mesoModelToView", linear);
  }
  if (program->IsUniformUsed("mesoViewToModel"))
  {
    linear->Invert();
    program->SetUniformMatrix("mesoViewToModel", linear);
  }
  if (program->IsUniformUsed("mesoVCDCMatrix"))
  {
    program->SetUniformMatrix("mesoVCDCMatrix", vcdc);
  }
}
