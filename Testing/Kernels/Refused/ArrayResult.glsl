float[2] pair(float x) // Refused: array type float[]
{
  return float[2](x, x); // Refused: array type float[]
}
