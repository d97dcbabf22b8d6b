double twice(float x) // Refused: double: write float
{
  dvec2 v = vec2(x); // Refused: dvec2: write float
  return v.x;
}
