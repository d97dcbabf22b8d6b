#include "vtk_glew.h" // must come first

#include "vtkMesoAOVPass.h"

#include "MesoShaderAssembler.h"
#include "MesoShaderLibrary.h"
#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkLightsPass.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <limits>

vtkStandardNewMacro(vtkMesoAOVPass);

namespace
{
// Targets 1 to 3 as Shaders/Common/AOVImpl.glsl writes them; target 0 is the picture.
const std::vector<std::vector<const char*>> FixedTargets = {
  { "normal.x", "normal.y", "normal.z", "coverage" },
  { "depth", "texcoord.u", "texcoord.v", "relief" },
  { "object", "fetches", "texel_reads", "iterations" },
};
constexpr int FirstShadowTarget = 4;

const char* const PublishedOrder[] = { "coverage", "depth", "texcoord.u", "texcoord.v", "relief",
  "normal.x", "normal.y", "normal.z", "object", "fetches", "texel_reads", "iterations" };
}

vtkMesoAOVPass::vtkMesoAOVPass()
{
  vtkNew<vtkRenderPassCollection> passes;
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  passes->AddItem(lights);
  passes->AddItem(opaque);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  this->CameraPass->SetDelegatePass(sequence);
}

vtkMesoAOVPass::~vtkMesoAOVPass() = default;

void vtkMesoAOVPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << "\n";
  os << indent << "LightCount: " << this->LightCount << "\n";
}

void vtkMesoAOVPass::SetObjectNumber(vtkProp* prop, int number)
{
  int& held = this->ObjectNumbers[prop];
  if (held != number)
  {
    held = number;
    this->Modified();
  }
}

std::vector<std::string> vtkMesoAOVPass::GetChannelNames() const
{
  std::vector<std::string> names(std::begin(PublishedOrder), std::end(PublishedOrder));
  for (int i = 0; i < this->LightCount; ++i)
  {
    names.push_back("shadow." + std::to_string(i));
  }
  return names;
}

std::pair<int, int> vtkMesoAOVPass::Locate(const std::string& channel) const
{
  for (std::size_t target = 0; target < FixedTargets.size(); ++target)
  {
    for (int component = 0; component < 4; ++component)
    {
      if (channel == FixedTargets[target][component])
      {
        return { static_cast<int>(target), component };
      }
    }
  }
  for (int i = 0; i < this->LightCount; ++i)
  {
    if (channel == "shadow." + std::to_string(i))
    {
      return { FirstShadowTarget - 1 + i / 4, i % 4 };
    }
  }
  return { -1, 0 };
}

float vtkMesoAOVPass::GetValue(const std::string& channel, int column, int row) const
{
  return this->ValueAt(this->Locate(channel), column, row);
}

float vtkMesoAOVPass::ValueAt(const std::pair<int, int>& place, int column, int row) const
{
  if (place.first < 0 || place.first >= static_cast<int>(this->Targets.size()) || column < 0 ||
    row < 0 || column >= this->Size[0] || row >= this->Size[1])
  {
    return std::numeric_limits<float>::quiet_NaN();
  }
  const std::size_t pixel =
    static_cast<std::size_t>(this->Size[1] - 1 - row) * this->Size[0] + column;
  return this->Targets[place.first][4 * pixel + place.second];
}

std::vector<float> vtkMesoAOVPass::GetChannel(const std::string& channel) const
{
  return this->Locate(channel).first < 0 ? std::vector<float>() : this->GetInterleaved({ channel });
}

std::vector<float> vtkMesoAOVPass::GetInterleaved(const std::vector<std::string>& channels) const
{
  std::vector<std::pair<int, int>> places;
  places.reserve(channels.size());
  for (const std::string& channel : channels)
  {
    places.push_back(this->Locate(channel));
  }
  std::vector<float> values;
  values.reserve(channels.size() * this->Size[0] * this->Size[1]);
  for (int row = 0; row < this->Size[1]; ++row)
  {
    for (int column = 0; column < this->Size[0]; ++column)
    {
      for (const auto& place : places)
      {
        values.push_back(this->ValueAt(place, column, row));
      }
    }
  }
  return values;
}

