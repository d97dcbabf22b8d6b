#ifndef MesoReliefTechniques_h
#define MesoReliefTechniques_h

/**
 * @file MesoReliefTechniques.h
 * @brief Runs a test once for each technique of the relief mapper.
 *
 *     class ReliefCase : public testing::TestWithParam<MesoTechnique> { ... };
 *     TEST_P(ReliefCase, Aspect) { ... }
 *     MESO_FOR_RELIEF_TECHNIQUES(ReliefCase);
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

#endif
