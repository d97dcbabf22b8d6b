float twice(float x)
{
  return 2.0 * x @ x; // Refused: @ is no sign of GLSL
}
