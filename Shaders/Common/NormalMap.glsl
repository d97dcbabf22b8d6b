// The shading normal out of a normal map, in place of the technique's own.
//   MESO_NORMAL_TANGENT  it is relative to the unit directions of dp/du, dp/dv and n,
//   MESO_NORMAL_OBJECT   to the object's axes,
//   MESO_NORMAL_RELIEF   or to a flat map whose heights are mesoNormalScale tiles deep
// Stands on Common/ReliefFrame, but for object space.

uniform sampler2D mesoNormalMap;
uniform vec3 mesoNormalFactor; // of the stored numbers
uniform vec3 mesoNormalShift;  // added to them
#if defined(MESO_NORMAL_RELIEF)
uniform float mesoNormalScale;
#elif !defined(MESO_NORMAL_OBJECT)
in vec2 mesoTileScaleVSOutput; // object units per unit of the mesh's own coordinate
#endif

// Green up, at a map coordinate; perTile: the map's own coordinates to one.
vec3 storedNormal(vec2 at, vec2 perTile)
{
#ifdef MESO_AOV
  vec3 stored = textureLod(mesoNormalMap, at, 0.0).xyz; // numbers are those of the map itself
#else
  vec3 stored = textureGrad(mesoNormalMap, at, perTile * mesoMapDx, perTile * mesoMapDy).xyz;
#endif
  return stored * mesoNormalFactor + mesoNormalShift;
}

// The base mesh's own where it is seen from behind, and where the map holds no direction.
void mapNormal(MesoFragment f, inout MesoSurfaceHit hit)
{
#ifdef MESO_NORMAL_OBJECT
  // The map lies on the mesh's own coordinates, once: it knows each point of the mesh.
  vec3 stored = storedNormal(hit.MapCoord / mesoTiles, 1.0 / mesoTiles);
  vec3 normal = mesoNormalMatrix * stored;
  bool behind = !gl_FrontFacing;
#else
  vec3 stored = storedNormal(hit.MapCoord, vec2(1.0));
  vec3 inward = mesoModelToView * -normalize(mesoNormalMCVSOutput);
  bool behind = dot(inward, f.NormalVC) > 0.0;
  // A normal gives the slopes -x/z and -y/z; times z, so that z may be 0.
  vec3 slopes = vec3(-stored.xy, stored.z);
  MesoFragment frame = f;
#ifdef MESO_NORMAL_RELIEF
  slopes.xy /= mesoNormalScale;
#else
  frame.PerMapU *= mesoTiles.x / mesoTileScaleVSOutput.x;
  frame.PerMapV *= mesoTiles.y / mesoTileScaleVSOutput.y;
  frame.PerDepth = inward;
#endif
  vec3 normal = normalOfCross(frame, slopes);
#endif
  hit.Fetches += 1;
  hit.TexelReads += 4;
  float size = dot(normal, normal);
  if (!behind && size > 0.0 && size < 1.0e30 && dot(stored, stored) > 0.0)
  {
    hit.NormalVC = normalize(normal);
  }
}
