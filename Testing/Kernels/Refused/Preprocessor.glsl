#define TWICE 2.0 // Refused: a kernel has no preprocessor line

float twice(float x)
{
  return TWICE * x;
}
