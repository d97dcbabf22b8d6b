int wrapped(int i, int n)
{
  i %= n; // Refused: % of negative ints
  return i % n; // Refused: % of negative ints
}
