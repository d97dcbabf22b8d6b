#include "MesoContourLines.h"

#include <algorithm>
#include <cmath>

std::string MesoContourLines::Problem() const
{
  if (this->Spacing != 0. && !(this->Spacing >= LeastSpacing && std::isfinite(this->Spacing)))
  {
    return "the spacing of contour lines must be 0 or at least 1e-5 of the relief's depth";
  }
  if (!std::isfinite(this->Offset) ||
    !std::all_of(this->Heights.begin(), this->Heights.end(),
      [](double height) { return std::isfinite(height); }))
  {
    return "heights of contour lines must be finite numbers";
  }
  if (this->Heights.size() > MostHeights)
  {
    return "at most " + std::to_string(MostHeights) +
      " contour lines can be given one by one; got " + std::to_string(this->Heights.size());
  }
  if (!(this->Width > 0. && this->Width <= MostWidth))
  {
    return "the width of contour lines must be above 0 and at most 64 pixels";
  }
  return {};
}
