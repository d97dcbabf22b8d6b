// The contract of a technique for those that draw a shell of prisms: one fragment for each stretch of the
// ray in the shell, where it comes in by a face that looks to the eye. From there it is followed from prism to prism.
// Stands on Common/PrismMatter. The technique, or Common/PrismPieces for it, defines what is declared here.

// A piece of a ray's way, straight in texture space, in mesoPrism, and what is met on it.
struct ShellPiece
{
  float Start; // along the ray
  float End;
  vec3 Before; // (b1, b2, z)
  vec3 After;
  bool First; // of its prism
  VolumeHit Met;
};

// Follows a stretch of a ray in mesoPrism, from piece.After, until matter is met.
void followInPrism(
  PrismSpan span, vec3 origin, vec3 direction, inout ShellPiece piece, inout MesoSurfaceHit hit);
// What was met on a straight way in texture space, as near as the technique can say. All that is done once, at
// the end, is kept out of the loop over prisms: devices that run several pixels as one do there what one of them
// does for all.
VolumeHit refineMeeting(vec3 from, vec3 span, VolumeHit hit);

// Prisms that a ray is followed through before it is given up, and those of them that it has nothing of, as
// rounding may have it at their edges.
const int MESO_MOST_PRISMS = 4096;
const int MESO_MOST_MISSED = 16;

// Where the fragment's ray begins to be in the shell, as a stretch in mesoPrism, and near which (b1, b2, z);
// false where another fragment answers for it. Only with the eye in the shell do backs of faces answer, for rays
// that come out of it here.
bool beginStretch(MesoFragment f, bool frontFacing, vec3 origin, vec3 direction,
  out PrismSpan span, inout vec3 place);
// Goes on to the next stretch, in the next prism; false where there is none.
bool nextStretch(vec3 origin, vec3 direction, inout PrismSpan span);

// Whether the shell is cut open where the ray came in: matter that is met there shows its cut.
bool entersByCut(PrismSpan span)
{
  return span.Face >= 0 && (span.Face < 2 || ((mesoPrism.Flags >> (span.Face + 1)) & 1) != 0);
}

void takeNormals(MesoFragment f, PrismSpan span, bool atStart, inout MesoSurfaceHit hit)
{
  mesoAtCut = atStart && entersByCut(span);
  if (mesoAtCut)
  {
    hit.NormalVC = viewNormal(prismFaceNormal(mesoPrism, span.Face, mesoPlace), f.ViewVC);
    hit.FacetNormalVC = hit.NormalVC;
  }
  else if (atStart && span.Face < 0)
  {
    hit.NormalVC = -f.ViewVC;
    hit.FacetNormalVC = -f.ViewVC;
  }
  else
  {
    takeMatterNormals(f, hit);
  }
}

MesoSurfaceHit traceSurface(MesoFragment f)
{
  MesoSurfaceHit hit = baseSurface(f);
  mesoAtCut = false;
  vec3 origin = modelPointOf(f.PositionVC);
  vec3 direction = mesoViewToModel * f.ViewVC;
  PrismSpan span;
  ShellPiece piece;
  piece.After = vec3(1.0 / 3.0, 1.0 / 3.0, 0.5);
  bool within = beginStretch(f, gl_FrontFacing, origin, direction, span, piece.After);
  piece.Met.Found = false;
  int missed = 0;
  for (int i = 0; within && i < MESO_MOST_PRISMS && missed < MESO_MOST_MISSED; ++i)
  {
    if (span.Enter <= span.Leave)
    {
      piece.After = prismPlace(mesoPrism, origin + span.Enter * direction, piece.After);
      followInPrism(span, origin, direction, piece, hit);
      if (piece.Met.Found)
      {
        break;
      }
    }
    else
    {
      ++missed;
    }
    int left = span.Exit;
    within = nextStretch(origin, direction, span);
    piece.After = left < 2 || span.Face < 2
      ? vec3(1.0 / 3.0, 1.0 / 3.0, 0.5)
      : placeOnFin(span.Face - 2, 1.0 - alongFin(left - 2, piece.After), piece.After.z);
  }
  hit.Found = piece.Met.Found;
  if (hit.Found)
  {
    VolumeHit met = refineMeeting(chartPlace(mesoChart, piece.Before),
      chartWay(mesoChart, piece.After - piece.Before), piece.Met);
    hit.Fetches += met.Fetches - piece.Met.Fetches;
    hit.TexelReads = 8 * hit.Fetches;
    hit.RayLength = mix(piece.Start, piece.End, met.Part);
    mesoPlace = mix(piece.Before, piece.After, met.Part);
    hit.MapCoord = chartPlace(mesoChart, mesoPlace).xy;
    hit.Relief = clamp(1.0 - mesoPlace.z, 0.0, 1.0);
    takeNormals(f, span, piece.First && met.Part == 0.0, hit);
  }
  return hit;
}
