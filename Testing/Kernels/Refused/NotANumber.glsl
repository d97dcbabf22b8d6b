float odd(float x)
{
  return x + 1.0.0; // Refused: 1.0.0 is no number
}
