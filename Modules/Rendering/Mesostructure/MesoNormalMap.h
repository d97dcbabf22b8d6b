#ifndef MesoNormalMap_h
#define MesoNormalMap_h

/// What the directions of a normal map are relative to.
enum class MesoNormalSpace
{
  /// The unit directions of dp/du and dp/dv, which need be neither orthogonal nor right-handed, and n:
  /// the slopes along them are -x/z and -y/z. In an orthogonal chart that is the usual tangent space.
  Tangent,
  /// The object's axes. The map lies on the mesh's own texture coordinates, whatever the tiles.
  Object,
  /// A flat map: the slopes dh/du and dh/dv are -x/z and -y/z, over Depth. Each place of a mesh stretches
  /// them as it does the heights.
  Relief
};

/**
 * What a normal map's numbers mean. Stored are three components, of unsigned char or unsigned short
 * for [-1,1], or of float, which are the direction itself; row 0 lies at t = 0.
 */
struct MesoNormalMapMeaning
{
  MesoNormalSpace Space = MesoNormalSpace::Tangent;
  bool Down = false;  ///< green grows towards smaller t (DirectX), else towards larger t (OpenGL)
  double Depth = 0.0; ///< of Relief: the deepest point, in widths of a tile
};

#endif
