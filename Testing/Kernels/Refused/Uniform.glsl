uniform float scale; // Refused: at file level stand only const, struct and functions // Refused: uniform: a kernel is a pure function

float scaled(float x)
{
  return scale * x;
}
