#ifndef MesoReliefTechniques_h
#define MesoReliefTechniques_h

/**
 * @file MesoReliefTechniques.h
 * @brief Runs a test once for each technique of the relief mapper.
 *
 *     class ReliefCase : public testing::TestWithParam<MesoTechnique> { ... };
 *     TEST_P(ReliefCase, Aspect) { ... }
 *     MESO_FOR_RELIEF_TECHNIQUES(ReliefCase);
 *
 * or once for each technique and each base that it bends its relief over:
 *
 *     class ReliefCase : public testing::TestWithParam<MesoReliefArm> { ... };
 *     MESO_FOR_RELIEF_ARMS(ReliefCase);
 */

#include "MesoOptions.h"
#include "MesoTestScene.h"

#include "vtkMesoReliefMapper.h"

#include <gtest/gtest.h>

inline const char* MesoTechniqueTestName(MesoTechnique technique)
{
  return technique == MesoTechnique::ReliefQuadric ? "ReliefQuadric" : "Relief"; // no hyphens
}

/// What ctest shows of the parameter.
inline void PrintTo(MesoTechnique technique, std::ostream* os)
{
  *os << MesoName(technique);
}

/// A technique, and what it takes the base for.
struct MesoReliefArm
{
  MesoTechnique Technique;
  MesoCurvedKind Curved;

  std::string TestName() const
  {
    if (this->Technique == MesoTechnique::ReliefQuadricExact)
    {
      return "ReliefQuadricExact";
    }
    const std::string name = MesoTechniqueTestName(this->Technique);
    return this->Curved == MesoCurvedKind::Quadric ? name : name + "_" + MesoName(this->Curved);
  }
};

inline void PrintTo(const MesoReliefArm& arm, std::ostream* os)
{
  *os << MesoName(arm.Technique) << " " << MesoName(arm.Curved);
}

inline const MesoReliefArm MesoReliefArms[] = {
  { MesoTechnique::Relief, MesoCurvedKind::Quadric },
  { MesoTechnique::ReliefQuadric, MesoCurvedKind::Quadric },
  { MesoTechnique::ReliefQuadric, MesoCurvedKind::Osculating },
  { MesoTechnique::ReliefQuadric, MesoCurvedKind::Bent },
  { MesoTechnique::ReliefQuadric, MesoCurvedKind::Surface },
  { MesoTechnique::ReliefQuadricExact, MesoCurvedKind::Quadric },
};

#define MESO_FOR_RELIEF_ARMS(suite)                                                                \
  INSTANTIATE_TEST_SUITE_P(Arm, suite, testing::ValuesIn(MesoReliefArms),                          \
    [](const testing::TestParamInfo<MesoReliefArm>& info) { return info.param.TestName(); })

#define MESO_FOR_RELIEF_TECHNIQUES(suite)                                                          \
  INSTANTIATE_TEST_SUITE_P(Technique, suite,                                                       \
    testing::Values(MesoTechnique::Relief, MesoTechnique::ReliefQuadric),                          \
    [](const testing::TestParamInfo<MesoTechnique>& info)                                          \
    { return std::string(MesoTechniqueTestName(info.param)); })

/// Draws with a technique, on a mesh that gets what the technique needs.
inline void MesoUse(vtkMesoReliefMapper* mapper, MesoTechnique technique, vtkPolyData* mesh)
{
  MesoMesostructureOptions options = mapper->GetOptions();
  options.Technique = technique;
  mapper->SetOptions(options);
  mapper->SetInputData(MesoTestScene::Prepared(mesh, technique));
}

/// The same over one of the bases, with the image of the mesh that it may need.
inline void MesoUse(vtkMesoReliefMapper* mapper, const MesoReliefArm& arm, vtkPolyData* mesh)
{
  MesoMesostructureOptions options = mapper->GetOptions();
  options.Curved = arm.Curved;
  mapper->SetOptions(options);
  MesoUse(mapper, arm.Technique, mesh);
  mapper->SetBaseImage(MesoNeedsBaseImage(mapper->GetOptions())
      ? MesoTestScene::BaseImage(mapper->GetInput())
      : nullptr);
}

#endif
