const float Large = 1e5; // Refused: literal 1e5 has no decimal point

float scaled(float x)
{
  return x * 1.e-5 + 2E-3; // Refused: literal 2E-3 has no decimal point
}
