int ones(int x)
{
  return bitCount(x); // Refused: bitCount is not in GLSL 1.50
}
