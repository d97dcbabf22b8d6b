// Relief mapping over the mesh itself, looked up in an image of it (Kernels/BaseSurface).
// Model: where the view ray is over the base is solved for at points a part of a radian of the base's
// turning apart; between two of them the ray is a cubic over map and depth (Kernels/CubicPath). What the
// image does not know, from there on the base is the parabola of the last point that it does, or, from
// the start, the quadric of the vertices. Completes Common/ReliefSurface.
//   MESO_BASE_BENT    the points follow from each other by the surface's own frame, a linear step
//                     each, and are not solved for: Chen2008
//   MESO_BASE_TURN    radians between points that are solved for, less where one is found far away
//   MESO_SILHOUETTE   rays that come back are not drawn; without it, they draw the base
uniform vec3 mesoBaseCentreVC; // what the image's positions are counted from
uniform mat3 mesoViewToModel; // of directions

// Pieces that a ray may have; Newton's steps for each point.
#ifdef MESO_BASE_BENT
const int MESO_BASE_PIECES = 2 * MESO_LINEAR_STEPS;
#else
const int MESO_BASE_PIECES = 24;
#endif
const int MESO_BASE_NEWTON = 6;
// How far in depth a point may be found from where the parabola has it: beyond a crease it may be on another
// fold of the base, and a nearer one is asked for.
const float MESO_BASE_STRAY = 0.5;

// A straight ray in the image's space, per unit of view space length.
struct BaseRay
{
  vec3 Start;
  vec3 Direction;
};

BaseRay rayOverBase(vec3 startVC, vec3 directionVC)
{
  BaseRay ray;
  ray.Start = mesoViewToModel * (startVC - mesoBaseCentreVC);
  ray.Direction = mesoViewToModel * directionVC;
  return ray;
}

// The next piece of a ray's way.
struct BasePiece
{
  HeightPath Path;
  BaseState End;
  float Length;
  bool Last; // nothing is known beyond it, or the ray leaves the relief
};

// whole: the way's length as it looked from its start; longest: no further than this.
BasePiece nextPiece(BaseRay ray, BaseState from, float time, float whole, float longest)
{
  BasePiece piece;
  float depthEnd;
  float left = min(leaveShell(clamp(from.Depth, 0.0, 1.0), from.Rate.z, from.Bend, depthEnd), longest);
#ifdef MESO_BASE_BENT
  piece.Length = min(whole / float(MESO_LINEAR_STEPS), longest);
  piece.End = stepToBase(from.MapCoord + piece.Length * from.Rate.xy,
    from.Depth + piece.Length * from.Rate.z, mesoScale, ray.Start, ray.Direction);
  piece.End.MapCoord -= piece.End.Miss.xy;
  piece.End.Depth -= piece.End.Miss.z;
  bool sound = piece.End.Known;
  float share = 0.0;
  vec3 rateStart = from.Rate;
  vec3 rateEnd = from.Rate;
#else
  float turn = MESO_BASE_TURN / max(from.Turn, 1.0e-12);
  bool sound = false;
  for (int i = 0; i < 3 && !sound; ++i)
  {
    // A little further than it looks, so that the next point lies beyond the relief's end. Facets may
    // let a ray in where the smooth surface turns away from it: it is followed for a bit.
    float wanted = left > 0.0 ? 1.02 * left + 0.01 * whole : 0.1 * turn;
    piece.Length = min(min(wanted, turn), longest);
    piece.End = nextOverBase(from, piece.Length, mesoScale,
      ray.Start + (time + piece.Length) * ray.Direction, ray.Direction, MESO_BASE_NEWTON);
    float looked = from.Depth + piece.Length * (from.Rate.z - piece.Length * from.Bend);
    bool strayed = abs(piece.End.Depth - looked) > MESO_BASE_STRAY;
    sound = piece.End.Known && !(strayed && i < 2);
    turn = 0.25 * piece.Length;
  }
  float share = piece.Length / whole;
  vec3 rateStart = from.Rate;
  vec3 rateEnd = piece.End.Rate;
#endif
  if (!sound)
  {
    piece.Length = left;
    piece.End = from;
    piece.End.MapCoord = from.MapCoord + left * from.Rate.xy;
    piece.End.Depth = left < longest ? depthEnd : from.Depth + left * (from.Rate.z - left * from.Bend);
    rateEnd = vec3(from.Rate.xy, from.Rate.z - 2.0 * left * from.Bend);
    share = max(left / whole, 0.5);
  }
  piece.Path = cubicPath(from.MapCoord, piece.Length * rateStart, from.Depth, piece.End.MapCoord,
    piece.Length * rateEnd, piece.End.Depth, share);
  piece.Last = !sound || piece.End.Depth <= 0.0 || piece.End.Depth >= 1.0 || piece.Length >= longest;
  return piece;
}

