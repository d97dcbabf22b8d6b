float twice(float x)
{
  precise float y = 2.0 * x; // Refused: precise is not in GLSL 1.50
  return y;
}
