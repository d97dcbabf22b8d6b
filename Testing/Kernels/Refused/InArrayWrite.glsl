float first(float values[2], in vec2 points[2], inout float fine[2])
{
  fine[0] = 1.0;
  values[0] = 1.0; // Refused: write to the in array values
  points[1].x += 1.0; // Refused: write to the in array points
  ++values[1]; // Refused: write to the in array values
  return values[1];
}
