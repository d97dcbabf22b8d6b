// A kernel that Accepted.glsl and Refused/SwizzleOutToNeeded.glsl need.

const int AcceptedCount = 3;

struct AcceptedPair
{
  float Low;
  float High;
};

void acceptedOrder(inout AcceptedPair pair)
{
  if (pair.Low > pair.High)
  {
    float low = pair.High;
    pair.High = pair.Low;
    pair.Low = low;
  }
}

void acceptedSplit(vec2 from, out vec2 to)
{
  to = from;
}
