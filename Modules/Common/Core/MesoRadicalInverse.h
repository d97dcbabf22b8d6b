#ifndef MesoRadicalInverse_h
#define MesoRadicalInverse_h

/// The radical inverse of an index: points that cover [0,1) evenly, whatever their number.
inline double MesoRadicalInverse(int index, int base)
{
  double value = 0.;
  double digit = 1. / base;
  for (; index > 0; index /= base, digit /= base)
  {
    value += digit * (index % base);
  }
  return value;
}

#endif
