// Where a path lies above a height map, and where it meets it.
//
// Needs HeightField.glsl
// Needs HeightPath.glsl
//
// What lies between texels is the accessor's, float surfaceHeight(vec2 uv): mapHeight of HeightBilinear or
// of HeightBicubic, or what a pixel sees of it.
//
// HeightPath.glsl is one of several: CubicPath, AcrossPath and CirclePath have the same names for
// other ways through the map (HeightPath, pathIsSound, pathNearOrigin, pathDepth, pathMap, pathSteps).

struct HeightHit
{
  bool Hit;
  float Part;     // of the path, at the hit
  float RayDepth; // depth of the path at the hit
  vec2 MapCoord;  // map coordinate at the hit, not wrapped
  float Relief;   // depth at the hit, [0,1]
  float Closing;  // by what the clearance shrinks per part of the path there; 0 is not known
  int Iterations; // steps of the search
  int Fetches;    // samples of a map: a patch of four texels counts as one
  int TexelReads; // texels behind them
};

// How far a point of the path lies above the relief, in depth; 0 or less is inside.
float exactClearance(HeightPath path, float part)
{
  return (1.0 - surfaceHeight(pathMap(path, part))) - pathDepth(path, part);
}

// No hit, and no work done.
HeightHit noHit()
{
  HeightHit hit;
  hit.Hit = false;
  hit.Part = 0.0;
  hit.RayDepth = 0.0;
  hit.MapCoord = vec2(0.0);
  hit.Relief = 0.0;
  hit.Closing = 0.0;
  hit.Iterations = 0;
  hit.Fetches = 0;
  hit.TexelReads = 0;
  return hit;
}

// A hit at a part of the path, after the work that `search` counts.
HeightHit hitAtPart(HeightPath path, float part, HeightHit search)
{
  HeightHit hit = search;
  hit.Hit = true;
  hit.Part = part;
  hit.RayDepth = pathDepth(path, part);
  hit.MapCoord = pathMap(path, part);
  hit.Relief = clamp(hit.RayDepth, 0.0, 1.0);
  return hit;
}
