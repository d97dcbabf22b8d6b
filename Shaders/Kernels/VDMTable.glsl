// View-dependent displacement mapping: Wang2003 (Documentation/Techniques/References.md).
//
// Lengths are in tiles: a step over the map by one tile is 1, and the relief is table.Depth deep. A ray
// enters at depth 0 at `polar` from the inward normal, towards an azimuth over the map. In the plane of
// both the base is a circle of curvature c through the entry, convex where c > 0. Of the point where the
// ray meets the relief
//
//   Offset     l: from the entry to the point's foot, along the base
//   RayLength  t: along the ray
//   Depth      h: below the base
//
// belong together by the triangle of entry, point and centre, whose angle there is psi = c l:
//
//   t = sin(psi) / (c sin(polar + psi)),   h = (1 - sin(polar) / sin(polar + psi)) / c.

// What a table stores of the point, as a part of table.Range.
const int VDMStoresDistance = 0; // d = l / sin(polar): the paper's, t itself where the base is flat
const int VDMStoresDepth = 1;    // h down to the ray's deepest point, and from there on counted further
const int VDMStoresOffset = 2;   // l

// Where a table's polar angles lie.
const int VDMNodesEdges = 0;   // evenly from 0 to pi/2, both among them
const int VDMNodesCentres = 1; // in the middles of even parts of [0, pi/2]
const int VDMNodesGraded = 2;  // where (1 - polar / (pi/2))^(4/5) is in the middles of even parts of [0, 1]

const float VDMRightAngle = 1.57079633; // pi / 2
const float VDMTurn = 6.28318531;       // 2 pi
// Polar angles are held below pi/2 by this: a ray in the plane of the base meets nothing.
const float VDMLeastCosine = 1.0e-4;

struct VDMLayout
{
  int Stores;
  int Nodes;
  int Polars;        // number of polar angles
  int Curvatures;    // number of curvatures, evenly from the first to the last
  float FirstCurvature;
  float LastCurvature;
  float Depth;       // F, of the relief
  float Range;       // what the stored number 1 stands for
};

struct VDMPoint
{
  float Offset;
  float RayLength;
  float Depth;
};

// A direction into the relief, for a table.
struct VDMDirection
{
  vec2 Over;     // unit, over the map; 0 where the ray is the normal
  float Turns;   // azimuth / 2 pi, in [0, 1)
  float Sine;    // of the polar angle
  float Cosine;  // at least VDMLeastCosine
  float HalfTangent; // of half the polar angle, in [0, 1): nearly as even, without an arc tangent
  float Length;  // of the direction that came in, in tiles
};

// From (step over the map u, v, depth in units of the whole) to a table's direction. False where the
// ray does not go into the relief.
bool vdmDirection(vec3 travel, float depth, out VDMDirection direction)
{
  vec3 scaled = vec3(travel.x, travel.y, travel.z * depth);
  float over = length(vec2(scaled.x, scaled.y));
  direction.Length = length(scaled);
  direction.Over = vec2(0.0);
  direction.Turns = 0.0;
  direction.Sine = 0.0;
  direction.Cosine = 1.0;
  direction.HalfTangent = 0.0;
  if (!(scaled.z > 0.0) || !(direction.Length > 0.0))
  {
    return false;
  }
  direction.Cosine = max(scaled.z / direction.Length, VDMLeastCosine);
  direction.Sine = over / direction.Length;
  direction.HalfTangent = direction.Sine / (1.0 + direction.Cosine);
  if (over > 0.0)
  {
    direction.Over = vec2(scaled.x, scaled.y) / over;
    float turns = atan(scaled.y, scaled.x) / VDMTurn;
    direction.Turns = turns - floor(turns);
  }
  return true;
}

// sin(x) / x.
float vdmSinc(float x)
{
  return abs(x) > 1.0e-3 ? sin(x) / x : 1.0 - x * x / 6.0;
}

// The curvature along v of a surface with principal curvatures (c_max, c_min) and their unit directions:
// the paper's formula, with v's part in the tangent plane, of which no more is left where v is the
// normal; 0 there. At an umbilic any pair of directions gives the same. All vectors in one space.
float curvatureAlong(vec2 curvatures, vec3 directionMax, vec3 directionMin, vec3 v)
{
  float alongMax = dot(v, directionMax);
  float alongMin = dot(v, directionMin);
  float length2 = alongMax * alongMax + alongMin * alongMin; // 1 - (v . n)^2, without the difference
  if (!(length2 > 1.0e-12))
  {
    return 0.0;
  }
  return (curvatures.x * alongMax * alongMax + curvatures.y * alongMin * alongMin) / length2;
}

// Where a curvature lies among those of the table, which end it: 0 is the first.
float vdmCurvaturePlace(VDMLayout table, float c)
{
  if (table.Curvatures < 2)
  {
    return 0.0;
  }
  float part = (c - table.FirstCurvature) / (table.LastCurvature - table.FirstCurvature);
  return clamp(part, 0.0, 1.0) * float(table.Curvatures - 1);
}

