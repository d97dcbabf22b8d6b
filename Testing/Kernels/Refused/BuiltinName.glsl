float mix(float a, float b) // Refused: function mix is named like one of GLSL's
{
  return 0.5 * (a + b);
}

vec4 texture(vec2 uv) // Refused: function texture is named like one of GLSL's // Refused: texture: only accessors know a sampler
{
  return vec4(uv, 0.0, 1.0);
}
