// How much of a pixel contour lines cover: lines of a constant width on the screen, box filtered, so
// that they are smooth however dense they are.
//
// A pixel sees the number `value` at its centre, which changes by perPixel over one pixel across the
// lines. Within the pixel it is taken as straight.

// A number that changes by less than this over a pixel is flat: no line. On a plateau that lies at a
// line's own height the line is drawn along its edge, not over all of it.
const float ContourLeastChange = 1.0e-6;

// Lines so near to 0 and 1 are taken as being there.
const float ContourEnds = 1.0e-5;

// The integral from 0 to x of pulses around each whole number: 1 up to halfWidth away from it, else
// 0. halfWidth is in [0, 1/2].
float pulsesUpTo(float x, float halfWidth)
{
  float nearest = floor(x + 0.5);
  return 2.0 * halfWidth * nearest + clamp(x - nearest, -halfWidth, halfWidth);
}

// Lines `width` pixels wide at offset and all whole multiples of spacing from it that lie between 0 and
// 1. spacing > 0. At 0 and 1 themselves, the ends of all heights, there are summits and grounds, no
// lines.
float evenContours(float value, float perPixel, float spacing, float offset, float width)
{
  if (!(perPixel >= ContourLeastChange))
  {
    return 0.0;
  }
  float linesPerPixel = perPixel / spacing;
  float halfWidth = min(0.5 * width * linesPerPixel, 0.5);
  float line = (value - offset) / spacing;
  float nearest = offset + spacing * floor(line + 0.5);
  if (linesPerPixel < 1.0 && !(nearest > ContourEnds && nearest < 1.0 - ContourEnds))
  {
    return 0.0;
  }
  line = line - floor(line); // differences of large numbers would lose the digits that count
  float reach = 0.5 * linesPerPixel;
  float covered =
    (pulsesUpTo(line + reach, halfWidth) - pulsesUpTo(line - reach, halfWidth)) / linesPerPixel;
  return clamp(covered, 0.0, 1.0);
}

// One line `width` pixels wide at the number `at`.
float oneContour(float value, float perPixel, float at, float width)
{
  if (!(perPixel >= ContourLeastChange))
  {
    return 0.0;
  }
  float pixels = abs(value - at) / perPixel; // from the pixel's centre to the line's
  return clamp(min(0.5 * width, pixels + 0.5) - max(-0.5 * width, pixels - 0.5), 0.0, 1.0);
}
