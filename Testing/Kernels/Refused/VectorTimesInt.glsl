vec2 scaled(vec2 v, int n, mat2 m)
{
  vec2 w = v * 2; // Refused: int literal 2 among floats
  w = v * n; // Refused: vec2 * int: write float(...)
  w = n * (m * v) + v;
  w = n / v; // Refused: int / vec2: write float(...)
  w = v.yx - n; // Refused: vec2 - int: write float(...)
  return w * float(n);
}
