// The main() of rendering tests must be able to fail: VTK's errors and warnings and OpenGL's errors
// are failures, unless a scope expects them; a scope that waits in vain is one too.

#include "vtk_glew.h" // must come first

#include "MesoExpectedMessages.h"

#include "vtkMesoEGLRenderWindow.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

namespace
{
void Warn(const char* text)
{
  vtkGenericWarningMacro(<< text);
}
}

TEST(ExpectedMessages, AnErrorFails)
{
  vtkNew<vtkRenderer> renderer;
  EXPECT_NONFATAL_FAILURE(vtkErrorWithObjectMacro(renderer, "no good"), "no good");
}

TEST(ExpectedMessages, AWarningFails)
{
  EXPECT_NONFATAL_FAILURE(Warn("take care"), "take care");
  vtkNew<vtkRenderer> renderer;
  EXPECT_NONFATAL_FAILURE(vtkWarningWithObjectMacro(renderer, "take care"), "take care");
}

TEST(ExpectedMessages, AnExpectedOneDoesNot)
{
  MesoExpectedMessages expected("take");
  Warn("take care");
  Warn("take two");
  EXPECT_EQ(expected.GetCount(), 2);
  EXPECT_NE(expected.GetMessages().front().find("take care"), std::string::npos);
}

TEST(ExpectedMessages, AnotherThanTheExpectedFails)
{
  MesoExpectedMessages expected("take");
  Warn("take care");
  EXPECT_NONFATAL_FAILURE(Warn("something else"), "something else");
  EXPECT_EQ(expected.GetCount(), 1);
}

TEST(ExpectedMessages, WaitingInVainFails)
{
  EXPECT_NONFATAL_FAILURE({ MesoExpectedMessages expected("never said"); }, "never said");
}

TEST(ExpectedMessages, AGLErrorFailsAndIsCounted)
{
  vtkNew<vtkMesoEGLRenderWindow> window;
  window->SetSize(16, 16);
  window->Render();
  if (!window->IsGLDebugActive())
  {
    GTEST_SKIP() << "no debug context (MESO_GL_DEBUG=0, or no KHR_debug)";
  }
  ASSERT_EQ(window->GetNumberOfGLErrors(), 0);
  EXPECT_NONFATAL_FAILURE(glEnable(0xFFFF), "OpenGL");
  EXPECT_EQ(window->GetNumberOfGLErrors(), 1);
  ASSERT_EQ(window->GetGLErrorMessages().size(), 1u);
  glEnable(0xFFFF);
  EXPECT_EQ(window->GetNumberOfGLErrors(), 2) << "counted again, though not reported again";
  EXPECT_EQ(window->GetGLErrorMessages().size(), 1u);
  window->ClearGLErrors();
  EXPECT_EQ(window->GetNumberOfGLErrors(), 0);
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM)) << "still there for whoever asks OpenGL";
}
