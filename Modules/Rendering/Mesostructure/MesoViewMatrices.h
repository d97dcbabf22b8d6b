#ifndef MesoViewMatrices_h
#define MesoViewMatrices_h

class vtkActor;
class vtkMatrix4x4;
class vtkRenderer;
class vtkShaderProgram;

/**
 * Set the uniforms that take points, directions and normals from the model to view coordinates
 * (mesoMCVCMatrix, mesoModelToView, mesoNormalMatrix) and from there to the device (mesoVCDCMatrix);
 * those that the program does not use are passed over.
 *
 * @param bufferToModel what the vertex buffer's own shift and scale are undone by, or null. Points in
 *   the buffer are moved by it; directions and lengths are not.
 * @param centre a point of the model that is set as mesoBaseCentreVC, or null
 */
void MesoSetViewMatrices(vtkShaderProgram* program, vtkRenderer* renderer, vtkActor* actor,
  vtkMatrix4x4* bufferToModel, const double* centre = nullptr);

#endif
