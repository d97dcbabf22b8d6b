/**
 * @file MesoKernelClasses.h
 * @brief The classes of MesoKernels.h, which includes this twice: in float and in double.
 *
 * Real and RealVec2 are the numbers, MESO_KERNEL(Name) the file of a kernel's copy. No guard: once for each.
 */

// clang-format off: kernels are included in the order in which they need one another
class Contour
{
public:
#include MESO_KERNEL(Contour)
};

class Frame
{
public:
#include MESO_KERNEL(Frame)
};

class Grid
{
public:
#include MESO_KERNEL(BarycentricGrid)
#include MESO_KERNEL(DisplacedNormal)
};

class Quadric
{
public:
#include MESO_KERNEL(Quadric)
};

class QuadricExact : public Quadric
{
public:
#include MESO_KERNEL(QuadricExact)
};

class GDMFactors : public MesoGDMTexels<Real>
{
public:
  using MesoGDMTexels<Real>::MesoGDMTexels;
#include MESO_KERNEL(GDMTable)
#include MESO_KERNEL(GDMFactors)
};

class GDMWhole : public MesoGDMTexels<Real>
{
public:
  using MesoGDMTexels<Real>::MesoGDMTexels;
#include MESO_KERNEL(GDMTable)
#include MESO_KERNEL(GDMWhole)
};

class Horizon
{
public:
#include MESO_KERNEL(Horizon)
};

class LevelChoice
{
public:
#include MESO_KERNEL(LevelChoice)
};

class RoughRelief
{
public:
#include MESO_KERNEL(RoughRelief)
};

class PrismGeometry
{
public:
#include MESO_KERNEL(Prism)
};

class Volume : public MesoVolumeTexture<Real>
{
public:
  using MesoVolumeTexture<Real>::MesoVolumeTexture;
#include MESO_KERNEL(Volume)
};

class VDMTable
{
public:
#include MESO_KERNEL(VDMTable)
};

class HeightField : public MesoHeightTexture<Real>
{
public:
  using MesoHeightTexture<Real>::MesoHeightTexture;
#include MESO_KERNEL(HeightBilinear)
#include MESO_KERNEL(HeightField)
#include MESO_KERNEL(HeightLevels)
  Real surfaceHeight(RealVec2 uv) const
  {
    return this->heightOfLevel(uv, this->surfaceLevel());
  }
#include MESO_KERNEL(HeightPath)
#include MESO_KERNEL(HeightHit)
#include MESO_KERNEL(PathCut)
#include MESO_KERNEL(LinearSearch)
#include MESO_KERNEL(LinearBinarySearch)
#include MESO_KERNEL(LinearSecantSearch)
#include MESO_KERNEL(ConeTexel)
#include MESO_KERNEL(HeightCone)
#include MESO_KERNEL(CertifiedSearch)
#include MESO_KERNEL(ConeSearch)
};

class BicubicField : public MesoHeightTexture<Real>
{
public:
  using MesoHeightTexture<Real>::MesoHeightTexture;
#include MESO_KERNEL(HeightBicubic)
#include MESO_KERNEL(HeightField)
  Real surfaceHeight(RealVec2 uv) const
  {
    return this->mapHeight(uv);
  }
  Real sampleHeight(RealVec2 uv) const
  {
    return this->mapHeight(uv);
  }
#include MESO_KERNEL(HeightPath)
#include MESO_KERNEL(HeightHit)
#include MESO_KERNEL(LinearSearch)
#include MESO_KERNEL(LinearBinarySearch)
#include MESO_KERNEL(LinearSecantSearch)
};

class AcrossField
  : public MesoHeightTexture<Real>
  , public QuadricExact
{
public:
  using MesoHeightTexture<Real>::MesoHeightTexture;
#include MESO_KERNEL(HeightBilinear)
#include MESO_KERNEL(HeightField)
  Real surfaceHeight(RealVec2 uv) const
  {
    return this->mapHeight(uv);
  }
#include MESO_KERNEL(AcrossPath)
#include MESO_KERNEL(HeightHit)
#include MESO_KERNEL(PathCut)
#include MESO_KERNEL(LinearSearch)
#include MESO_KERNEL(LinearBinarySearch)
};

class CircleField
  : public MesoHeightTexture<Real>
  , public Quadric
{
public:
  using MesoHeightTexture<Real>::MesoHeightTexture;
#include MESO_KERNEL(HeightBilinear)
#include MESO_KERNEL(HeightField)
  Real surfaceHeight(RealVec2 uv) const
  {
    return this->mapHeight(uv);
  }
#include MESO_KERNEL(CirclePath)
#include MESO_KERNEL(HeightHit)
#include MESO_KERNEL(PathCut)
#include MESO_KERNEL(LinearSearch)
#include MESO_KERNEL(LinearBinarySearch)
};

class CubicField : public MesoHeightTexture<Real>
{
public:
  using MesoHeightTexture<Real>::MesoHeightTexture;
#include MESO_KERNEL(HeightBilinear)
#include MESO_KERNEL(HeightField)
#include MESO_KERNEL(HeightLevels)
  Real surfaceHeight(RealVec2 uv) const
  {
    return this->mapHeight(uv);
  }
#include MESO_KERNEL(CubicPath)
#include MESO_KERNEL(HeightHit)
#include MESO_KERNEL(PathCut)
#include MESO_KERNEL(LinearSearch)
#include MESO_KERNEL(LinearBinarySearch)
#include MESO_KERNEL(ConeTexel)
#include MESO_KERNEL(CubicCone)
#include MESO_KERNEL(ConeSearch)
};
// clang-format on
