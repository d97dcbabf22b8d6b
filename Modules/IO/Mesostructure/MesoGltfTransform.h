#ifndef MesoGltfTransform_h
#define MesoGltfTransform_h

/**
 * @file MesoGltfTransform.h
 * @brief Where the nodes of a glTF file stand: their matrices, and what those do to normals.
 */

#include "MesoSceneValue.h"

#include <array>

/// Row-major; points are columns.
using MesoGltfMatrix = std::array<double, 16>;

constexpr MesoGltfMatrix MesoGltfIdentity = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };

MesoGltfMatrix MesoGltfProduct(const MesoGltfMatrix& a, const MesoGltfMatrix& b);

/// Cofactors of the matrix' upper left 3 x 3: the inverse transposed times the determinant.
std::array<double, 9> MesoGltfCofactors(const MesoGltfMatrix& m);

/// Of the upper left 3 x 3: negative where the node is mirrored.
double MesoGltfDeterminant(const MesoGltfMatrix& m);

/// A node's `matrix`, or else the product of its `translation`, `rotation` and `scale` (glTF 2.0, section 3.5.2).
/// Throws MesoInputError at the value that is wrong.
MesoGltfMatrix MesoGltfMatrixOfNode(const MesoSceneValue& node);

#endif
