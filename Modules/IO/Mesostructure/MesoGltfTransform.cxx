#include "MesoGltfTransform.h"

#include <cmath>

MesoGltfMatrix MesoGltfProduct(const MesoGltfMatrix& a, const MesoGltfMatrix& b)
{
  MesoGltfMatrix c{};
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      for (int k = 0; k < 4; ++k)
      {
        c[4 * row + column] += a[4 * row + k] * b[4 * k + column];
      }
    }
  }
  return c;
}

std::array<double, 9> MesoGltfCofactors(const MesoGltfMatrix& m)
{
  std::array<double, 9> c{};
  for (int i = 0; i < 3; ++i)
  {
    const int i1 = (i + 1) % 3;
    const int i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j)
    {
      const int j1 = (j + 1) % 3;
      const int j2 = (j + 2) % 3;
      c[3 * i + j] = m[4 * i1 + j1] * m[4 * i2 + j2] - m[4 * i1 + j2] * m[4 * i2 + j1];
    }
  }
  return c;
}

double MesoGltfDeterminant(const MesoGltfMatrix& m)
{
  const auto c = MesoGltfCofactors(m);
  return m[0] * c[0] + m[1] * c[1] + m[2] * c[2];
}

MesoGltfMatrix MesoGltfMatrixOfNode(const MesoSceneValue& node)
{
  MesoGltfMatrix matrix = MesoGltfIdentity;
  if (node.Has("matrix"))
  {
    const auto columns = node.At("matrix").ToNumbers<16>();
    for (int i = 0; i < 16; ++i)
    {
      matrix[i] = columns[4 * (i % 4) + i / 4];
    }
    return matrix;
  }
  std::array<double, 3> scale = { 1., 1., 1. };
  std::array<double, 4> q = { 0., 0., 0., 1. };
  node.With("scale", [&](const MesoSceneValue& value) { scale = value.ToNumbers<3>(); });
  node.With("rotation",
    [&](const MesoSceneValue& value)
    {
      q = value.ToNumbers<4>();
      const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
      if (!(length > 0.))
      {
        value.Fail("the quaternion is 0");
      }
      for (double& component : q)
      {
        component /= length;
      }
    });
  const auto [x, y, z, w] = q;
  const double rotation[9] = { 1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w),
    2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), 2 * (x * z - y * w),
    2 * (y * z + x * w), 1 - 2 * (x * x + y * y) };
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      matrix[4 * row + column] = rotation[3 * row + column] * scale[column];
    }
  }
  node.With("translation",
    [&](const MesoSceneValue& value)
    {
      const auto translation = value.ToNumbers<3>();
      for (int row = 0; row < 3; ++row)
      {
        matrix[4 * row + 3] = translation[row];
      }
    });
  return matrix;
}
