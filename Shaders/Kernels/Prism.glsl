// A triangle extruded to a prism, and a ray through it (Wang2004, sections 3.1 and 3.2). Object space.
//
// A point of the prism is sum_i b_i (Bottom_i + z Rise_i), with b over the triangle and z in [0, 1]. Fin k
// stands over the edge from corner k to the next. It is bilinear; for what lies inside it counts as two
// triangles, which both prisms at the fin cut along the same diagonal.

struct Prism
{
  vec3 Bottom0;
  vec3 Bottom1;
  vec3 Bottom2;
  vec3 Rise0;
  vec3 Rise1;
  vec3 Rise2;
  int Flags; // bit k: fin k's diagonal runs from the bottom of corner k + 1, else from that of corner k
};

// The stretch of a ray inside a prism, as lengths along the ray; nothing where Leave < Enter.
struct PrismSpan
{
  float Enter;
  float Leave;
  int Face; // by which the ray enters: 0 bottom, 1 top, 2 + k fin k
  int Exit; // and leaves
};

const float FAR_ALONG_RAY = 1.0e30;

// 1 where the corners run counter-clockwise seen from above, else -1.
float prismWinding(Prism p)
{
  vec3 area = cross(p.Bottom1 - p.Bottom0, p.Bottom2 - p.Bottom0);
  return dot(area, p.Rise0 + p.Rise1 + p.Rise2) < 0.0 ? -1.0 : 1.0;
}

// Where a height that changes along the ray, `above` at 0, is at most 0.
vec2 stretchBelow(float above, float rate)
{
  if (rate > 0.0)
  {
    return vec2(-FAR_ALONG_RAY, -above / rate);
  }
  if (rate < 0.0)
  {
    return vec2(-above / rate, FAR_ALONG_RAY);
  }
  return above > 0.0 ? vec2(FAR_ALONG_RAY, -FAR_ALONG_RAY) : vec2(-FAR_ALONG_RAY, FAR_ALONG_RAY);
}

vec2 stretchBehind(vec3 onPlane, vec3 outward, vec3 origin, vec3 direction)
{
  return stretchBelow(dot(outward, origin - onPlane), dot(outward, direction));
}

// The planes of a fin's two triangles, outward.
struct FinPlanes
{
  vec3 On; // a point of both
  vec3 Lower;
  vec3 Upper;
  bool Inward; // they bend inward: behind either is inside, else behind both (Wang2004, Figure 5)
};

// Of the fin between corners a and b. Both planes are taken through the diagonal, in the same way for the prism
// on the other side, so that one leaves where the other enters.
FinPlanes finPlanes(vec3 a, vec3 b, vec3 riseA, vec3 riseB, bool falling, float winding)
{
  vec3 edge = b - a;
  vec3 lower = falling ? cross(edge, riseA) : cross(edge, riseB);
  vec3 upper = falling ? cross(riseB, riseA - edge) : cross(edge + riseB, riseA);
  float beyond = falling ? dot(lower, edge + riseB) : dot(lower, riseA);
  FinPlanes planes;
  planes.On = falling ? b : a;
  planes.Lower = winding * lower;
  planes.Upper = winding * upper;
  planes.Inward = winding * beyond > 0.0;
  return planes;
}

FinPlanes finOfPrism(Prism p, int fin, float winding)
{
  if (fin == 0)
  {
    return finPlanes(p.Bottom0, p.Bottom1, p.Rise0, p.Rise1, (p.Flags & 1) != 0, winding);
  }
  if (fin == 1)
  {
    return finPlanes(p.Bottom1, p.Bottom2, p.Rise1, p.Rise2, (p.Flags & 2) != 0, winding);
  }
  return finPlanes(p.Bottom2, p.Bottom0, p.Rise2, p.Rise0, (p.Flags & 4) != 0, winding);
}

// Inside a fin; `at` chooses between two stretches: the one that holds it.
vec2 stretchInFin(FinPlanes fin, vec3 origin, vec3 direction, float at)
{
  vec2 first = stretchBehind(fin.On, fin.Lower, origin, direction);
  vec2 second = stretchBehind(fin.On, fin.Upper, origin, direction);
  if (!fin.Inward)
  {
    return vec2(max(first.x, second.x), min(first.y, second.y));
  }
  if (max(first.x, second.x) <= min(first.y, second.y))
  {
    return vec2(min(first.x, second.x), max(first.y, second.y));
  }
  bool inOrder = first.y < second.y;
  vec2 before = inOrder ? first : second;
  vec2 after = inOrder ? second : first;
  return 2.0 * at <= before.y + after.x ? before : after;
}

