#ifndef MesoChartOverlap_h
#define MesoChartOverlap_h

/**
 * @file MesoChartOverlap.h
 * @brief How much of texture space triangles cover twice.
 */

#include <array>
#include <optional>
#include <vector>

using MesoTextureTriangle = std::array<std::array<double, 2>, 3>;

/// Twice the signed area, positive where the corners run counter-clockwise.
double MesoTwiceArea(const MesoTextureTriangle& triangle);

/**
 * Part of the texture space covered by triangles that two or more of them cover, from 0 to 1, found
 * at 512 x 512 places of their bounding rectangle; nothing where that takes more than 50 million
 * steps.
 */
std::optional<double> MesoChartOverlap(const std::vector<MesoTextureTriangle>& triangles);

#endif
