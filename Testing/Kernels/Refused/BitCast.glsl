int bits(float x)
{
  return floatBitsToInt(x); // Refused: bit cast floatBitsToInt
}

float number(int bits)
{
  return intBitsToFloat(bits); // Refused: bit cast intBitsToFloat
}
