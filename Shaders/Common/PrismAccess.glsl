// The prism that a fragment belongs to, from the table that vtkMesoPrismShell makes, and where the
// fragment's ray runs in it. Object space, counted from the table's centre. Stands on Kernels/Prism.
uniform sampler2D mesoPrisms;
uniform mat3 mesoViewToModel;  // of directions
uniform vec3 mesoBaseCentreVC; // the table's centre
uniform float mesoNearVC;      // distance of the near plane from the eye, along its axis

const int MESO_PRISM_ROWS = 7; // of the table, for each prism

// How map coordinates lie over a prism, linear in b1 and b2, and where they go on.
struct PrismChart
{
  vec2 Map;
  vec2 AlongB1;
  vec2 AlongB2;
  ivec3 Beyond; // numbers of the prisms beyond the fins, -1: none
};

vec4 fetchPrismRow(int row)
{
  int width = textureSize(mesoPrisms, 0).x;
  return texelFetch(mesoPrisms, ivec2(row % width, row / width), 0);
}

Prism fetchPrism(int number, out PrismChart chart)
{
  int first = MESO_PRISM_ROWS * number;
  vec4 bottom0 = fetchPrismRow(first);
  vec4 bottom1 = fetchPrismRow(first + 1);
  vec4 bottom2 = fetchPrismRow(first + 2);
  vec4 rise0 = fetchPrismRow(first + 3);
  vec4 rise1 = fetchPrismRow(first + 4);
  vec4 rise2 = fetchPrismRow(first + 5);
  Prism p;
  p.Bottom0 = bottom0.xyz;
  p.Bottom1 = bottom1.xyz;
  p.Bottom2 = bottom2.xyz;
  p.Rise0 = rise0.xyz;
  p.Rise1 = rise1.xyz;
  p.Rise2 = rise2.xyz;
  vec4 links = fetchPrismRow(first + 6);
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
