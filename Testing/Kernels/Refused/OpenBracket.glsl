float twice(float x)
{ // Refused: bracket without a partner
  return 2.0 * x;
