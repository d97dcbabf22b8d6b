/* one comment
   gl_FragData[1] // Refused: gl_FragData is taken for an output
*/
float same(float x)
{
  return x;
}
