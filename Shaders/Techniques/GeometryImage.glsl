// Vertex stage of geometry images: Gu2002, Marschner2008 (Documentation/Techniques/References.md). A vertex is
// a sample of the image, known by its number alone.

uniform samplerBuffer mesoVertices; // position and normal, coordinate: two texels a sample

// What the attributes of a mesh are to other techniques.
vec2 mesoTCoord;
vec3 mesoNormal;
vec4 mesoVertexMC;
flat out int mesoCellVSOutput;

void placeVertex(int number, int piece)
{
  vec4 first = texelFetch(mesoVertices, 2 * number);
  vec4 second = texelFetch(mesoVertices, 2 * number + 1);
  mesoVertexMC = vec4(first.xyz, 1.0);
  mesoNormal = vec3(first.w, second.xy);
  mesoTCoord = second.zw;
  mesoCellVSOutput = piece;
}

vec4 colorHere()
{
  return vec4(1.0);
}

vec2 coordinateHere()
{
  return mesoTCoord;
}
