// Vertex stage of displacement: no vertex comes in. Each is a point of a lattice over one of the base's
// triangles, known by its number alone, and is moved by the height map: Cook1984, Marschner2008
// (Documentation/Techniques/References.md). Stands on Common/HeightAccess, Kernels/HeightField,
// Kernels/BarycentricGrid and Kernels/DisplacedNormal.
//   MESO_SHADING     normals are those of the displaced surface, else the base's
//   MESO_SECOND_ORDER and know how the base bends
//   MESO_COLORED     corners have colours of their own
//   MESO_COORDINATES corners have texture coordinates of their own for VTK's textures

uniform samplerBuffer mesoCorners; // by triangle: position and normal, coordinate, of each corner
uniform samplerBuffer mesoPieces;  // MesoGridPieces
uniform int mesoCornerTexels;      // of a triangle
uniform int mesoFirstPiece;
uniform vec3 mesoBufferScale;      // positions in the buffer over object units
uniform vec2 mesoTiles;
uniform float mesoScale;     // D in object units
uniform float mesoReference; // height that lies on the base

struct MesoGridPoint
{
  vec3 Position; // as in the buffer
  vec3 Normal;   // interpolated, not unit
  vec2 Coord;    // the mesh's own
};

// What the attributes of a mesh are to other techniques.
vec2 mesoTCoord;
vec3 mesoNormal;     // of the displaced surface
vec3 mesoBaseNormal;
vec3 mesoTangent;    // dp/du by the mesh's own coordinate, across the normal
vec3 mesoBitangent;
vec2 mesoTileScale;
float mesoRelief;
vec4 mesoVertexMC;
flat out int mesoCellVSOutput; // the base's triangle

MesoGridPoint mesoCornerPoints[3];
int mesoTriangleTexel; // its first
vec3 mesoWeights;      // of the corners, where the point lies

MesoGridPoint cornerAt(int corner)
{
  vec4 first = texelFetch(mesoCorners, mesoTriangleTexel + 2 * corner);
  vec4 second = texelFetch(mesoCorners, mesoTriangleTexel + 2 * corner + 1);
  MesoGridPoint point;
  point.Position = first.xyz;
  point.Normal = vec3(first.w, second.xy);
  point.Coord = second.zw;
  return point;
}

// Exactly either end at 0 and 1.
MesoGridPoint between(MesoGridPoint a, MesoGridPoint b, float along)
{
  MesoGridPoint point;
  point.Position = a.Position + along * (b.Position - a.Position);
  point.Normal = a.Normal + along * (b.Normal - a.Normal);
  point.Coord = a.Coord + along * (b.Coord - a.Coord);
  return point;
}

// The point on edge k, from corner k to the next, that a step of the lattice comes to lie on. All
// triangles at the edge count from the same end and come to the same point, bit for bit.
MesoGridPoint onEdge(int k, int step, int rows, int segments)
{
  int next = k == 2 ? 0 : k + 1;
  int taken = stepOnEdge(step, rows, segments);
  int count = abs(segments);
  int from = segments < 0 ? next : k;
  int to = segments < 0 ? k : next;
  float along = float(taken) / float(count);
  mesoWeights = vec3(0.0);
  mesoWeights[from] = 1.0 - along;
  mesoWeights[to] = along;
  if (taken == 0)
  {
    return mesoCornerPoints[from];
  }
  if (taken == count)
  {
    return mesoCornerPoints[to];
  }
  return between(mesoCornerPoints[from], mesoCornerPoints[to], along);
}

MesoGridPoint latticePlace(ivec2 at, int rows, ivec3 segments)
{
  if (at.y == 0)
  {
    return onEdge(0, at.x, rows, segments.x);
  }
  if (at.x == 0)
  {
    return onEdge(2, rows - at.y, rows, segments.z);
  }
  if (at.x + at.y == rows)
  {
    return onEdge(1, at.y, rows, segments.y);
  }
  vec2 weight = vec2(at) / float(rows);
  mesoWeights = vec3(1.0 - weight.x - weight.y, weight);
  MesoGridPoint a = mesoCornerPoints[0];
  MesoGridPoint b = mesoCornerPoints[1];
  MesoGridPoint c = mesoCornerPoints[2];
  MesoGridPoint point;
  point.Position =
    a.Position + weight.x * (b.Position - a.Position) + weight.y * (c.Position - a.Position);
  point.Normal = a.Normal + weight.x * (b.Normal - a.Normal) + weight.y * (c.Normal - a.Normal);
  point.Coord = a.Coord + weight.x * (b.Coord - a.Coord) + weight.y * (c.Coord - a.Coord);
  return point;
}

