// A ray's way through a prism as straight in texture space, or cut into several straight pieces (Wang2004,
// section 3.2). Stands on Common/PrismShell. The technique defines the function that is declared here.
//   MESO_SEGMENTS  straight pieces of a ray's way through a prism

// The first meeting with matter of a straight way in texture space, part in [0, 1]; at part 0 where it
// starts in matter.
VolumeHit meetMatter(vec3 from, vec3 span);

void followInPrism(
  PrismSpan span, vec3 origin, vec3 direction, inout ShellPiece piece, inout MesoSurfaceHit hit)
{
  piece.End = span.Enter;
  for (int i = 1; i <= MESO_SEGMENTS && !piece.Met.Found; ++i)
  {
    piece.First = i == 1;
    piece.Start = piece.End;
    piece.Before = piece.After;
    piece.End = mix(span.Enter, span.Leave, float(i) / float(MESO_SEGMENTS));
    piece.After = prismPlace(mesoPrism, origin + piece.End * direction, piece.Before);
    piece.Met = meetMatter(
      chartPlace(mesoChart, piece.Before), chartWay(mesoChart, piece.After - piece.Before));
    hit.Fetches += piece.Met.Fetches;
    hit.Iterations += piece.Met.Steps;
  }
}