// Outward, of any length.
vec3 bottomNormal(Prism p, float winding)
{
  return -winding * cross(p.Bottom1 - p.Bottom0, p.Bottom2 - p.Bottom0);
}

vec3 topNormal(Prism p, float winding)
{
  vec3 top = p.Bottom0 + p.Rise0;
  return winding * cross(p.Bottom1 + p.Rise1 - top, p.Bottom2 + p.Rise2 - top);
}

// The stretch of a ray in a prism that holds `at`, or is nearest to it.
PrismSpan prismSpan(Prism p, vec3 origin, vec3 direction, float at)
{
  float winding = prismWinding(p);
  vec2 stretches[5];
  stretches[0] = stretchBehind(p.Bottom0, bottomNormal(p, winding), origin, direction);
  stretches[1] = stretchBehind(p.Bottom0 + p.Rise0, topNormal(p, winding), origin, direction);
  for (int fin = 0; fin < 3; ++fin)
  {
    stretches[2 + fin] = stretchInFin(finOfPrism(p, fin, winding), origin, direction, at);
  }
  PrismSpan span;
  span.Enter = stretches[0].x;
  span.Leave = stretches[0].y;
  span.Face = 0;
  span.Exit = 0;
  for (int i = 1; i < 5; ++i)
  {
    if (stretches[i].x > span.Enter)
    {
      span.Enter = stretches[i].x;
      span.Face = i;
    }
    if (stretches[i].y < span.Leave)
    {
      span.Leave = stretches[i].y;
      span.Exit = i;
    }
  }
  return span;
}

// How far along a ray a plane is that it comes out by; FAR_ALONG_RAY where it does not.
float exitBy(vec3 onPlane, vec3 outward, vec3 origin, vec3 direction)
{
  return dot(outward, direction) > 0.0
    ? stretchBehind(onPlane, outward, origin, direction).y
    : FAR_ALONG_RAY;
}

// The same for all faces: `lower` of the bottom and the fins' lower triangles, `upper` of the top and the upper
// ones.
void prismExits(Prism p, vec3 origin, vec3 direction, out vec4 lower, out vec4 upper)
{
  float winding = prismWinding(p);
  FinPlanes fin0 = finOfPrism(p, 0, winding);
  FinPlanes fin1 = finOfPrism(p, 1, winding);
  FinPlanes fin2 = finOfPrism(p, 2, winding);
  lower = vec4(exitBy(p.Bottom0, bottomNormal(p, winding), origin, direction),
    exitBy(fin0.On, fin0.Lower, origin, direction), exitBy(fin1.On, fin1.Lower, origin, direction),
    exitBy(fin2.On, fin2.Lower, origin, direction));
  upper = vec4(exitBy(p.Bottom0 + p.Rise0, topNormal(p, winding), origin, direction),
    exitBy(fin0.On, fin0.Upper, origin, direction), exitBy(fin1.On, fin1.Upper, origin, direction),
    exitBy(fin2.On, fin2.Upper, origin, direction));
}

// Where a ray leaves the prism by such exits: of a fin whose planes bend inward by the further, else by the nearer
// (Wang2004, Figure 5).
float leaveByExits(Prism p, vec4 lower, vec4 upper)
{
  float winding = prismWinding(p);
  bool inward0 = finOfPrism(p, 0, winding).Inward;
  bool inward1 = finOfPrism(p, 1, winding).Inward;
  bool inward2 = finOfPrism(p, 2, winding).Inward;
  float fin0 = inward0 ? max(lower.y, upper.y) : min(lower.y, upper.y);
  float fin1 = inward1 ? max(lower.z, upper.z) : min(lower.z, upper.z);
  float fin2 = inward2 ? max(lower.w, upper.w) : min(lower.w, upper.w);
  return min(min(lower.x, upper.x), min(fin0, min(fin1, fin2)));
}

// The face, as PrismSpan counts them, that a place is nearest to.
int nearestFace(vec3 place)
{
  float from[5];
  from[0] = abs(place.z);
  from[1] = abs(1.0 - place.z);
  from[2] = abs(place.y);
  from[3] = abs(1.0 - place.x - place.y);
  from[4] = abs(place.x);
  int face = 0;
  for (int i = 1; i < 5; ++i)
  {
    face = from[i] < from[face] ? i : face;
  }
  return face;
}

