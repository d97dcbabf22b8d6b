// The assembler on plain text: what it splices, and that it fails loudly where VTK would do nothing.

#include "MesoShaderAssembler.h"
#include "MesoShaderLibrary.h"

#include <gtest/gtest.h>

namespace
{
const char* const Template = "void main()\n{\n  //VTK::Light::Impl\n  //VTK::Depth::Impl\n}\n";
}

TEST(ShaderAssembler, SplicesBeforeAfterAndInPlace)
{
  MesoShaderAssembler text("fragment shader", Template);
  EXPECT_TRUE(text.Before("//VTK::Light::Impl", "a", "  int a;\n"));
  EXPECT_TRUE(text.After("//VTK::Light::Impl", "b", "  int b;"));
  EXPECT_TRUE(text.Replace("//VTK::Depth::Impl", "c", "  int c;\n"));
  EXPECT_EQ(text.GetText(),
    "void main()\n{\n  // begin a\n  int a;\n// end a\n//VTK::Light::Impl\n// begin b\n  int b;\n"
    "// end b\n\n\n  // begin c\n  int c;\n// end c\n\n}\n");
  EXPECT_TRUE(text.GetErrors().empty());
}

TEST(ShaderAssembler, RefusesAMissingHook)
{
  MesoShaderAssembler text("fragment shader", Template);
  EXPECT_FALSE(text.Before("//VTK::Normal::Impl", "Common/NormalImpl.glsl", "int a;\n"));
  ASSERT_EQ(text.GetErrors().size(), 1u);
  EXPECT_EQ(text.GetErrors()[0],
    "fragment shader: hook //VTK::Normal::Impl for chunk Common/NormalImpl.glsl stands there 0 "
    "times instead of once");
  EXPECT_EQ(text.GetText(), Template);
}

TEST(ShaderAssembler, RefusesAHookThatStandsTwice)
{
  MesoShaderAssembler text("vertex shader", std::string(Template) + Template);
  EXPECT_FALSE(text.Replace("//VTK::Light::Impl", "a", "int a;\n"));
  ASSERT_EQ(text.GetErrors().size(), 1u);
  EXPECT_NE(text.GetErrors()[0].find("2 times"), std::string::npos);
}

TEST(ShaderAssembler, RefusesChunksThatVTKWouldMisread)
{
  for (const char* chunk : { "int a;\n//VTK::Light::Impl\n", "// like gl_FragData[1]\n",
         "float \xc3\xa4;\n", "int a;\r\n" })
  {
    MesoShaderAssembler text("fragment shader", Template);
    EXPECT_FALSE(text.Before("//VTK::Light::Impl", "bad", chunk)) << chunk;
    EXPECT_EQ(text.GetErrors().size(), 1u) << chunk;
    EXPECT_EQ(text.GetText(), Template);
  }
  MesoShaderAssembler text("fragment shader", Template);
  EXPECT_TRUE(text.Before("//VTK::Light::Impl", "good", "gl_FragData[1] = vec4(0.0);\n"));
}

TEST(ShaderAssembler, RenamesAKnownNumberOfPlaces)
{
  MesoShaderAssembler text("fragment shader", "a b a");
  EXPECT_FALSE(text.Rename("a", "c", 1));
  EXPECT_EQ(text.GetText(), "a b a");
  EXPECT_TRUE(text.Rename("a", "aa", 2));
  EXPECT_EQ(text.GetText(), "aa b aa");
  EXPECT_EQ(text.GetErrors().size(), 1u);
}

TEST(ShaderAssembler, WritesDefines)
{
  EXPECT_EQ(
    MesoShaderAssembler::DefineLines({ { "A", "" }, { "B", "2" } }), "#define A\n#define B 2\n");
}

TEST(ShaderLibrary, HoldsTheTextsOfTheFolder)
{
  EXPECT_GT(MesoShaderNames().size(), 20u);
  for (const std::string& name : MesoShaderNames())
  {
    EXPECT_FALSE(MesoShaderText(name).empty()) << name;
  }
  EXPECT_NE(MesoShaderText("Techniques/Plain.glsl").find("traceSurface"), std::string::npos);
  EXPECT_TRUE(MesoShaderText("Techniques/NoSuch.glsl").empty());
}
