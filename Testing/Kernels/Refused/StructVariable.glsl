struct Pair // Refused: a struct ends with };
{
  float Low;
} pair;
