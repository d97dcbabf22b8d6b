#ifndef MesoActorView_h
#define MesoActorView_h

#include "MesoGridBase.h" // for MesoGridView

class vtkActor;
class vtkRenderer;

/// How an actor is seen in what is being drawn: by the renderer's camera, in the viewport that is set.
MesoGridView MesoViewOfActor(vtkRenderer* renderer, vtkActor* actor);

#endif
