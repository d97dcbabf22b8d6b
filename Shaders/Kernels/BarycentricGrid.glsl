// Points of a triangle's barycentric lattice, counted row by row from the corner where I = J = 0: row r
// has the points with I + J = r, J growing. The first (n + 1)(n + 2) / 2 are the lattice of n rows. All
// in whole numbers, so that neighbours agree to the last bit.

// I and J of a point by its number, 0 to 2^22.
ivec2 latticePoint(int number)
{
  int row = int(0.5 * (sqrt(8.0 * float(number) + 1.0) - 1.0));
  // The root may be off by its rounding.
  row = row * (row + 1) / 2 > number ? row - 1 : row;
  row = (row + 1) * (row + 2) / 2 <= number ? row + 1 : row;
  int place = number - row * (row + 1) / 2;
  return ivec2(row - place, place);
}

// Where on an edge that is cut into segments the lattice's point `step` of `rows` comes to lie: the
// nearest of the segments' ends, counted from the edge's own first end. With at least as many rows as
// segments each of the ends is met. A negative number of segments: the lattice counts from the other end.
int stepOnEdge(int step, int rows, int segments)
{
  int along = segments < 0 ? rows - step : step;
  int count = abs(segments);
  return (2 * along * count + rows) / (2 * rows);
}
