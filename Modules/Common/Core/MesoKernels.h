#ifndef MesoKernels_h
#define MesoKernels_h

/**
 * @file MesoKernels.h
 * @brief The shaders' kernels (Shaders/Kernels) on the CPU, in float and in double.
 *
 * The same text as the shaders': each function's meaning, spaces, units and source stand there.
 *   MesoKernels::Float::Contour, MesoKernels::Double::Contour
 *     evenContours, oneContour
 *   MesoKernels::Float::Grid, MesoKernels::Double::Grid
 *     latticePoint, stepOnEdge, perMapCoord, displacedNormal
 *   MesoKernels::Float::Frame, MesoKernels::Double::Frame
 *     solveFrame, tiltedNormal
 *   MesoKernels::Float::GDMFactors, GDMWhole and those of Double
 *     a table of distances through a volume (constructed as MesoGDMTexels), as factors or whole, with
 *     gdmLevel, gdmAzimuth, gdmPolar and gdmDistance
 *   MesoKernels::Float::HeightField, MesoKernels::Double::HeightField
 *     a height map (constructed as MesoHeightTexture) with wrapTexel, bilinearHeight,
 *     heightGradient, patchGradient, searchLinearBinary, searchLinearSecant, occludedLinear, and the
 *     structs HeightPath (made by straightPath and bentPath) and HeightHit; once it has cones (SetCones)
 *     also searchCone, occludedCone, searchCertified, occludedCertified
 *   MesoKernels::Float::BicubicField, MesoKernels::Double::BicubicField
 *     a height map whose surface is a cubic B-spline: mapHeight, mapFacet, the searches by equal steps
 *   MesoKernels::Float::Horizon, MesoKernels::Double::Horizon
 *     azimuthBefore, azimuthAfter, discBelow
 *   MesoKernels::Float::Quadric, MesoKernels::Double::Quadric
 *     quadricOverTexture, quadricDepth, quadricGradient, distanceToQuadric, leaveShell,
 *     quadricNormal, quadricNormalDerivative, displacedCross
 *   MesoKernels::Float::VDMTable, MesoKernels::Double::VDMTable
 *     what a table of distances over view and curvature holds: vdmDirection, vdmPoint, vdmNumber, ...
 *   MesoKernels::Float::AcrossField, CircleField, CubicField and those of Double
 *     a height map with paths of other kinds: depths across the view ray (acrossPath), below a
 *     circle (circlePath), cubics (cubicPath); with the functions of their bases
 *   MesoKernels::Float::QuadricExact, MesoKernels::Double::QuadricExact
 *     the same and acrossView, distanceAcross, leaveAcross
 *   MesoKernels::Float::PrismGeometry, MesoKernels::Double::PrismGeometry
 *     the structs Prism and PrismSpan; prismSpan, prismPlace, prismTangents, prismRates, prismNormal,
 *     prismFaceNormal
 *   MesoKernels::Float::Volume, MesoKernels::Double::Volume
 *     signed distances (constructed as MesoVolumeTexture) with exactDistance, volumeGradient,
 *     searchVolume
 *
 *   MesoKernels::Double::HeightField field(2, 1, MesoWrap::Repeat, { 0.f, 1.f });
 *   double height = field.bilinearHeight({ 0.5, 0.5 });
 *
 * All functions are const and keep no state. Code that includes this is to be compiled with
 * -ffp-contract=off, which linking to Meso::CommonCore sets, lest results differ with the machine.
 */

#include "MesoGDMTexels.h"
#include "MesoHeightTexture.h"
#include "MesoVolumeTexture.h"

