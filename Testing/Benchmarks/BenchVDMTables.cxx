// What finer tables of view-dependent displacements gain: scenes drawn by tables of several sizes, at several
// ranks, against the true surface, beside what a certified search over the quadric leaves. Look-ups are the
// same for all; a bake's seconds and the bytes of its factors stand beside.
//
//   BenchVDMTables WIDTH HEIGHT SCENE TABLE...   a scene of Data/Bench, of which the first node is measured;
//                                                tables as TEXELSxAZIMUTHSxPOLARS
//
// prints a table of comma-separated values.

#include "MesoGeometryError.h"
#include "VDMDrawn.h"

#include <cstdlib>

namespace
{
using namespace VDMDrawn;

void PrintErrors(const MesoAOVs& truth, const MesoAOVs& drawn)
{
  const MesoGeometryError error = MesoCompareGeometry(truth, drawn);
  std::printf("%.3f,%.3f,%.4f,%.4f\n", error.Texcoord.P50, error.Texcoord.P95, error.CoverageIou,
    error.ShadowCast);
  std::fflush(stdout);
}

void Measure(const MesoScene& scene, int width, int height, const MesoAOVs& truth, const Size& size)
{
  vtkNew<vtkMesoVDM> filter;
  BakeAtSize(filter, scene, size, MostFactors);
  for (const int rank : { 4, 8, 12 })
  {
    std::printf("%dx%dx%d,%d,%.1f,%.1f,", size.Texels, size.Azimuths, size.Polars, rank,
      filter->GetRaySeconds() + filter->GetFactorSeconds(),
      double(size.Texels) * size.Texels * size.Azimuths * rank / 1048576.);
    PrintErrors(truth,
      DrawnAOVs(SceneAtRank(scene, rank), width, height,
        [&](const MesoSceneBuilder& builder)
        { MapperOf(builder)->SetTable(filter->GetOutput()); }));
  }
}
}

int main(int argc, char** argv)
{
  if (argc < 5)
  {
    std::fprintf(stderr, "usage: BenchVDMTables WIDTH HEIGHT SCENE TEXELSxAZIMUTHSxPOLARS...\n");
    return 2;
  }
  const int width = std::atoi(argv[1]);
  const int height = std::atoi(argv[2]);
  const MesoScene scene = MesoReadScene(argv[3]);
  const MesoAOVs truth = TruthOf(scene, width, height);
  std::printf("table,rank,bake s,MB,texels median,texels p95,overlap,other cast shadow\n");
  MesoScene searched = SceneAtRank(scene, 0);
  searched.Nodes[0].Mesostructure.Technique = MesoTechnique::ReliefQuadric;
  searched.Nodes[0].Mesostructure.Quality = MesoQuality::Certified;
  std::printf("relief-quadric certified,,,,");
  PrintErrors(truth, DrawnAOVs(searched, width, height));
  for (int i = 4; i < argc; ++i)
  {
    Size size;
    if (!size.Parse(argv[i]))
    {
      std::fprintf(stderr, "%s is no table's size\n", argv[i]);
      return 2;
    }
    Measure(scene, width, height, truth, size);
  }
  return 0;
}
