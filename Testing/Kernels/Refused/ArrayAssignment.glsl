float first(const float values[2])
{
  float copy[2];
  copy = values; // Refused: assignment to the whole array copy
  copy[0] = 1.0;
  float other[2] = copy; // Refused: assignment to the whole array other
  return copy[1] + other[0];
}
