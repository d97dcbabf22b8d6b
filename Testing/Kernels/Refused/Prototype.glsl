float later(float x); // Refused: prototype of later

float now(float x)
{
  return later(x);
}
