const float One = 1; // Refused: int literal 1 among floats

float scaled(float x, int i)
{
  float y = 2; // Refused: int literal 2 among floats
  y += 3; // Refused: int literal 3 among floats
  y = x * 4; // Refused: int literal 4 among floats
  y = 5 - x; // Refused: int literal 5 among floats
  y = floor(x) / 6; // Refused: int literal 6 among floats
  y = float(i * 2 + 1);
  if (x < 7) // Refused: int literal 7 among floats
  {
    return -8; // Refused: int literal 8 among floats
  }
  vec2 v = vec2(0, 1.0); // Refused: int literal 0 among floats
  y = max(x, 9); // Refused: int literal 9 among floats
  y = pow(x, 10); // Refused: int literal 10 among floats
  y = v.x * 11; // Refused: int literal 11 among floats
  y = scaled(12, 13); // Refused: int literal 12 among floats
  return y;
}
