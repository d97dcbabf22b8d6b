// The base mesh itself, from an image of it over its texture coordinates (vtkMesoBaseImage), and where
// a straight ray is over it: the coordinates (u, v, depth) of a point x with
//
//   x = P(u, v) - depth D N(u, v),
//
// P the base, N its unit normal, by Newton's method from a guess. Object space, positions from the
// image's centre; u and v are map coordinates; between texel centres P is bilinear, and N likewise and
// then made unit.
//
// Accessors, defined before this file:
//   vec4 fetchBasePosition(ivec2 texel)  position; w: 0 where the base is unknown
//   vec3 fetchBaseNormal(ivec2 texel)
//   ivec2 baseSize()                     texels
//   bvec2 baseWraps()                    the mesh closes along u, v: the last texel meets the first
//   vec2 baseScale(), vec2 baseOffset()  map * scale + offset: texels, centres at whole numbers

struct BasePoint
{
  bool Known;      // the texels around it are
  vec3 Position;
  vec3 Normal;     // unit
  vec3 PerU;       // dP/du
  vec3 PerV;
  vec3 NormalPerU; // dN/du
  vec3 NormalPerV;
};

// A point of a straight ray over the base.
struct BaseState
{
  bool Known;    // false: the base is unknown there, or its frame spans no volume
  vec2 MapCoord;
  float Depth;
  vec3 Rate;     // of u, v and depth along the ray, over the smooth surface that N stands for
  float Bend;    // half the second derivative of the depth, negated
  vec2 MapBend;  // that of u and v, as far as the ray's depth changes it
  float Turn;    // |dN/dt|
  vec3 Miss;     // what the last step moved: u, v, depth
  float Off;     // by how many radians the base turns over that
  bool Near;     // the last guess was right to within a texel of the image
};

// Volume of P_u, P_v and N over the product of their lengths below which they span none.
const float BaseLeastVolume = 1.0e-4;

// A texel of the image along an axis; outside where it does not close.
int baseTexel(int i, int size, bool wraps)
{
  int turns = int(floor(float(i) / float(size)));
  return wraps ? clamp(i - turns * size, 0, size - 1) : clamp(i, 0, size - 1);
}

BasePoint baseAt(vec2 map)
{
  vec2 scale = baseScale();
  vec2 place = map * scale + baseOffset();
  vec2 lowest = floor(place);
  vec2 weight = place - lowest;
  ivec2 low = ivec2(lowest);
  ivec2 size = baseSize();
  bvec2 wraps = baseWraps();
  int left = baseTexel(low.x, size.x, wraps.x);
  int right = baseTexel(low.x + 1, size.x, wraps.x);
  int below = baseTexel(low.y, size.y, wraps.y);
  int above = baseTexel(low.y + 1, size.y, wraps.y);
  vec4 position00 = fetchBasePosition(ivec2(left, below));
  vec4 position10 = fetchBasePosition(ivec2(right, below));
  vec4 position01 = fetchBasePosition(ivec2(left, above));
  vec4 position11 = fetchBasePosition(ivec2(right, above));
  vec3 normal00 = fetchBaseNormal(ivec2(left, below));
  vec3 normal10 = fetchBaseNormal(ivec2(right, below));
  vec3 normal01 = fetchBaseNormal(ivec2(left, above));
  vec3 normal11 = fetchBaseNormal(ivec2(right, above));

  BasePoint base;
  bool inside = (wraps.x || (low.x >= 0 && low.x + 1 < size.x)) &&
    (wraps.y || (low.y >= 0 && low.y + 1 < size.y));
  base.Known = inside &&
    min(min(position00.w, position10.w), min(position01.w, position11.w)) > 0.0;
  base.Position = mix(mix(position00.xyz, position10.xyz, weight.x),
    mix(position01.xyz, position11.xyz, weight.x), weight.y);
  base.PerU = scale.x *
    mix(position10.xyz - position00.xyz, position11.xyz - position01.xyz, weight.y);
  base.PerV = scale.y *
    mix(position01.xyz - position00.xyz, position11.xyz - position10.xyz, weight.x);
  vec3 normal = mix(mix(normal00, normal10, weight.x), mix(normal01, normal11, weight.x), weight.y);
  float size2 = dot(normal, normal);
  base.Known = base.Known && size2 > 0.0;
  float perLength = inversesqrt(max(size2, 1.0e-20));
  base.Normal = normal * perLength;
  vec3 alongU = (scale.x * perLength) * mix(normal10 - normal00, normal11 - normal01, weight.y);
  vec3 alongV = (scale.y * perLength) * mix(normal01 - normal00, normal11 - normal10, weight.x);
  base.NormalPerU = alongU - dot(base.Normal, alongU) * base.Normal;
  base.NormalPerV = alongV - dot(base.Normal, alongV) * base.Normal;
  return base;
}

