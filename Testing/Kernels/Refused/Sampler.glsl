float height(sampler2D map, vec2 uv) // Refused: sampler2D: only accessors know a sampler
{
  return textureLod(map, uv, 0.0).x; // Refused: textureLod: only accessors know a sampler
}
