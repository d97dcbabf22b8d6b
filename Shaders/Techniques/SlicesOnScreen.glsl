// Mesostructure in a shell as a stack of slices parallel to the projection plane (Meyer1998), at the same depths
// before the eye in all prisms, so that what one prism has of a slice meets what its neighbours have. A pixel shows
// the first slice on its ray that lies in matter: the slices are not drawn one by one, but met on the ray's way
// from prism to prism. Where the shell ends it shows the cut through matter, as if a slice lay there. Stands on
// Common/PrismShell and Common/SliceMatter.
uniform float mesoSliceSpacing; // between two slices, object units

const float MESO_MOST_SLICES = 65536.0; // in a prism

VolumeHit refineMeeting(vec3 from, vec3 span, VolumeHit hit)
{
  return hit;
}

// Whether there is matter so far along the ray.
void lookAt(
  float along, vec3 origin, vec3 direction, inout ShellPiece piece, inout MesoSurfaceHit hit)
{
  piece.Start = along;
  piece.End = along;
  piece.After = prismPlace(mesoPrism, origin + along * direction, piece.After);
  piece.Before = piece.After;
  piece.Met.Part = 0.0;
  piece.Met.Fetches = 1;
  piece.Met.Found = sampleVolume(chartPlace(mesoChart, piece.After)) <= 0.0;
  hit.Fetches += 1;
  hit.Iterations += 1;
}

void followInPrism(
  PrismSpan span, vec3 origin, vec3 direction, inout ShellPiece piece, inout MesoSurfaceHit hit)
{
  // Matter that the shell's end cuts, or the near plane, is seen there, and not from the next slice on.
  if (span.Face < 0 || entersByCut(span))
  {
    lookAt(span.Enter, origin, direction, piece, hit);
  }
  piece.First = piece.Met.Found;
  // Slices are counted from the shell's middle: they stay where they are when the eye moves along its axis.
  vec3 inwards = -vec3(mesoModelToView[0].z, mesoModelToView[1].z, mesoModelToView[2].z) *
    (length(mesoViewToModel[2]) / mesoSliceSpacing);
  float before = dot(inwards, origin);
  float rate = dot(inwards, direction);
  // One prism has a slice at its entry, and the one before has not: no ray passes a slice between two prisms.
  float first = ceil(before + rate * span.Enter);
  float end = min(before + rate * span.Leave, first + MESO_MOST_SLICES);
  for (float slice = first; slice < end && !piece.Met.Found; slice += 1.0)
  {
    lookAt((slice - before) / rate, origin, direction, piece, hit);
  }
}
