// What lies between a point and a light, from the light's shadow map; spliced by the shadow pass.
//   MESO_SHADOW_LIGHTS, MESO_SHADOW_TILES  numbers of lights that are on and of their views
// The maps are squares of one texture. Depth there is along the light's axis, world units.

uniform sampler2D mesoShadowMaps;                   // depth and number of what the light meets first
uniform int mesoShadowFirst[MESO_SHADOW_LIGHTS];    // a light's first view, -1: it casts no shadow
uniform int mesoShadowSides[MESO_SHADOW_LIGHTS];    // number of its views: 1, of a point light 6
uniform int mesoShadowNear[MESO_SHADOW_LIGHTS];     // 1: it has a place, its views are perspective
uniform float mesoShadowPart[MESO_SHADOW_LIGHTS];   // of the light that its shadows take away
uniform mat4 mesoShadowView[MESO_SHADOW_TILES];     // the camera's view coordinates to the light's
uniform vec4 mesoShadowFrame[MESO_SHADOW_TILES];    // texels a unit, and the axis' texel
uniform vec4 mesoShadowTile[MESO_SHADOW_TILES];     // first texel and size of the square
uniform float mesoCaster;                           // this object's number, 0: it casts none

// A surface that the light grazes more flatly (cosine) is taken as this steep.
const float MESO_LEAST_FACING = 0.05;
// Texels that a surface's depth may rise between a texel's middle and the point, and that a surface
// may lie before itself for want of flatness.
const float MESO_MOST_RISE = 64.0;
const float MESO_OWN_TEXELS = 2.0;

// The side of a point light that a place in its first view's coordinates is seen in.
int sideOf(vec3 place)
{
  vec3 size = abs(place);
  if (size.z >= size.x && size.z >= size.y)
  {
    return place.z < 0.0 ? 0 : 1;
  }
  if (size.y >= size.x)
  {
    return place.y > 0.0 ? 2 : 3;
  }
  return place.x > 0.0 ? 4 : 5;
}

// Unit normal of the triangle, on the side of the normal that the surface is shaded by.
vec3 facetOf(vec3 positionVC, vec3 normalVC)
{
  vec3 facet = cross(dFdx(positionVC), dFdy(positionVC));
  float size = length(facet);
  if (!(size > 0.0 && size < 1.0e30))
  {
    return normalVC;
  }
  return (dot(facet, normalVC) < 0.0 ? -1.0 : 1.0) / size * facet;
}

// The part of a light that does not arrive at a point because of what lies in the way.
// facetVC: normal of the base mesh's triangle; below: how far the point lies below it; thickness: of
// the shell below it, which the technique itself searches for what blocks light; followed: how far
// along the light it has searched beside. Of the object itself only what lies beyond that
// counts (Documentation/Shadows.md).
float castFraction(
  int light, vec3 positionVC, vec3 facetVC, float below, float thickness, float followed)
{
  int tile = mesoShadowFirst[light];
  if (tile < 0)
  {
    return 0.0;
  }
  vec3 here = (mesoShadowView[tile] * vec4(positionVC, 1.0)).xyz;
  if (mesoShadowSides[light] > 1)
  {
    tile += sideOf(here);
    here = (mesoShadowView[tile] * vec4(positionVC, 1.0)).xyz;
  }
  bool perspective = mesoShadowNear[light] != 0;
  float depth = -here.z;
  float away = perspective ? depth : 1.0;
  if (!(away > 0.0))
  {
    return 0.0; // behind the light
  }
  vec4 frame = mesoShadowFrame[tile];
  vec4 area = mesoShadowTile[tile];
  vec2 place = here.xy / away * frame.xy + frame.zw;
  if (any(lessThan(place, area.xy)) || any(greaterThan(place, area.xy + area.zw)))
  {
    return 0.0;
  }
  vec2 texel = away / frame.xy; // its sides, world units
  float texelSize = max(texel.x, texel.y);

  vec3 lightOut = perspective ? normalize(-here) : vec3(0.0, 0.0, 1.0);
  vec3 normal = mat3(mesoShadowView[tile]) * facetVC;
  float facing = dot(normal, lightOut);
  normal = facing < 0.0 ? -normal : normal;
  float searched = followed + below / max(abs(facing), MESO_LEAST_FACING);
  float depthOut = depth - searched * lightOut.z - thickness;

  // Four texels, weighted as for bilinear interpolation, each compared with the depth that the
  // point's plane has in the texel's middle.
  vec2 corner = floor(place - 0.5);
  vec2 weight = place - 0.5 - corner;
  float blocked = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    vec2 next = vec2(i & 1, i >> 1);
    vec2 at = clamp(corner + next, area.xy, area.xy + area.zw - 1.0);
    vec2 met = texelFetch(mesoShadowMaps, ivec2(at), 0).rg;
    vec2 aside = (at + 0.5 - place) * texel;
    vec3 ray = vec3(perspective ? (here.xy + aside) / away : vec2(0.0), -1.0);
    float rise = -dot(normal.xy, aside) / min(dot(normal, ray), -1.0e-3);
    rise = clamp(rise, -MESO_MOST_RISE * texelSize, MESO_MOST_RISE * texelSize);
    bool own = abs(met.g - mesoCaster) < 0.5;
    float nearest = own ? depthOut - 2.0 * abs(rise) - MESO_OWN_TEXELS * texelSize
                        : depth + rise - 0.5 * texelSize;
    vec2 part = mix(1.0 - weight, weight, next);
    blocked += met.r < nearest && !(own && facing <= 0.0) ? part.x * part.y : 0.0;
  }
  return mesoShadowPart[light] * blocked;
}
