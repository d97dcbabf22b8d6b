#ifndef MesoMapFromMesh_h
#define MesoMapFromMesh_h

/**
 * @class MesoMapFromMesh
 * @brief What vtkMesoMapFromMesh computes, texel by texel.
 */

#include "MesoDetailProjection.h"
#include "MesoFitInput.h"
#include "MesoTexelCover.h"

#include <functional>
#include <memory>

class MESOFILTERSSURFACE_EXPORT MesoMapFromMesh
{
public:
  enum State : unsigned char
  {
    NoChart,
    Met,
    Void,
    Fold
  };

  struct Options
  {
    int Width = 0;
    int Height = 0;
    double Reach = 0.; ///< > 0
    bool ByTexture = false;
    bool GeometricNormals = false;
    double SlopeLimit = 0.;
  };

  /// What is found for a texel. Weights are those of the detail's corners.
  struct Texel
  {
    State Found = NoChart;
    double Displacement = 0.;
    MesoVector NormalObject;
    MesoVector Normal;
    std::int64_t Triangle = -1;
    std::array<double, 3> Weights;
    double Drift = 0.;
    MesoVector Position; ///< of the base
  };

  /// Coordinates are a point each, of the detail only where the options go by texture.
  MesoMapFromMesh(const MesoFitInput& base, const std::vector<MesoTexturePoint>& baseCoordinates,
    const MesoFitInput& detail, const std::vector<MesoTexturePoint>& detailCoordinates,
    const Options& options);

  const MesoTexelCover& Cover() const { return this->Texels; }

  /// For any number of threads. Folds by slope are not looked for here.
  Texel Look(std::size_t texel) const;

  /// Whether the displacement jumps between two neighbouring texels.
  bool Jumps(const Texel& a, const Texel& b) const;

private:
  struct BasePoint
  {
    MesoVector Position;
    MesoVector Normal;    ///< unit, along which the detail is looked for
    MesoVector Tangent;   ///< unit direction of dp/du at right angles to the normal
    MesoVector Bitangent; ///< the same of dp/dv
  };
  BasePoint BaseAt(std::size_t texel) const;
  MesoVector DetailNormal(std::int64_t triangle, const std::array<double, 3>& weights) const;

  const MesoFitInput& Base;
  const std::vector<MesoTexturePoint>& BaseCoordinates;
  const MesoFitInput& Detail;
  Options Chosen;
  MesoTexelCover Texels;
  MesoTexelCover DetailTexels;                      ///< by texture
  std::unique_ptr<MesoDetailProjection> Projection; ///< by rays
};

#endif
