float slope(float x)
{
  if (x > gl_FragCoord.x) // Refused: gl_FragCoord: a kernel is a pure function
  {
    discard; // Refused: discard: a kernel is a pure function
  }
  return dFdx(x); // Refused: dFdx: a kernel is a pure function
}