// The same for polar angles, but not ended by them.
float vdmOpenPolarPlace(VDMLayout table, float polar)
{
  float place;
  if (table.Nodes == VDMNodesEdges)
  {
    place = polar / VDMRightAngle * float(table.Polars - 1);
  }
  else if (table.Nodes == VDMNodesGraded)
  {
    float left = max(1.0 - polar / VDMRightAngle, 0.0);
    place = (1.0 - pow(left, 0.8)) * float(table.Polars) - 0.5;
  }
  else
  {
    place = polar / VDMRightAngle * float(table.Polars) - 0.5;
  }
  return place;
}

float vdmPolarPlace(VDMLayout table, float polar)
{
  return clamp(vdmOpenPolarPlace(table, polar), 0.0, float(table.Polars - 1));
}

float vdmPolarAt(VDMLayout table, float place)
{
  if (table.Nodes == VDMNodesEdges)
  {
    return table.Polars < 2 ? 0.0 : place / float(table.Polars - 1) * VDMRightAngle;
  }
  float part = (place + 0.5) / float(table.Polars);
  float left = table.Nodes == VDMNodesGraded ? pow(1.0 - part, 1.25) : 1.0 - part;
  return (1.0 - left) * VDMRightAngle;
}

// How far a polar angle is from the first, 0, to the normal, 1.
float vdmSteeper(VDMLayout table, float halfTangent)
{
  float first = tan(0.5 * vdmPolarAt(table, 0.0));
  return first > 0.0 ? clamp(1.0 - halfTangent / first, 0.0, 1.0) : 0.0;
}

// The point at an extended distance d = l / sin(polar). No quotient of near zeros: with
// sin(polar + psi) = sin(polar) w both formulas above hold at c = 0 and at polar = 0.
VDMPoint vdmPointAtDistance(float sine, float cosine, float c, float distance)
{
  VDMPoint point;
  point.Offset = distance * sine;
  float psi = c * point.Offset;
  float half2 = vdmSinc(0.5 * psi);
  float along = distance * vdmSinc(psi);
  float w = cos(psi) + c * cosine * along;
  w = max(w, 1.0e-6); // a table's numbers between samples may reach beyond the way out
  point.RayLength = along / w;
  point.Depth = (cosine * along - 0.5 * c * point.Offset * point.Offset * half2 * half2) / w;
  return point;
}

// The point at a depth on the way down, or on the way up again.
VDMPoint vdmPointAtDepth(float sine, float cosine, float c, float depth, bool rises)
{
  // c t^2 - 2 cosine t + (2 - c h) h = 0
  float rest = (2.0 - c * depth) * depth;
  float root = sqrt(max(cosine * cosine - c * rest, 0.0));
  VDMPoint point;
  point.Depth = depth;
  point.RayLength = rises ? (cosine + root) / c : rest / (cosine + root);
  // The angle at the centre, over c.
  float across = point.RayLength * sine;
  float inwards = 1.0 - c * point.RayLength * cosine;
  float psi = atan(c * across, inwards);
  point.Offset = abs(psi) > 1.0e-3 ? psi / c : across / inwards * (1.0 - psi * psi / 3.0);
  return point;
}

// The point that a stored number stands for.
VDMPoint vdmPoint(VDMLayout table, float sine, float cosine, float c, float stored)
{
  float number = stored * table.Range;
  if (table.Stores == VDMStoresDepth)
  {
    // Deepest at the ray's middle, where it is at right angles to the way to the centre.
    float deepest = c > 0.0 ? cosine * cosine / (1.0 + sine) / c : 2.0 * number + 1.0;
    bool rises = number > deepest;
    return vdmPointAtDepth(
      sine, cosine, c, clamp(rises ? 2.0 * deepest - number : number, 0.0, table.Depth), rises);
  }
  if (table.Stores == VDMStoresOffset)
  {
    return vdmPointAtDistance(sine, cosine, c, number / max(sine, 1.0e-6));
  }
  return vdmPointAtDistance(sine, cosine, c, number);
}

// The number, not yet over table.Range, that a table stores of a point.
float vdmNumber(VDMLayout table, float sine, float cosine, float c, VDMPoint point)
{
  if (table.Stores == VDMStoresOffset)
  {
    return point.Offset;
  }
  if (table.Stores == VDMStoresDistance)
  {
    // l / sin(polar), t at the normal
    return sine > 1.0e-6 ? point.Offset / sine : point.RayLength / (1.0 - c * point.RayLength);
  }
  bool rises = c > 0.0 && point.RayLength * c > cosine;
  return rises ? 2.0 * cosine * cosine / (1.0 + sine) / c - point.Depth : point.Depth;
}

// Where a ray that leaves a point at `depth` comes out of the base: as it would come in there, mirrored.
// sine, cosine: of its angle from the outward normal at the point's foot, cosine < 0 where it first goes
// deeper, from which only a convex base lets it out. sineOut, cosineOut: where it comes out, from the
// outward normal there. Result: of that ray, from the way out back to the point.
VDMPoint vdmWayOut(float c, float depth, float sine, float cosine, out float sineOut, out float cosineOut)
{
  sineOut = clamp((1.0 - c * depth) * sine, 0.0, 1.0); // the law of sines
  cosineOut = max(sqrt(max(1.0 - sineOut * sineOut, 0.0)), VDMLeastCosine);
  return vdmPointAtDepth(sineOut, cosineOut, c, depth, cosine < 0.0);
}
