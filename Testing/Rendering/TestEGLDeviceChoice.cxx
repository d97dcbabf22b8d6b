// Which device is drawn with: what MESO_EGL_DEVICE does, what is said where nothing works, and that
// hardware that does not work is passed over. Hardware itself is played by made-up candidates.

#include "EGLTestScene.h"
#include "MesoEGLChoice.h"
#include "MesoExpectedMessages.h"

#include "vtkFloatArray.h"

#include <cstdlib>
#include <gtest/gtest.h>

namespace
{
/// What a window says that has no device; fails where it says nothing, or draws.
std::string WhatIsSaidInVain()
{
  EGLTestScene scene;
  vtkNew<vtkMesoEGLRenderWindow> window;
  scene.ShowIn(window, 20, 20);
  MesoExpectedMessages expected("EGL");
  window->Render();
  window->Render(); // says it once
  EXPECT_EQ(expected.GetCount(), 1);
  EXPECT_EQ(window->SupportsOpenGL(), 0);
  EXPECT_EQ(window->GetGLRenderer(), "");
  EXPECT_EQ(CentrePixel(window)[0], -1) << "pixels of nothing";
  vtkNew<vtkFloatArray> depth;
  EXPECT_EQ(window->GetZbufferData(0, 0, 3, 3, depth), VTK_ERROR);
  window->ReleaseGraphicsResources(window);
  window->Finalize();
  return expected.GetCount() == 0 ? "" : expected.GetMessages().front();
}

class EGLDeviceChoice : public testing::Test
{
protected:
  void SetUp() override { unsetenv("MESO_EGL_DEVICE"); }

  /// The first candidate of this machine that works (and draws on the CPU); no display if none.
  static MesoEGLCandidate Working(bool onCPU = false)
  {
    for (const MesoEGLCandidate& candidate : MesoEGLCandidates())
    {
      MesoEGLContext context;
      std::string reason;
      if (context.Create(candidate, false, reason) &&
        (!onCPU || MesoIsSoftwareRenderer(context.GetRenderer())))
      {
        return candidate;
      }
    }
    return {};
  }

  static MesoEGLCandidate Named(MesoEGLCandidate candidate, const char* name, bool hardware)
  {
    candidate.Name = name;
    candidate.Hardware = hardware;
    return candidate;
  }

  const MesoEGLCandidate Dead = { EGL_NO_DISPLAY, "dead card (hardware)", true };
  MesoEGLContext Context;
  std::string Text;
};
}

TEST(EGLExtensions, AreMatchedAsWords)
{
  const char* list = "EGL_EXT_device_drm_render_node EGL_MESA_device_software";
  EXPECT_TRUE(MesoEGLHasExtension(list, "EGL_MESA_device_software"));
  EXPECT_TRUE(MesoEGLHasExtension(list, "EGL_EXT_device_drm_render_node"));
  EXPECT_FALSE(MesoEGLHasExtension(list, "EGL_EXT_device_drm"));
  EXPECT_FALSE(MesoEGLHasExtension(list, "device_software"));
  EXPECT_TRUE(MesoEGLHasExtension("a_b a", "a"));
  EXPECT_FALSE(MesoEGLHasExtension("", "a"));
  EXPECT_FALSE(MesoEGLHasExtension(nullptr, "a"));
}

TEST_F(EGLDeviceChoice, DescribesTheCandidateThatItTook)
{
  const auto names = vtkMesoEGLRenderWindow::GetDeviceCandidates();
  ASSERT_FALSE(names.empty());
  vtkNew<vtkMesoEGLRenderWindow> window;
  EXPECT_EQ(window->GetNumberOfDevices(), static_cast<int>(names.size()));
  ASSERT_EQ(window->SupportsOpenGL(), 1);
  const std::string text = window->GetDeviceDescription();
  const std::size_t index = std::stoul(text);
  ASSERT_LT(index, names.size());
  EXPECT_EQ(text.find(std::to_string(index) + ": " + names[index]), 0u) << text;
}

TEST_F(EGLDeviceChoice, HardwareIsListedFirst)
{
  bool hardware = true;
  for (const MesoEGLCandidate& candidate : MesoEGLCandidates())
  {
    EXPECT_TRUE(hardware || !candidate.Hardware) << candidate.Name;
    hardware = candidate.Hardware;
  }
}

TEST_F(EGLDeviceChoice, EachIndexGivesThatDeviceOrSaysWhyNot)
{
  const auto candidates = MesoEGLCandidates();
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    const std::string index = std::to_string(i);
    MesoEGLContext context;
    const bool works = MesoChooseEGLContext(context, candidates, index.c_str(), false, this->Text);
    EXPECT_NE(this->Text.find(index + ": " + candidates[i].Name), std::string::npos) << this->Text;
    EXPECT_EQ(works, context.Exists());
  }
}

