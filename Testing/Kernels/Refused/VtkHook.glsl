float same(float x)
{
  //VTK::Light::Impl // Refused: //VTK:: is taken for a hook
  return x;
}
