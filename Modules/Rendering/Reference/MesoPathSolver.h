#ifndef MesoPathSolver_h
#define MesoPathSolver_h

/**
 * @file MesoPathSolver.h
 * @brief The first meeting of a path with a bilinear height map, in closed form, none missed.
 *
 * A technique's model takes the view ray as a path that is straight over the map and a parabola in
 * depth (Shaders/Kernels/LinearBinarySearch.glsl, HeightPath). Cut at the lines through texel
 * centres, each piece lies over one bilinear patch, along which the height is a quadratic of the
 * path's part: the clearance is one as well, and its first root is found without a search.
 */

#include "MesoKernels.h"

using MesoModelField = MesoKernels::Double::HeightField;
using MesoModelPath = MesoModelField::HeightPath;

/// Patches that a path may run over; past these it counts as meeting nothing.
constexpr long MesoMostPatches = 10000000;

/// The least part w in [0, 1] at which the path lies on or below the relief; 2 where it never does.
double MesoFirstMeeting(const MesoModelField& field, const MesoModelPath& path);

/// Whether the path runs below the relief anywhere before its end.
bool MesoIsBlocked(const MesoModelField& field, const MesoModelPath& path);

#endif