namespace MesoKernels
{
// The names that GLSL has built in.
using glm::bvec2;
using glm::bvec3;
using glm::bvec4;
using glm::dmat2;
using glm::dmat3;
using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using glm::ivec2;
using glm::ivec3;
using glm::ivec4;
using glm::mat2;
using glm::mat3;
using glm::mat4;
using glm::vec2;
using glm::vec3;
using glm::vec4;

using glm::abs;
using glm::acos;
using glm::acosh;
using glm::all;
using glm::any;
using glm::asin;
using glm::asinh;
using glm::atan;
using glm::atanh;
using glm::ceil;
using glm::clamp;
using glm::cos;
using glm::cosh;
using glm::cross;
using glm::degrees;
using glm::determinant;
using glm::distance;
using glm::dot;
using glm::equal;
using glm::exp;
using glm::exp2;
using glm::faceforward;
using glm::floor;
using glm::fract;
using glm::greaterThan;
using glm::greaterThanEqual;
using glm::inverse;
using glm::inversesqrt;
using glm::isinf;
using glm::isnan;
using glm::length;
using glm::lessThan;
using glm::lessThanEqual;
using glm::log;
using glm::log2;
using glm::matrixCompMult;
using glm::max;
using glm::min;
using glm::mix;
using glm::mod;
using glm::modf;
using glm::normalize;
using glm::notEqual;
using glm::outerProduct;
using glm::pow;
using glm::radians;
using glm::reflect;
using glm::refract;
using glm::round;
using glm::roundEven;
using glm::sign;
using glm::sin;
using glm::sinh;
using glm::smoothstep;
using glm::sqrt;
using glm::step;
using glm::tan;
using glm::tanh;
using glm::transpose;
using glm::trunc;

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic error "-Wdouble-promotion" // the float copy is float throughout
#endif
namespace Float
{
class Contour
{
public:
#include "MesoContourFloat.h"
};

class Frame
{
public:
#include "MesoFrameFloat.h"
};

class Grid
{
public:
#include "MesoBarycentricGridFloat.h"
//
#include "MesoDisplacedNormalFloat.h"
};

class Quadric
{
public:
#include "MesoQuadricFloat.h"
};

class QuadricExact : public Quadric
{
public:
#include "MesoQuadricExactFloat.h"
};

class GDMFactors : public MesoGDMTexels<float>
{
public:
  using MesoGDMTexels<float>::MesoGDMTexels;
#include "MesoGDMTableFloat.h"
//
#include "MesoGDMFactorsFloat.h"
};

class GDMWhole : public MesoGDMTexels<float>
{
public:
  using MesoGDMTexels<float>::MesoGDMTexels;
#include "MesoGDMTableFloat.h"
//
#include "MesoGDMWholeFloat.h"
};

class Horizon
{
public:
#include "MesoHorizonFloat.h"
};

class PrismGeometry
{
public:
#include "MesoPrismFloat.h"
};

class Volume : public MesoVolumeTexture<float>
{
public:
  using MesoVolumeTexture<float>::MesoVolumeTexture;
#include "MesoVolumeFloat.h"
};

class VDMTable
{
public:
#include "MesoVDMTableFloat.h"
};

class HeightField : public MesoHeightTexture<float>
{
public:
  using MesoHeightTexture<float>::MesoHeightTexture;
#include "MesoHeightBilinearFloat.h"
#include "MesoHeightFieldFloat.h"
  float surfaceHeight(vec2 uv) const
  {
    return this->mapHeight(uv);
  }
//
#include "MesoHeightPathFloat.h"
//
#include "MesoHeightHitFloat.h"
//
#include "MesoPathCutFloat.h"
//
#include "MesoLinearSearchFloat.h"
//
#include "MesoLinearBinarySearchFloat.h"
#include "MesoLinearSecantSearchFloat.h"
//
#include "MesoHeightConeFloat.h"
//
#include "MesoCertifiedSearchFloat.h"
#include "MesoConeSearchFloat.h"
};

class BicubicField : public MesoHeightTexture<float>
{
public:
  using MesoHeightTexture<float>::MesoHeightTexture;
#include "MesoHeightBicubicFloat.h"
#include "MesoHeightFieldFloat.h"
  float surfaceHeight(vec2 uv) const
  {
    return this->mapHeight(uv);
  }
  float sampleHeight(vec2 uv) const
  {
    return this->mapHeight(uv);
  }
//
#include "MesoHeightPathFloat.h"
//
#include "MesoHeightHitFloat.h"
//
#include "MesoLinearSearchFloat.h"
//
#include "MesoLinearBinarySearchFloat.h"
#include "MesoLinearSecantSearchFloat.h"
};

class AcrossField
  : public MesoHeightTexture<float>
  , public QuadricExact
{
public:
  using MesoHeightTexture<float>::MesoHeightTexture;
#include "MesoHeightBilinearFloat.h"
#include "MesoHeightFieldFloat.h"
  float surfaceHeight(vec2 uv) const
  {
    return this->mapHeight(uv);
  }
//
#include "MesoAcrossPathFloat.h"
//
#include "MesoHeightHitFloat.h"
//
#include "MesoPathCutFloat.h"
//
#include "MesoLinearSearchFloat.h"
//
#include "MesoLinearBinarySearchFloat.h"
};

class CircleField
  : public MesoHeightTexture<float>
  , public Quadric
{
public:
  using MesoHeightTexture<float>::MesoHeightTexture;
#include "MesoHeightBilinearFloat.h"
#include "MesoHeightFieldFloat.h"
  float surfaceHeight(vec2 uv) const
  {
    return this->mapHeight(uv);
  }
//
#include "MesoCirclePathFloat.h"
//
#include "MesoHeightHitFloat.h"
//
#include "MesoPathCutFloat.h"
//
#include "MesoLinearSearchFloat.h"
//
#include "MesoLinearBinarySearchFloat.h"
};

class CubicField : public MesoHeightTexture<float>
{
public:
  using MesoHeightTexture<float>::MesoHeightTexture;
#include "MesoHeightBilinearFloat.h"
#include "MesoHeightFieldFloat.h"
  float surfaceHeight(vec2 uv) const
  {
    return this->mapHeight(uv);
  }
//
#include "MesoCubicPathFloat.h"
//
#include "MesoHeightHitFloat.h"
//
#include "MesoPathCutFloat.h"
//
#include "MesoLinearSearchFloat.h"
//
#include "MesoLinearBinarySearchFloat.h"
};
}
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace Double
{
class Contour
{
public:
#include "MesoContourDouble.h"
};

class Frame
{
public:
#include "MesoFrameDouble.h"
};

class Grid
{
public:
#include "MesoBarycentricGridDouble.h"
//
#include "MesoDisplacedNormalDouble.h"
};

class Quadric
{
public:
#include "MesoQuadricDouble.h"
};

class QuadricExact : public Quadric
{
public:
#include "MesoQuadricExactDouble.h"
};

class GDMFactors : public MesoGDMTexels<double>
{
public:
  using MesoGDMTexels<double>::MesoGDMTexels;
#include "MesoGDMTableDouble.h"
//
#include "MesoGDMFactorsDouble.h"
};

class GDMWhole : public MesoGDMTexels<double>
{
public:
  using MesoGDMTexels<double>::MesoGDMTexels;
#include "MesoGDMTableDouble.h"
//
#include "MesoGDMWholeDouble.h"
};

class Horizon
{
public:
#include "MesoHorizonDouble.h"
};

class PrismGeometry
{
public:
#include "MesoPrismDouble.h"
};

class Volume : public MesoVolumeTexture<double>
{
public:
  using MesoVolumeTexture<double>::MesoVolumeTexture;
#include "MesoVolumeDouble.h"
};

class VDMTable
{
public:
#include "MesoVDMTableDouble.h"
};

class HeightField : public MesoHeightTexture<double>
{
public:
  using MesoHeightTexture<double>::MesoHeightTexture;
#include "MesoHeightBilinearDouble.h"
#include "MesoHeightFieldDouble.h"
  double surfaceHeight(dvec2 uv) const
  {
    return this->mapHeight(uv);
  }
//
#include "MesoHeightPathDouble.h"
//
#include "MesoHeightHitDouble.h"
//
#include "MesoPathCutDouble.h"
//
#include "MesoLinearSearchDouble.h"
//
#include "MesoLinearBinarySearchDouble.h"
#include "MesoLinearSecantSearchDouble.h"
//
#include "MesoHeightConeDouble.h"
//
#include "MesoCertifiedSearchDouble.h"
#include "MesoConeSearchDouble.h"
};

class BicubicField : public MesoHeightTexture<double>
{
public:
  using MesoHeightTexture<double>::MesoHeightTexture;
#include "MesoHeightBicubicDouble.h"
#include "MesoHeightFieldDouble.h"
  double surfaceHeight(dvec2 uv) const
  {
    return this->mapHeight(uv);
  }
  double sampleHeight(dvec2 uv) const
  {
    return this->mapHeight(uv);
  }
//
#include "MesoHeightPathDouble.h"
//
#include "MesoHeightHitDouble.h"
//
#include "MesoLinearSearchDouble.h"
//
#include "MesoLinearBinarySearchDouble.h"
#include "MesoLinearSecantSearchDouble.h"
};

class AcrossField
  : public MesoHeightTexture<double>
  , public QuadricExact
{
public:
  using MesoHeightTexture<double>::MesoHeightTexture;
#include "MesoHeightBilinearDouble.h"
#include "MesoHeightFieldDouble.h"
  double surfaceHeight(dvec2 uv) const
  {
    return this->mapHeight(uv);
  }
//
#include "MesoAcrossPathDouble.h"
//
#include "MesoHeightHitDouble.h"
//
#include "MesoPathCutDouble.h"
//
#include "MesoLinearSearchDouble.h"
//
#include "MesoLinearBinarySearchDouble.h"
};

class CircleField
  : public MesoHeightTexture<double>
  , public Quadric
{
public:
  using MesoHeightTexture<double>::MesoHeightTexture;
#include "MesoHeightBilinearDouble.h"
#include "MesoHeightFieldDouble.h"
  double surfaceHeight(dvec2 uv) const
  {
    return this->mapHeight(uv);
  }
//
#include "MesoCirclePathDouble.h"
//
#include "MesoHeightHitDouble.h"
//
#include "MesoPathCutDouble.h"
//
#include "MesoLinearSearchDouble.h"
//
#include "MesoLinearBinarySearchDouble.h"
};

class CubicField : public MesoHeightTexture<double>
{
public:
  using MesoHeightTexture<double>::MesoHeightTexture;
#include "MesoHeightBilinearDouble.h"
#include "MesoHeightFieldDouble.h"
  double surfaceHeight(dvec2 uv) const
  {
    return this->mapHeight(uv);
  }
//
#include "MesoCubicPathDouble.h"
//
#include "MesoHeightHitDouble.h"
//
#include "MesoPathCutDouble.h"
//
#include "MesoLinearSearchDouble.h"
//
#include "MesoLinearBinarySearchDouble.h"
};
}

static_assert(Float::HeightField::WrapRepeat == static_cast<int>(MesoWrap::Repeat) &&
    Float::HeightField::WrapClamp == static_cast<int>(MesoWrap::Clamp) &&
    Float::HeightField::WrapMirror == static_cast<int>(MesoWrap::Mirror),
  "MesoWrap counts as the kernels do");
}

#endif