// One step of Newton's method towards the coordinates of a point, from the base there, and the ray's
// rates at the guess. scale: D; direction: of the ray, per unit of its time.
BaseState stepFrom(
  BasePoint base, vec2 map, float depth, float scale, vec3 point, vec3 direction)
{
  vec3 alongU = base.PerU - depth * scale * base.NormalPerU;
  vec3 alongV = base.PerV - depth * scale * base.NormalPerV;
  vec3 away = point - (base.Position - depth * scale * base.Normal);
  // Of P_u, P_v and -D N the third is unit but for D: solved by Cramer's rule with N in its place.
  vec3 acrossV = cross(alongV, base.Normal);
  vec3 acrossU = cross(base.Normal, alongU);
  vec3 area = cross(alongU, alongV);
  float volume = dot(area, base.Normal);
  BaseState state;
  state.Known = base.Known && scale > 0.0 &&
    volume * volume > BaseLeastVolume * BaseLeastVolume * dot(alongU, alongU) * dot(alongV, alongV);
  float perVolume = state.Known ? 1.0 / volume : 0.0;
  float perDepth = state.Known ? -1.0 / scale : 0.0;
  state.Miss = vec3(dot(away, acrossV) * perVolume, dot(away, acrossU) * perVolume,
    dot(away, area) * perVolume * perDepth);
  vec2 perTexel = 1.0 / baseScale();
  vec3 texels = abs(perTexel.x) * abs(alongU) + abs(perTexel.y) * abs(alongV);
  state.Near = dot(away, away) < dot(texels, texels);
  state.MapCoord = map + state.Miss.xy;
  state.Depth = depth + state.Miss.z;
  // P_u and P_v of a mesh jump from triangle to triangle, N does not: the rates are those of the
  // surface at right angles to N, whose depth changes by the direction's part along N alone.
  vec3 inPlane = direction - dot(direction, base.Normal) * base.Normal;
  vec2 rate = vec2(dot(inPlane, acrossV), dot(inPlane, acrossU)) * perVolume;
  state.Rate = vec3(rate, dot(direction, base.Normal) * perDepth);
  vec3 turn = rate.x * base.NormalPerU + rate.y * base.NormalPerV;
  state.Turn = length(turn);
  state.Off = length(state.Miss.x * base.NormalPerU + state.Miss.y * base.NormalPerV);
  state.Bend = -0.5 * dot(inPlane, turn) * perDepth;
  // The deeper, the more the base's turning stretches the map along the ray.
  state.MapBend =
    (scale * state.Rate.z * perVolume) * vec2(dot(turn, acrossV), dot(turn, acrossU));
  return state;
}

BaseState stepToBase(vec2 map, float depth, float scale, vec3 point, vec3 direction)
{
  return stepFrom(baseAt(map), map, depth, scale, point, direction);
}

// A step that turns the base by less leaves a depth that is right to half its square times the radius
// of curvature.
const float BaseNearEnough = 0.025;

// The ray's state after a time: a parabola's guess, then Newton's steps, few as they suffice.
BaseState nextOverBase(BaseState from, float time, float scale, vec3 point, vec3 direction, int steps)
{
  vec2 map = from.MapCoord + time * (from.Rate.xy + time * from.MapBend);
  float depth = from.Depth + time * (from.Rate.z - time * from.Bend);
  BaseState state = from;
  bool near = false;
  for (int i = 0; i < steps && !near; ++i)
  {
    state = stepToBase(map, depth, scale, point, direction);
    map = state.MapCoord;
    depth = state.Depth;
    near = state.Off < BaseNearEnough;
  }
  state.Known = state.Known && near;
  return state;
}
