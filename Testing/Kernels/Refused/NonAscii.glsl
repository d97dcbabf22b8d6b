float halved(float x)
{
  return 0.5 * x; // caf@NON_ASCII@ // Refused: not plain ASCII
}
