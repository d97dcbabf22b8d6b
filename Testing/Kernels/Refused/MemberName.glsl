struct Odd
{
  float Fine;
  vec2 xy; // Refused: member xy looks like a swizzle
  float r; // Refused: member r looks like a swizzle
  float st[2]; // Refused: member st looks like a swizzle
};