void vtkMesoAOVPass::Render(const vtkRenderState* state)
{
  vtkOpenGLClearErrorMacro();
  this->NumberOfRenderedProps = 0;
  vtkRenderer* renderer = state->GetRenderer();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* glState = window->GetState();

  int lights = 0;
  vtkCollectionSimpleIterator cursor;
  renderer->GetLights()->InitTraversal(cursor);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(cursor))
  {
    lights += light->GetSwitch() ? 1 : 0;
  }
  this->Targets.clear();
  this->Size[0] = this->Size[1] = 0;
  if (lights > MostLights)
  {
    vtkErrorMacro(
      "AOVs hold the shadows of at most " << MostLights << " lights; the scene has " << lights);
    return;
  }
  if (lights != this->LightCount)
  {
    this->LightCount = lights;
    this->Modified(); // another number of targets, another shader
  }
  const unsigned int targetCount = FirstShadowTarget + (lights + 3) / 4;
  state->GetWindowSize(this->Size);

  if (this->Textures.size() > targetCount)
  {
    this->Framebuffer->ReleaseGraphicsResources(window); // its attachments are too many
    this->Textures.resize(targetCount);
  }
  while (this->Textures.size() < targetCount)
  {
    this->Textures.push_back(vtkSmartPointer<vtkTextureObject>::New());
  }
  this->Framebuffer->SetContext(window);
  glState->PushFramebufferBindings();
  this->Framebuffer->Bind();
  for (unsigned int i = 0; i < targetCount; ++i)
  {
    vtkTextureObject* texture = this->Textures[i];
    texture->SetContext(window);
    if (texture->GetWidth() != static_cast<unsigned int>(this->Size[0]) ||
      texture->GetHeight() != static_cast<unsigned int>(this->Size[1]))
    {
      texture->Create2D(this->Size[0], this->Size[1], 4, VTK_FLOAT, false);
    }
    this->Framebuffer->AddColorAttachment(i, texture);
  }
  this->Framebuffer->ActivateDrawBuffers(targetCount);
  this->Framebuffer->AddDepthAttachment();
  if (!this->Framebuffer->StartNonOrtho(this->Size[0], this->Size[1]))
  {
    vtkErrorMacro("The device does not take " << targetCount << " float targets");
    this->Size[0] = this->Size[1] = 0;
    glState->PopFramebufferBindings();
    return;
  }

  vtkCamera* camera = renderer->GetActiveCamera();
  this->ViewToWorld->DeepCopy(camera->GetModelViewTransformMatrix());
  this->ViewToWorld->Invert();
  vtkMatrix4x4* projection =
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1);
  this->DepthOfZ[0] = static_cast<float>(projection->GetElement(2, 2));
  this->DepthOfZ[1] = static_cast<float>(projection->GetElement(2, 3));
  this->DepthOfZ[2] = static_cast<float>(projection->GetElement(3, 2));
  this->DepthOfZ[3] = static_cast<float>(projection->GetElement(3, 3));

  double background[3];
  renderer->GetBackground(background);
  const double backgroundAlpha = renderer->GetBackgroundAlpha();
  const bool gradient = renderer->GetGradientBackground();
  const bool textured = renderer->GetTexturedBackground();
  renderer->SetBackground(0.0, 0.0, 0.0);
  renderer->SetBackgroundAlpha(0.0);
  renderer->SetGradientBackground(false);
  renderer->SetTexturedBackground(false);
  // Whatever the renderer and its layer keep of earlier frames, the targets begin empty.
  const bool erase = renderer->GetErase();
  const bool preserveColor = renderer->GetPreserveColorBuffer();
  const bool preserveDepth = renderer->GetPreserveDepthBuffer();
  const bool eraseWindow = window->GetErase();
  renderer->SetErase(true);
  renderer->SetPreserveColorBuffer(false);
  renderer->SetPreserveDepthBuffer(false);
  window->SetErase(true);
  {
    vtkOpenGLState::ScopedglEnableDisable depthTest(glState, GL_DEPTH_TEST);
    vtkOpenGLState::ScopedglEnableDisable blend(glState, GL_BLEND);
    vtkOpenGLState::ScopedglEnableDisable multisample(glState, GL_MULTISAMPLE);
    glState->vtkglEnable(GL_DEPTH_TEST);
    glState->vtkglDisable(GL_BLEND);
    glState->vtkglDisable(GL_MULTISAMPLE);

    vtkRenderState inner(renderer);
    inner.SetPropArrayAndCount(state->GetPropArray(), state->GetPropArrayCount());
    inner.SetFrameBuffer(this->Framebuffer);
    this->PreRender(state);
    this->CameraPass->Render(&inner);
    this->PostRender(state);
    this->NumberOfRenderedProps = this->CameraPass->GetNumberOfRenderedProps();
  }
  renderer->SetBackground(background);
  renderer->SetBackgroundAlpha(backgroundAlpha);
  renderer->SetGradientBackground(gradient);
  renderer->SetTexturedBackground(textured);
  renderer->SetErase(erase);
  renderer->SetPreserveColorBuffer(preserveColor);
  renderer->SetPreserveDepthBuffer(preserveDepth);
  window->SetErase(eraseWindow);

  this->ReadBack();
  glState->PopFramebufferBindings();
  vtkOpenGLCheckErrorMacro("failed after rendering AOVs");
}

