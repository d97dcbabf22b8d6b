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
 *   MesoKernels::Float::LevelChoice, MesoKernels::Double::LevelChoice
 *     levelsOfPixel: which levels of a height map's pyramid a pixel sees; roughnessOfLevel: what they lack
 *   MesoKernels::Float::RoughRelief, MesoKernels::Double::RoughRelief
 *     hiddenPerSeen, litShare, meanCosine: how what they lack shades
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

#define MESO_KERNEL_FILE(file) #file
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic error "-Wdouble-promotion" // the float copy is float throughout
#endif
namespace Float
{
using Real = float;
using RealVec2 = vec2;
#define MESO_KERNEL(name) MESO_KERNEL_FILE(Meso##name##Float.h)
#include "MesoKernelClasses.h"
#undef MESO_KERNEL
}
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace Double
{
using Real = double;
using RealVec2 = dvec2;
#define MESO_KERNEL(name) MESO_KERNEL_FILE(Meso##name##Double.h)
#include "MesoKernelClasses.h"
#undef MESO_KERNEL
}

#undef MESO_KERNEL_FILE

static_assert(Float::HeightField::WrapRepeat == static_cast<int>(MesoWrap::Repeat) &&
    Float::HeightField::WrapClamp == static_cast<int>(MesoWrap::Clamp) &&
    Float::HeightField::WrapMirror == static_cast<int>(MesoWrap::Mirror),
  "MesoWrap counts as the kernels do");
}

#endif