// Change of place with b1, b2 and z, at (b1, b2, z).
void prismTangents(Prism p, vec3 place, out vec3 alongB1, out vec3 alongB2, out vec3 alongZ)
{
  vec3 turn1 = p.Rise1 - p.Rise0;
  vec3 turn2 = p.Rise2 - p.Rise0;
  alongB1 = p.Bottom1 - p.Bottom0 + place.z * turn1;
  alongB2 = p.Bottom2 - p.Bottom0 + place.z * turn2;
  alongZ = p.Rise0 + place.x * turn1 + place.y * turn2;
}

// (a, b, c) with a x + b y + c z = v; 0 where x, y and z span no volume.
vec3 solveThree(vec3 x, vec3 y, vec3 z, vec3 v)
{
  vec3 yz = cross(y, z);
  float volume = dot(x, yz);
  if (volume == 0.0)
  {
    return vec3(0.0);
  }
  return vec3(dot(v, yz), dot(v, cross(z, x)), dot(v, cross(x, y))) / volume;
}

// The way of (b1, b2, z) along a direction, at a place.
vec3 prismRates(Prism p, vec3 place, vec3 direction)
{
  vec3 alongB1;
  vec3 alongB2;
  vec3 alongZ;
  prismTangents(p, place, alongB1, alongB2, alongZ);
  return solveThree(alongB1, alongB2, alongZ, direction);
}

// (b1, b2, z) of a point in or near the prism, by Newton's steps from a place near by.
vec3 prismPlace(Prism p, vec3 point, vec3 near)
{
  vec3 place = near;
  for (int i = 0; i < 5; ++i)
  {
    vec3 alongB1;
    vec3 alongB2;
    vec3 alongZ;
    prismTangents(p, place, alongB1, alongB2, alongZ);
    vec3 here = p.Bottom0 + place.x * (p.Bottom1 - p.Bottom0) + place.y * (p.Bottom2 - p.Bottom0) +
      place.z * alongZ;
    vec3 move = solveThree(alongB1, alongB2, alongZ, point - here);
    // Away from the prism lies nothing: without this a prism that turns over sends its steps anywhere.
    place = clamp(place + move, vec3(-1.0), vec3(2.0));
    if (max(abs(move.x), max(abs(move.y), abs(move.z))) < 1.0e-5)
    {
      break;
    }
  }
  return place;
}

// How far along a fin, 0 at its corner and 1 at the next, a place on it is, and the place that is so far.
float alongFin(int fin, vec3 place)
{
  return fin == 0 ? place.x : fin == 1 ? place.y : 1.0 - place.y;
}

vec3 placeOnFin(int fin, float along, float z)
{
  if (fin == 0)
  {
    return vec3(along, 0.0, z);
  }
  return fin == 1 ? vec3(1.0 - along, along, z) : vec3(0.0, 1.0 - along, z);
}

// A vector that is at right angles to the surface on which a function is constant, from the function's
// change with b1, b2 and z. Any length; 0 where the function does not change.
vec3 prismNormal(Prism p, vec3 place, vec3 gradient)
{
  vec3 alongB1;
  vec3 alongB2;
  vec3 alongZ;
  prismTangents(p, place, alongB1, alongB2, alongZ);
  vec3 across = gradient.x * cross(alongB2, alongZ) + gradient.y * cross(alongZ, alongB1) +
    gradient.z * cross(alongB1, alongB2);
  return dot(alongB1, cross(alongB2, alongZ)) < 0.0 ? -across : across;
}

// Outward normal of a face (as PrismSpan counts them) at a place on it. Any length.
vec3 prismFaceNormal(Prism p, int face, vec3 place)
{
  // Inside, b0, b1, b2 and z are above 0, and z below 1.
  vec3 outward = vec3(0.0, 0.0, face == 0 ? -1.0 : 1.0);
  if (face == 2)
  {
    outward = vec3(0.0, -1.0, 0.0);
  }
  else if (face == 3)
  {
    outward = vec3(1.0, 1.0, 0.0);
  }
  else if (face == 4)
  {
    outward = vec3(-1.0, 0.0, 0.0);
  }
  return prismNormal(p, place, outward);
}
