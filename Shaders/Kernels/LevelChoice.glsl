// Which levels of a height map's pyramid (HeightLevels) a pixel sees where texels are smaller than pixels: one
// whose heights rays meet, and one whose slopes are shaded.
//
// Of steep walls one sees the front and not the back, so that their mean is another, brighter picture: no level is
// chosen that lacks much of the map's slopes. Shading may lack less of them than what rays meet: where walls
// are shaded that rays find too flat, their backs are seen.

// Levels whose slopes are known, the map among them.
const int ComparedLevels = 16;

// Mean square slope, object space, that a level may lack in any case: relief as gentle as that may be averaged.
const float GentleSlope = 0.5625;
// Shares of the map's own mean square slope that a level may lack however steep it is.
const float SearchedShare = 0.2;
const float ShadedShare = 0.1;
// Share that a level must lack to shade as rough; twice that makes it wholly so.
const float LeastRoughShare = 0.4;
// For charts that all but vanish: squares of more could overflow. Levels are chosen so that it is 1 or so.
const float MostRoughness = 1.0e6;

struct PixelLevels
{
  int Searched;
  float Shaded; // between two levels, or one of them
};

// The levels, between two or one of them, up to which the mean square slope that is lacking stays below `most`.
// lost: mean squares of slopes along u and v, height per map coordinate: [0] of the map itself, [l] what level l
// lacks of it. perLength: what makes them those of the surface, (D / |dp/du|)^2 and (D / |dp/dv|)^2.
vec2 levelsBelowLoss(vec2 most, const vec2 lost[ComparedLevels], vec2 perLength)
{
  vec2 levels = vec2(0.0);
  float before = 0.0;
  for (int level = 1; level < ComparedLevels; ++level)
  {
    float lacking = dot(lost[level], perLength);
    levels += clamp((most - before) / max(lacking - before, 1.0e-20), 0.0, 1.0);
    before = max(before, lacking);
  }
  return levels;
}

// The levels of a pixel, at most `last`. stepX, stepY: from a pixel to its neighbours over the base mesh, in texels
// of the map. Texels that rays meet are half to one of a pixel's shorter side, those that are shaded half a pixel, by
// areas. Numbers that are none choose the map.
PixelLevels levelsOfPixel(
  vec2 stepX, vec2 stepY, const vec2 lost[ComparedLevels], vec2 perLength, int last)
{
  float area = abs(stepX.x * stepY.y - stepX.y * stepY.x);
  float longest = sqrt(max(dot(stepX, stepX), dot(stepY, stepY)));
  float shorter = longest > 0.0 ? area / longest : 0.0;
  vec2 most = max(
    vec2(GentleSlope), vec2(SearchedShare, ShadedShare) * dot(lost[0], perLength));
  vec2 levels = min(levelsBelowLoss(most, lost, perLength), vec2(float(last)));
  levels.x = min(levels.x, log2(max(shorter, 1.0)));
  levels.y = min(levels.y, log2(max(sqrt(area), 1.0)) - 1.0);
  PixelLevels chosen;
  chosen.Searched = levels.x > 0.0 ? int(levels.x) : 0;
  chosen.Shaded = levels.y > 0.0 ? levels.y : 0.0;
  return chosen;
}

// Of numbers of levels, what is between two of them; level 0 has none.
vec2 betweenLevels(float level, const vec2 numbers[ComparedLevels])
{
  int below = min(int(level), ComparedLevels - 2);
  vec2 from = below > 0 ? numbers[below] : vec2(0.0);
  return mix(from, numbers[below + 1], clamp(level - float(below), 0.0, 1.0));
}

// The variances along u and v, object space, of the slopes of a rough surface (RoughRelief) that stands for what a
// level, or what is between two of them, lacks. Only where that is most of the map's slopes: of what is left else, walls
// above all, rays find how it hides and shades. roughness: those of each level, height per map coordinate.
vec2 roughnessOfLevel(float level, const vec2 lost[ComparedLevels],
  const vec2 roughness[ComparedLevels], vec2 perLength)
{
  float share =
    dot(betweenLevels(level, lost), perLength) / max(dot(lost[0], perLength), 1.0e-20);
  if (!(share > LeastRoughShare))
  {
    return vec2(0.0);
  }
  float part = min((share - LeastRoughShare) / LeastRoughShare, 1.0);
  return min(part * perLength * betweenLevels(level, roughness), vec2(MostRoughness));
}
