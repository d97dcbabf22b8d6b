#ifndef MesoClosedMesh_h
#define MesoClosedMesh_h

class vtkPolyData;

/// Whether every edge of the polygons has one on its other side, so that no ray comes in from behind
/// without passing a front first. Points are taken together by the array MesoVertex where there is
/// one (vtkMesoSurfaceFrames), since seams split them. False for strips and for no polygons.
bool MesoIsClosed(vtkPolyData* mesh);

#endif
