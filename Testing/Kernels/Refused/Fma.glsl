float twice(float x)
{
  return fma(x, 2.0, 0.0); // Refused: fma is not in GLSL 1.50
}
