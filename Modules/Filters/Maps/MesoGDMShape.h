#ifndef MesoGDMShape_h
#define MesoGDMShape_h

#include "mesoFiltersMapsModule.h" // for export macro

#include <array>
#include <string>

class vtkImageData;

/// What a table of vtkMesoGDMTable says of itself.
struct MESOFILTERSMAPS_EXPORT MesoGDMShape
{
  std::array<int, 3> Size = { 0, 0, 0 }; ///< W, H, D
  int Azimuths = 0;
  int Polars = 0;
  bool Even = false; ///< equal steps of cos(theta)
  double Reach = 0.; ///< tile widths
  int Rank = 0;      ///< products; 0: the whole table
  double Depth = 0.; ///< F

  /// Of a table in which MesoGDMTableProblem() finds nothing wrong.
  static MesoGDMShape Of(vtkImageData* table);
};

/// What keeps an image from being a table of vtkMesoGDMTable, or an empty text.
MESOFILTERSMAPS_EXPORT std::string MesoGDMTableProblem(vtkImageData* table);

#endif