// How long a way looks from its start, which its steps are shared out by.
float wholeWay(BaseState start)
{
  float depthEnd;
  float left = leaveShell(clamp(start.Depth, 0.0, 1.0), start.Rate.z, start.Bend, depthEnd);
  float turns = 3.0 / max(start.Turn, 1.0e-12);
  return left > 0.0 ? min(left, turns) : 0.05 * turns;
}

bool isTooLong(HeightPath path)
{
  return !(abs(path.MapSpan.x) + abs(path.MapSpan.y) < MESO_MAX_TILES);
}

BasePoint mesoBaseBelow; // where the search's hit is, a fraction of a texel from the hit

// The base below a hit.
BasePoint baseAtHit(MesoSurfaceHit hit)
{
#ifdef MESO_OCCLUSION
  return mesoBaseBelow;
#else
  return baseAt(hit.MapCoord);
#endif
}

// A hit on the cubic, moved along the ray to where the base itself has it: one step of Newton's method
// for the place, and one for the time, no longer than a step of the search.
void moveOntoBase(BaseRay ray, BasePiece piece, inout float time, inout HeightHit found)
{
  BaseState state = stepFrom(mesoBaseBelow, found.MapCoord, found.RayDepth, mesoScale,
    ray.Start + time * ray.Direction, ray.Direction);
  if (!state.Known || !(state.Off < BaseNearEnough))
  {
    return;
  }
  float clearance = (1.0 - surfaceHeight(state.MapCoord)) - state.Depth;
  float closing = found.Closing > 0.0 ? found.Closing / piece.Length : state.Rate.z;
  float stepLength = piece.Length / float(pathSteps(piece.Path, MESO_LINEAR_STEPS));
  float further = closing > 0.0 ? clamp(clearance / closing, -stepLength, stepLength) : 0.0;
  vec2 map = state.MapCoord + further * state.Rate.xy;
  float depth = state.Depth + further * state.Rate.z;
  if (abs((1.0 - surfaceHeight(map)) - depth) > abs(clearance)) // over an edge of the relief
  {
    map = state.MapCoord;
    depth = state.Depth;
    further = 0.0;
  }
  time += further;
  found.MapCoord = map;
  found.RayDepth = depth;
  found.Relief = clamp(depth, 0.0, 1.0);
  found.Fetches += 2;
  found.TexelReads += 8;
}

bool followRay(MesoFragment f, inout MesoSurfaceHit hit)
{
  BaseRay ray = rayOverBase(f.PositionVC, f.ViewVC);
  BaseState state = stepToBase(f.MapCoord, 0.0, mesoScale, ray.Start, ray.Direction);
  if (!state.Known || !state.Near)
  {
    // The image is not of this part of the mesh.
    state.Turn = 0.0;
    state.Known = directionInTS(f, f.ViewVC, state.Rate);
    state.Bend = quadricDepth(f.Quadric, state.Rate.xy);
    state.MapBend = vec2(0.0);
    if (!state.Known)
    {
      return false;
    }
  }
  state.MapCoord = f.MapCoord;
  state.Depth = 0.0;
  float whole = wholeWay(state);
  float time = 0.0;
  HeightHit found = noHit();
  int fetches = 0;
  int reads = 0;
  int iterations = 0;
#ifdef MESO_CLIPPED
  float cutUntil = f.RayStart;
#endif
  BasePiece piece;
  for (int i = 0; i < MESO_BASE_PIECES; ++i)
  {
    piece = nextPiece(ray, state, time, whole, QuadricNever);
    if (isTooLong(piece.Path))
    {
      return false;
    }
    MesoFragment here = f;
#ifdef MESO_CLIPPED
    here.RayStart = cutUntil - time;
#endif
    found = searchKept(here, piece.Path, piece.Length);
#ifdef MESO_CLIPPED
    if (!found.Hit && here.RayStart > 0.0 && exactClearance(piece.Path, 1.0) <= 0.0)
    {
      cutUntil = time + 1.001 * piece.Length; // still below the surface
    }
#endif
    fetches += found.Fetches + 8;
    reads += found.TexelReads + 8;
    iterations += found.Iterations;
    if (found.Hit || piece.Last)
    {
      break;
    }
    time += piece.Length;
    state = piece.End;
  }
  if (found.Hit)
  {
    time += found.Part * piece.Length;
    found.Fetches = fetches;
    found.TexelReads = reads;
    found.Iterations = iterations;
    mesoBaseBelow = baseAt(found.MapCoord);
#ifndef MESO_BASE_BENT
    if (time > 0.0)
    {
      moveOntoBase(ray, piece, time, found);
    }
#endif
    hit.RayLength = max(time, 0.0);
    takeSearch(found, hit);
  }
#ifdef MESO_SILHOUETTE
  else
  {
    hit.Found = piece.End.Depth >= 1.0; // only a number that is not finite misses the bottom
  }
#endif
  return found.Hit;
}

