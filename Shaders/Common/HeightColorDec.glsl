// Colour by the height at the hit, from one row of colours.
//   MESO_HEIGHT_COLORS  these chunks are in the shader
uniform sampler2D mesoHeightColors;
uniform vec2 mesoHeightColorRange; // heights at the row's two ends

// The bin that the height lies in, as vtkLookupTable chooses it; the end colours go on beyond.
vec3 colorOfHeight(float height)
{
  float size = float(textureSize(mesoHeightColors, 0).x);
  float place = size * (height - mesoHeightColorRange.x) /
    (mesoHeightColorRange.y - mesoHeightColorRange.x);
  return texelFetch(mesoHeightColors, ivec2(clamp(place, 0.0, size - 1.0), 0), 0).rgb;
}