TEST_F(EGLDeviceChoice, AWrongIndexGivesTheList)
{
  for (const char* value : { "99", "-1", "one", "0x", "1 2", "99999999999999999999" })
  {
    setenv("MESO_EGL_DEVICE", value, 1);
    const std::string text = WhatIsSaidInVain();
    EXPECT_NE(text.find(std::string("\"") + value + "\""), std::string::npos) << text;
    int index = 0;
    for (const std::string& name : vtkMesoEGLRenderWindow::GetDeviceCandidates())
    {
      const std::string line = "\n  " + std::to_string(index++) + ": " + name;
      EXPECT_NE(text.find(line), std::string::npos) << text;
    }
  }
}

TEST_F(EGLDeviceChoice, WorksOnceTheIndexIsRight)
{
  EGLTestScene scene;
  vtkNew<vtkMesoEGLRenderWindow> window;
  scene.ShowIn(window, 20, 20);
  setenv("MESO_EGL_DEVICE", "99", 1);
  {
    MesoExpectedMessages expected("MESO_EGL_DEVICE");
    window->Render();
  }
  setenv("MESO_EGL_DEVICE", "", 1);
  window->Finalize();
  window->Render();
  EXPECT_EQ(CentrePixel(window), BallColor);
}

TEST_F(EGLDeviceChoice, SaysSoWhereEGLListsNothing)
{
  // Read by libglvnd at the first call of EGL in the process, which this is.
  setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent.json", 1);
  const std::string text = WhatIsSaidInVain();
  EXPECT_NE(text.find("No EGL device"), std::string::npos) << text;
  EXPECT_NE(text.find("EGL lists no device"), std::string::npos) << text;
}

TEST_F(EGLDeviceChoice, PassesOverDeadHardwareAndSaysSo)
{
  const auto working = Named(Working(), "working", false);
  ASSERT_NE(working.Display, EGL_NO_DISPLAY);
  ASSERT_TRUE(
    MesoChooseEGLContext(this->Context, { this->Dead, working }, nullptr, false, this->Text));
  EXPECT_EQ(
    this->Text, "1: working; passed over 0: dead card (hardware): EGL gives no display for it");
  EXPECT_TRUE(this->Context.IsCurrent());
}

TEST_F(EGLDeviceChoice, DoesNotPassOverTheOneAskedFor)
{
  const auto working = Named(Working(), "working", false);
  EXPECT_FALSE(
    MesoChooseEGLContext(this->Context, { this->Dead, working }, "0", false, this->Text));
  EXPECT_NE(
    this->Text.find("0: dead card (hardware): EGL gives no display for it"), std::string::npos)
    << this->Text;
  EXPECT_NE(this->Text.find("1: working"), std::string::npos) << this->Text;
  EXPECT_FALSE(this->Context.Exists());
}

TEST_F(EGLDeviceChoice, PrefersAnythingToHardwareInDisguise)
{
  const auto disguised = Named(Working(true), "card without driver", true);
  if (disguised.Display == EGL_NO_DISPLAY)
  {
    GTEST_SKIP() << "nothing here draws on the CPU";
  }
  const auto working = Named(Working(), "working", false);
  ASSERT_TRUE(
    MesoChooseEGLContext(this->Context, { disguised, working }, nullptr, false, this->Text));
  EXPECT_EQ(this->Text.find("1: working; passed over 0: card without driver: draws on the CPU"), 0u)
    << this->Text;
}

TEST_F(EGLDeviceChoice, TakesHardwareInDisguiseBeforeNothing)
{
  const auto disguised = Named(Working(true), "card without driver", true);
  if (disguised.Display == EGL_NO_DISPLAY)
  {
    GTEST_SKIP() << "nothing here draws on the CPU";
  }
  ASSERT_TRUE(
    MesoChooseEGLContext(this->Context, { this->Dead, disguised }, nullptr, false, this->Text));
  EXPECT_EQ(this->Text.find("1: card without driver; passed over 0: dead card"), 0u) << this->Text;
  EXPECT_TRUE(this->Context.IsCurrent());
}

TEST_F(EGLDeviceChoice, SharesADisplayUntilTheLastLetsGo)
{
  const auto working = Working();
  auto first = std::make_unique<MesoEGLContext>();
  std::string reason;
  ASSERT_TRUE(first->Create(working, false, reason)) << reason;
  ASSERT_TRUE(this->Context.Create(working, false, reason)) << reason;
  first.reset();
  EXPECT_NE(eglQueryString(working.Display, EGL_VENDOR), nullptr) << "terminated too early";
  EXPECT_TRUE(this->Context.MakeCurrent());
  this->Context.Destroy();
  EXPECT_EQ(eglQueryString(working.Display, EGL_VENDOR), nullptr) << "not terminated";
  EXPECT_EQ(MesoEGLErrorName(), "EGL_NOT_INITIALIZED");
}