// Over the base's own frame at the hit, that of the smooth surface which its normals stand for.
vec3 reliefNormal(MesoFragment f, MesoSurfaceHit hit, vec2 gradient)
{
  if (hit.RayLength == 0.0 && gradient == vec2(0.0))
  {
    return f.NormalVC;
  }
  BasePoint base = baseAtHit(hit);
  if (!base.Known)
  {
    return normalOfCross(f,
      displacedCross(f.Quadric, f.Metric, hit.MapCoord - f.MapCoord, hit.Relief, gradient));
  }
  vec3 smoothU = base.PerU - dot(base.PerU, base.Normal) * base.Normal;
  vec3 smoothV = base.PerV - dot(base.PerV, base.Normal) * base.Normal;
  vec3 alongU = smoothU + mesoScale * (gradient.x * base.Normal - hit.Relief * base.NormalPerU);
  vec3 alongV = smoothV + mesoScale * (gradient.y * base.Normal - hit.Relief * base.NormalPerV);
  vec3 normal = cross(alongU, alongV);
  float side = dot(cross(smoothU, smoothV), base.Normal);
  vec3 normalVC = mesoNormalMatrix * (side < 0.0 ? -normal : normal);
  return dot(normalVC, normalVC) > 0.0 ? normalize(normalVC) : f.NormalVC;
}

// The light's ray over the same base, from the hit until it comes up to depth 0, goes down to the
// bottom, which blocks it, or reaches the light.
float reliefBlocks(MesoFragment f, MesoSurfaceHit hit, vec3 travel, vec3 lift, float lightDistance,
  out int fetches)
{
  fetches = 0;
  mat3 toView = mat3(f.PerMapU, f.PerMapV, f.PerDepth);
  BaseRay ray = rayOverBase(f.PositionVC + hit.RayLength * f.ViewVC, toView * travel);
  BasePoint under = baseAt(hit.MapCoord);
  // The relief itself over the hit's place: the hit may lie a rounding below it.
  float depth = min(hit.Relief, 1.0 - surfaceHeight(hit.MapCoord));
  if (under.Known)
  {
    ray.Start = under.Position - depth * mesoScale * under.Normal;
  }
  ray.Start += mesoViewToModel * (toView * lift);
  BaseState state = stepFrom(under, hit.MapCoord, depth, mesoScale, ray.Start, ray.Direction);
  if (!state.Known)
  {
    vec2 gradient = quadricGradient(f.Quadric, hit.MapCoord - f.MapCoord);
    state.MapCoord = hit.MapCoord + lift.xy;
    state.Depth = hit.Relief + lift.z - dot(gradient, lift.xy);
    state.Rate = vec3(travel.xy, travel.z - dot(gradient, travel.xy));
    state.Bend = quadricDepth(f.Quadric, travel.xy);
    state.MapBend = vec2(0.0);
    state.Turn = 0.0;
  }
  float whole = wholeWay(state);
  float time = 0.0;
  float blocked = 0.0;
  for (int i = 0; i < MESO_BASE_PIECES && state.Depth > 0.0; ++i)
  {
    BasePiece piece = nextPiece(ray, state, time, whole, lightDistance - time);
    int counted;
    // Too long a path: the light hardly rises out of the surface.
    blocked = isTooLong(piece.Path) ? 1.0 : reliefOccludes(piece.Path, counted);
    blocked = piece.End.Depth >= 1.0 ? 1.0 : blocked;
    fetches += counted + 8;
    if (blocked > 0.0 || piece.Last)
    {
      break;
    }
    time += piece.Length;
    state = piece.End;
  }
  return blocked;
}
