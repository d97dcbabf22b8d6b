float sum(const float values[4])
{
  float total = 0.0;
  for (int i = 0; i < values.length(); ++i) // Refused: .length() of an array
  {
    total += values[i];
  }
  return total;
}
