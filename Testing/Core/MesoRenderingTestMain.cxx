/**
 * @file MesoRenderingTestMain.cxx
 * @brief main() of every rendering test: GoogleTest with windows that need no display.
 *
 * A GL error, a VTK error or a VTK warning that the test does not expect fails it. Multisampling is
 * off unless a test asks for it.
 */

#include "MesoExpectedMessages.h"

#include "vtkMesoEGLRenderWindow.h"
#include "vtkOpenGLRenderWindow.h"

#include <cstdlib> // for setenv
#include <gtest/gtest.h>

int main(int argc, char* argv[])
{
  testing::InitGoogleTest(&argc, argv);
  setenv("MESO_GL_DEBUG", "1", 0); // a GL error then is a VTK error; 0 stays what the caller wants
  MesoFailOnMessages();
  vtkMesoEGLRenderWindow::InstallOverride(false);
  vtkOpenGLRenderWindow::SetGlobalMaximumNumberOfMultiSamples(0);
  return RUN_ALL_TESTS();
}
