// Moving a point off the relief, so that a ray that starts there does not meet it again.
//
// Needs Frame.glsl

// How far, in texels (truth-and-cost.md, `shadow`).
const float OffsetTexels = 1.0e-3;

// (du, dv, dheight) that moves a point OffsetTexels along the relief's geometric normal, outwards.
// mapU, mapV: object-space vector per map coordinate; heightAxis: per unit of height, D * n. They
// need be neither unit nor orthogonal. gradient: patchGradient at the point, height per map
// coordinate; size: of the map, in texels. A texel's length is the shorter of its two sides. The
// result is 0 where the three axes are degenerate (solveFrame).
vec3 offsetAlongNormal(vec3 mapU, vec3 mapV, vec3 heightAxis, vec2 gradient, ivec2 size)
{
  vec3 texelU = mapU / float(size.x);
  vec3 texelV = mapV / float(size.y);
  float texel = min(frameSize(texelU), frameSize(texelV));
  if (!frameSizeIsSound(texel))
  {
    return vec3(0.0);
  }
  texel = min(length(texelU / texel), length(texelV / texel)) * texel;
  // The surface's own tangents, in texels: q_u = p_u + h_u D n and q_v alike.
  vec3 surfaceU = (mapU + gradient.x * heightAxis) / texel;
  vec3 surfaceV = (mapV + gradient.y * heightAxis) / texel;
  vec3 normal = cross(surfaceU / frameSize(surfaceU), surfaceV / frameSize(surfaceV));
  float facing = dot(normal, heightAxis / frameSize(heightAxis)) < 0.0 ? -1.0 : 1.0;
  vec3 moved = facing * OffsetTexels * texel * normalize(normal);
  vec3 offset = vec3(0.0);
  if (!solveFrame(mapU, mapV, heightAxis, moved, offset))
  {
    offset = vec3(0.0);
  }
  return offset;
}
