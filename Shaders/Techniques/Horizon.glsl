// What blocks light in horizon mapping: Max1988 (Documentation/Techniques/References.md). The table is over
// the map, so that it holds on any chart: a light's direction is solved for steps over the map and in
// depth, whose azimuth and slope are compared with the table's. Completes Common/HorizonLight; stands on
// Common/ReliefFrame and Kernels/Horizon.

uniform sampler3D mesoHorizonMap;  // a slice an azimuth: angles, radians
uniform float mesoHorizonScale;    // depth of the relief, in tiles, over which they are measured
uniform float mesoPenumbra;        // the light's diameter, radians

// At the middle of a slice, where the sampler gives the slice alone.
float horizonAngle(vec2 mapCoord, int azimuth, int count)
{
  return textureLod(mesoHorizonMap, vec3(mapCoord, (float(azimuth) + 0.5) / float(count)), 0.0).r;
}

float horizonBlocks(MesoFragment f, MesoSurfaceHit hit, vec3 lightOutVC, out int fetches)
{
  fetches = 0;
  vec3 rate;
  if (!directionInTS(f, lightOutVC, rate))
  {
    return 0.0; // no relief here
  }
  float run = length(rate.x * f.PerMapU + rate.y * f.PerMapV);
  if (!(run > 0.0))
  {
    return rate.z < 0.0 ? 0.0 : 1.0; // straight above or below
  }
  int count = textureSize(mesoHorizonMap, 0).z;
  float weight;
  int before = azimuthBefore(rate.xy, count, weight);
  float angle = mix(horizonAngle(hit.MapCoord, before, count),
    horizonAngle(hit.MapCoord, azimuthAfter(before, count), count), weight);
  fetches = 2;
  if (!(angle > 0.0))
  {
    return 0.0; // nothing stands above the plane: the facet has decided
  }
  // From the table's slope to that of this place: heights a tile, then object units.
  float depth = length(f.PerDepth);
  float horizonRise = tan(angle) / mesoHorizonScale * length(rate.xy) * depth;
  float horizon = atan(horizonRise, run);
  // The plane itself is no horizon: where the relief does not rise above it there is no edge to fade.
  return discBelow(atan(-rate.z * depth, run), horizon, min(mesoPenumbra, 2.0 * horizon));
}
