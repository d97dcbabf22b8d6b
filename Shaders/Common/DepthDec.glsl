// Depth of the point that is drawn; 0.5 z + 0.5 since the projection gives [-1, 1].
uniform mat4 mesoVCDCMatrix;

float depthOf(vec3 positionVC)
{
  vec4 positionDC = mesoVCDCMatrix * vec4(positionVC, 1.0);
  return clamp(0.5 * positionDC.z / positionDC.w + 0.5, 0.0, 1.0);
}
