#ifndef FiguresJson_h
#define FiguresJson_h

#include "MesoFrameCost.h"
#include "MesoImageError.h"

#include <nlohmann/json.hpp>

/**
 * All figures of error by name (MesoFiguresOfError()), null where not known; `depth_unit`; with AOVs
 * also `worst_depth` and `worst_texcoord` (column, row of the pixel, row 0 = top) and `objects`, the
 * figures of depth and texture coordinate of each.
 */
nlohmann::ordered_json JsonOfError(const MesoImageError& error);

/// `median`, `min` and `max`.
nlohmann::ordered_json JsonOfMilliseconds(const MesoMilliseconds& milliseconds);

#endif
