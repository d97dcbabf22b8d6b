float counter = 0.0; // Refused: at file level stand only const, struct and functions

float next()
{
  counter += 1.0;
  return counter;
}