void vtkMesoAOVPass::ReadBack()
{
  const int targetCount = FirstShadowTarget + (this->LightCount + 3) / 4;
  this->Framebuffer->Bind(GL_READ_FRAMEBUFFER);
  for (int i = 1; i < targetCount; ++i)
  {
    std::vector<float> pixels(std::size_t(4) * this->Size[0] * this->Size[1]);
    this->Framebuffer->ActivateReadBuffer(static_cast<unsigned int>(i));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    for (const GLenum zero : { GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS })
    {
      glPixelStorei(zero, 0);
    }
    // Rows of four floats have any alignment that is set. To set one behind the back of VTK, which
    // remembers its own, would make VTK's next reading of a picture run over the end of its memory.
    glReadPixels(0, 0, this->Size[0], this->Size[1], GL_RGBA, GL_FLOAT, pixels.data());
    this->Targets.push_back(std::move(pixels));
  }
}

void vtkMesoAOVPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->CameraPass->ReleaseGraphicsResources(window);
  this->Framebuffer->ReleaseGraphicsResources(window);
  for (auto& texture : this->Textures)
  {
    texture->ReleaseGraphicsResources(window);
  }
  this->Textures.clear();
}

bool vtkMesoAOVPass::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  MesoShaderAssembler fragment("fragment shader", fragmentShader);
  const bool done = fragment.Before(
    "//VTK::CustomUniforms::Dec", "Common/AOVDec.glsl", MesoShaderText("Common/AOVDec.glsl"));
  fragmentShader = fragment.GetText();
  return done;
}

bool vtkMesoAOVPass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  MesoShaderAssembler fragment("fragment shader", fragmentShader);
  const bool done = fragment.Before(
    "//VTK::DepthPeeling::Impl", "Common/AOVImpl.glsl", MesoShaderText("Common/AOVImpl.glsl"));
  fragmentShader = fragment.GetText();
  return done;
}

bool vtkMesoAOVPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  if (program->IsUniformUsed("mesoViewToWorld"))
  {
    vtkNew<vtkMatrix3x3> rotation; // transposed, as shader programs take matrices
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        rotation->SetElement(i, j, this->ViewToWorld->GetElement(j, i));
      }
    }
    program->SetUniformMatrix("mesoViewToWorld", rotation);
  }
  if (program->IsUniformUsed("mesoDepthOfZ"))
  {
    program->SetUniform4f("mesoDepthOfZ", this->DepthOfZ);
  }
  if (program->IsUniformUsed("mesoObject"))
  {
    const auto found = this->ObjectNumbers.find(prop);
    program->SetUniformf(
      "mesoObject", found == this->ObjectNumbers.end() ? 0.f : static_cast<float>(found->second));
  }
  return true;
}
