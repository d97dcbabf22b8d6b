// The prism that a fragment belongs to, from the table that vtkMesoPrismShell makes, and where the
// fragment's ray runs in it. Object space, counted from the table's centre. Stands on Kernels/Prism.
uniform sampler2D mesoPrisms;
uniform mat3 mesoViewToModel;  // of directions
uniform vec3 mesoBaseCentreVC; // the table's centre
uniform float mesoNearVC;      // distance of the near plane from the eye, along its axis

const int MESO_PRISM_ROWS = 7;       // of the table, for each prism
const int MESO_PRISMS_IN_LINE = 1024; // of the texture: MesoPrismTexture's

// How map coordinates lie over a prism, linear in b1 and b2, and where they go on.
struct PrismChart
{
  vec2 Map;
  vec2 AlongB1;
  vec2 AlongB2;
  ivec3 Beyond; // numbers of the prisms beyond the fins, -1: none
};

Prism fetchPrism(int number, out PrismChart chart)
{
  int line = number / MESO_PRISMS_IN_LINE;
  ivec2 first = ivec2(MESO_PRISM_ROWS * (number - line * MESO_PRISMS_IN_LINE), line);
  vec4 bottom0 = texelFetch(mesoPrisms, first, 0);
  vec4 bottom1 = texelFetch(mesoPrisms, first + ivec2(1, 0), 0);
  vec4 bottom2 = texelFetch(mesoPrisms, first + ivec2(2, 0), 0);
  vec4 rise0 = texelFetch(mesoPrisms, first + ivec2(3, 0), 0);
  vec4 rise1 = texelFetch(mesoPrisms, first + ivec2(4, 0), 0);
  vec4 rise2 = texelFetch(mesoPrisms, first + ivec2(5, 0), 0);
  Prism p;
  p.Bottom0 = bottom0.xyz;
  p.Bottom1 = bottom1.xyz;
  p.Bottom2 = bottom2.xyz;
  p.Rise0 = rise0.xyz;
  p.Rise1 = rise1.xyz;
  p.Rise2 = rise2.xyz;
  vec4 links = texelFetch(mesoPrisms, first + ivec2(6, 0), 0);
  p.Flags = int(links.x);
  chart.Beyond = ivec3(links.yzw);
  chart.Map = vec2(bottom0.w, rise0.w) * mesoTiles;
  chart.AlongB1 = vec2(bottom1.w, rise1.w) * mesoTiles - chart.Map;
  chart.AlongB2 = vec2(bottom2.w, rise2.w) * mesoTiles - chart.Map;
  return p;
}

// (x, y, z) of texture space for (b1, b2, z).
vec3 chartPlace(PrismChart chart, vec3 place)
{
  return vec3(chart.Map + place.x * chart.AlongB1 + place.y * chart.AlongB2, place.z);
}

// The same for a change of place.
vec3 chartWay(PrismChart chart, vec3 way)
{
  return vec3(way.x * chart.AlongB1 + way.y * chart.AlongB2, way.z);
}

// A gradient over texture space as one over (b1, b2, z).
vec3 chartGradient(PrismChart chart, vec3 gradient)
{
  return vec3(dot(chart.AlongB1, gradient.xy), dot(chart.AlongB2, gradient.xy), gradient.z);
}

vec3 modelPointOf(vec3 positionVC)
{
  return mesoViewToModel * (positionVC - mesoBaseCentreVC);
}

// Unit normal in view space of one in object space, of any length; the eye's direction where it has none.
vec3 viewNormal(vec3 normalMC, vec3 viewVC)
{
  vec3 normalVC = transpose(mesoViewToModel) * normalMC;
  float size = length(normalVC);
  return size > 0.0 ? normalVC / size : -viewVC;
}
