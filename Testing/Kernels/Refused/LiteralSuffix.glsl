float twice(float x)
{
  return 2.0f * x + 1f; // Refused: literal 2.0f: no suffix // Refused: literal 1f: no suffix
}
