struct Pair
{
  float Low;
  float High;
};

Pair pairOf(float x)
{
  return Pair(x, x); // Refused: struct constructor Pair()
}
