/**
 * @class vtkMesoPicker
 * @brief What lies under a pixel, on the relief that is drawn there: position, map coordinate, height.
 *
 *     vtkNew<vtkMesoPicker> picker;
 *     if (picker->Pick(x, y, 0., renderer)) // display coordinates, as interactors give them
 *     {
 *       picker->GetPickPosition(position); // on the detail, not on the base mesh
 *       double metres = picker->GetMapNumber();
 *     }
 *
 * Renders the scene once more as numbers (vtkMesoAOVPass), at the centre of the pixel, so that what is
 * picked is what is seen there; the picture in the window stays. Translucent actors are picked as if
 * they were opaque; actors whose Pickable flag is off hide what lies behind them but are not picked.
 * Actors of other mappers are picked by their own depth and have no map.
 *
 * Works as an interactor's picker (vtkRenderWindowInteractor::SetPicker), with the events of
 * vtkAbstractPicker.
 */

#ifndef vtkMesoPicker_h
#define vtkMesoPicker_h

#include "mesoRenderingMesostructureModule.h" // for export macro
#include "vtkAbstractPropPicker.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkAssemblyPath;
class vtkMesoAOVPass;
class vtkMesoPolyDataMapper;
class vtkWindow;

class MESORENDERINGMESOSTRUCTURE_EXPORT vtkMesoPicker : public vtkAbstractPropPicker
{
public:
  static vtkMesoPicker* New();
  vtkTypeMacro(vtkMesoPicker, vtkAbstractPropPicker);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Pick at a pixel, in display coordinates; the third is not looked at. 1 where an actor is picked.
  int Pick(double selectionX, double selectionY, double selectionZ, vtkRenderer* renderer) override;
  using vtkAbstractPropPicker::Pick;

  /// Whether the actor has relief: the numbers of the map below are of it. GetActor() and
  /// GetPickPosition() (world) are always there.
  bool GetHasMap() const { return this->HasMap; }

  ///@{
  /// Map coordinate at the hit: the mesh's own times tiles, not wrapped. 0, 0 without a map.
  vtkGetVector2Macro(MapCoordinate, double);
  ///@}

  /// Height at the hit, in [0,1]: 0 at the deepest point, 1 at the base mesh.
  double GetHeight() const { return this->Height; }

  /// The same as a number of the map's file (vtkMesoPolyDataMapper::SetMapNumbers).
  double GetMapNumber() const { return this->MapNumber; }

  ///@{
  /// Unit normal for shading at the hit, world space. 0 for actors of other mappers.
  vtkGetVector3Macro(PickNormal, double);
  ///@}

  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkMesoPicker();
  ~vtkMesoPicker() override;

  void Initialize() override;

private:
  vtkMesoPicker(const vtkMesoPicker&) = delete;
  void operator=(const vtkMesoPicker&) = delete;

  /// Render the numbers. Gives the paths of the actors, that of number n at n - 1.
  std::vector<vtkSmartPointer<vtkAssemblyPath>> Capture(vtkRenderer* renderer);
  void TakeNumbers(vtkMesoPolyDataMapper* mapper, int column, int row);

  vtkNew<vtkMesoAOVPass> Pass;
  bool HasMap = false;
  double MapCoordinate[2] = { 0., 0. };
  double Height = 0.;
  double MapNumber = 0.;
  double PickNormal[3] = { 0., 0., 0. };
};

#endif