void placeVertex(int number, int piece)
{
  vec4 where = texelFetch(mesoPieces, 2 * (mesoFirstPiece + piece));
  vec4 edges = texelFetch(mesoPieces, 2 * (mesoFirstPiece + piece) + 1);
  mesoCellVSOutput = int(where.x);
  mesoTriangleTexel = mesoCellVSOutput * mesoCornerTexels;
  for (int k = 0; k < 3; ++k)
  {
    mesoCornerPoints[k] = cornerAt(k);
  }
  ivec2 at = ivec2(where.yz) + int(edges.w) * latticePoint(number);
  MesoGridPoint point = latticePlace(at, int(where.w), ivec3(edges.xyz));

  float normalSize = length(point.Normal);
  vec3 normal = normalSize > 0.0 ? point.Normal / normalSize : point.Normal;
  vec2 mapCoord = point.Coord * mesoTiles;
  float height = bilinearHeight(mapCoord);
  float offset = height - mesoReference;
  mesoVertexMC = vec4(point.Position + mesoBufferScale * (offset * mesoScale * normal), 1.0);
  mesoTCoord = point.Coord;
  mesoRelief = 1.0 - height;
  mesoBaseNormal = normal;
  mesoNormal = normal;

  vec2 edgeA = mesoCornerPoints[1].Coord - mesoCornerPoints[0].Coord;
  vec2 edgeB = mesoCornerPoints[2].Coord - mesoCornerPoints[0].Coord;
  vec2 largest = max(abs(mesoCornerPoints[0].Coord), max(abs(mesoCornerPoints[1].Coord),
    abs(mesoCornerPoints[2].Coord)));
  // Texture coordinates are floats: what they span but for rounding.
  float least = 4.0 * 5.9604645e-8 * max(largest.x, largest.y) *
    (abs(edgeA.x) + abs(edgeA.y) + abs(edgeB.x) + abs(edgeB.y));
  vec3 perU;
  vec3 perV;
  bool spans = perMapCoord(edgeA, edgeB, least,
    (mesoCornerPoints[1].Position - mesoCornerPoints[0].Position) / mesoBufferScale,
    (mesoCornerPoints[2].Position - mesoCornerPoints[0].Position) / mesoBufferScale, perU, perV);
  mesoTangent = across(perU, normal);
  mesoBitangent = across(perV, normal);
  mesoTileScale = vec2(1.0);
#ifdef MESO_SHADING
  vec3 turnU = vec3(0.0);
  vec3 turnV = vec3(0.0);
#ifdef MESO_SECOND_ORDER
  if (normalSize > 0.0)
  {
    perMapCoord(edgeA, edgeB, least,
      (mesoCornerPoints[1].Normal - mesoCornerPoints[0].Normal) / normalSize,
      (mesoCornerPoints[2].Normal - mesoCornerPoints[0].Normal) / normalSize, turnU, turnV);
  }
#endif
  if (spans)
  {
    mesoNormal = displacedNormal(perU, perV, normal, turnU, turnV,
      heightGradient(mapCoord) * mesoTiles, offset, mesoScale);
  }
#endif
}

#ifdef MESO_COLORED
vec4 colorHere()
{
  vec4 color = vec4(0.0);
  for (int k = 0; k < 3; ++k)
  {
    color += mesoWeights[k] * texelFetch(mesoCorners, mesoTriangleTexel + 6 + k);
  }
  return color;
}
#endif

#ifdef MESO_COORDINATES
vec2 coordinateHere()
{
  vec4 first = texelFetch(mesoCorners, mesoTriangleTexel + 6);
  vec4 second = texelFetch(mesoCorners, mesoTriangleTexel + 7);
  return mesoWeights.x * first.xy + mesoWeights.y * first.zw + mesoWeights.z * second.xy;
}
#else
vec2 coordinateHere()
{
  return mesoTCoord;
}
#endif
