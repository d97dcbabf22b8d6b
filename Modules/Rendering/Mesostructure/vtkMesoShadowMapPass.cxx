#include "vtk_glew.h" // must come first

#include "vtkMesoShadowMapPass.h"

#include "MesoForeignShadows.h"
#include "MesoShaderAssembler.h"
#include "MesoShaderLibrary.h"
#include "MesoShadowTiles.h"
#include "vtkActor.h"
#include "vtkCameraPass.h"
#include "vtkDataSet.h"
#include "vtkDefaultPass.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkLightsPass.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkMesoPolyDataMapper.h"
#include "vtkMesoShadowCasterPass.h"
#include "vtkMesoShellMapper.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <set>

vtkStandardNewMacro(vtkMesoShadowMapPass);

namespace
{
constexpr float NothingMet = 1.e30f;
constexpr int LeastResolution = 16;

/// What a renderer without a pass draws.
vtkSmartPointer<vtkRenderPass> MakeDefaultPass()
{
  vtkNew<vtkRenderPassCollection> passes;
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkDefaultPass> props;
  passes->AddItem(lights);
  passes->AddItem(props);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  auto camera = vtkSmartPointer<vtkCameraPass>::New();
  camera->SetDelegatePass(sequence);
  return camera;
}

/// Whether an actor's shadow on itself is more than its technique looks for: a volume in a shell, whose matter is
/// searched for along the shell alone.
bool CastsOnItself(vtkActor* actor)
{
  return vtkMesoShellMapper::SafeDownCast(actor->GetMapper()) != nullptr;
}

/// Whether the mesh lies in a plane across one of its own axes.
bool IsFlat(vtkDataSet* mesh)
{
  double bounds[6];
  mesh->GetBounds(bounds);
  const double sizes[3] = { bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] };
  return *std::min_element(sizes, sizes + 3) <= 1e-9 * *std::max_element(sizes, sizes + 3);
}

int TilesAcross(std::size_t tiles)
{
  return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(tiles))));
}

/// A camera that sees what a tile holds, whatever the window's shape.
vtkSmartPointer<vtkOpenGLCamera> CameraOf(const MesoShadowTile& tile)
{
  auto camera = vtkSmartPointer<vtkOpenGLCamera>::New();
  camera->SetPosition(tile.Position.data());
  camera->SetFocalPoint(tile.Position[0] + tile.Direction[0], tile.Position[1] + tile.Direction[1],
    tile.Position[2] + tile.Direction[2]);
  camera->SetViewUp(tile.Up.data());
  camera->SetParallelProjection(!tile.Perspective);
  camera->SetClippingRange(tile.Near, tile.Far);
  const double width = tile.Right - tile.Left;
  const double height = tile.Top - tile.Bottom;
  const double depth = tile.Far - tile.Near;
  vtkNew<vtkMatrix4x4> projection;
  projection->Zero();
  projection->SetElement(0, 0, 2. / width);
  projection->SetElement(1, 1, 2. / height);
  const int centre = tile.Perspective ? 2 : 3; // the column that moves the middle
  const double sign = tile.Perspective ? 1. : -1.;
  projection->SetElement(0, centre, sign * (tile.Right + tile.Left) / width);
  projection->SetElement(1, centre, sign * (tile.Top + tile.Bottom) / height);
  if (tile.Perspective)
  {
    projection->SetElement(2, 2, -(tile.Far + tile.Near) / depth);
    projection->SetElement(2, 3, -2. * tile.Far * tile.Near / depth);
    projection->SetElement(3, 2, -1.);
  }
  else
  {
    projection->SetElement(2, 2, -2. / depth);
    projection->SetElement(2, 3, -(tile.Far + tile.Near) / depth);
    projection->SetElement(3, 3, 1.);
  }
  camera->SetExplicitProjectionTransformMatrix(projection);
  camera->SetUseExplicitProjectionTransformMatrix(true);
  return camera;
}
}

vtkMesoShadowMapPass::vtkMesoShadowMapPass()
  : DefaultPass(MakeDefaultPass())
{
}

vtkMesoShadowMapPass::~vtkMesoShadowMapPass() = default;

void vtkMesoShadowMapPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "NumberOfMaps: " << this->NumberOfMaps << "\n";
  os << indent << "NumberOfBakes: " << this->NumberOfBakes << "\n";
  os << indent << "DelegatePass: " << this->DelegatePass.Get() << "\n";
}

void vtkMesoShadowMapPass::SetDelegatePass(vtkRenderPass* pass)
{
  if (pass != this->DelegatePass)
  {
    this->DelegatePass = pass;
    this->Modified();
  }
}

void vtkMesoShadowMapPass::RenderThrough(vtkRenderer* renderer, vtkRenderPass* pass)
{
  const vtkSmartPointer<vtkRenderPass> before = renderer->GetPass();
  if (auto* shadows = vtkMesoShadowMapPass::SafeDownCast(before))
  {
    const vtkSmartPointer<vtkRenderPass> delegate = shadows->GetDelegatePass();
    shadows->SetDelegatePass(pass);
    renderer->GetRenderWindow()->Render();
    shadows->SetDelegatePass(delegate);
    return;
  }
  renderer->SetPass(pass);
  renderer->GetRenderWindow()->Render();
  renderer->SetPass(before);
}

std::size_t vtkMesoShadowMapPass::GetGPUBytes() const
{
  // Two floats and a depth of 4 bytes.
  vtkTextureObject* maps = this->Maps;
  return maps->GetHandle() ? std::size_t(12) * maps->GetWidth() * maps->GetHeight() : 0;
}

void vtkMesoShadowMapPass::FindCasters(vtkRenderer* renderer)
{
  this->Casters.clear();
  // All of the renderer's: what the camera does not see casts shadows as well.
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cursor;
  props->InitTraversal(cursor);
  while (vtkProp* prop = props->GetNextProp(cursor))
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    if (!actor || !actor->GetVisibility() || !actor->GetMapper() ||
      actor->HasTranslucentPolygonalGeometry())
    {
      continue;
    }
    auto* own = vtkMesoPolyDataMapper::SafeDownCast(actor->GetMapper());
    const double* bounds = actor->GetMapper()->GetInput() ? actor->GetBounds() : nullptr;
    if ((!own || own->CastsShadow()) && bounds && vtkMath::AreBoundsInitialized(bounds))
    {
      this->Casters.push_back(actor);
    }
  }
}

void vtkMesoShadowMapPass::PlaceTiles(vtkRenderer* renderer, int resolution)
{
  std::vector<MesoShadowCaster> casters;
  for (vtkActor* actor : this->Casters)
  {
    MesoShadowCaster caster;
    actor->GetBounds(caster.Bounds.data());
    caster.Flat = IsFlat(actor->GetMapper()->GetInput());
    casters.push_back(caster);
  }
  this->Lights.clear();
  this->Tiles.clear();
  vtkCollectionSimpleIterator cursor;
  renderer->GetLights()->InitTraversal(cursor);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(cursor))
  {
    if (!light->GetSwitch())
    {
      continue;
    }
    Views views;
    const auto tiles = MesoShadowTilesOf(light, casters, resolution);
    if (!tiles.empty())
    {
      views.First = static_cast<int>(this->Tiles.size());
      views.Count = static_cast<int>(tiles.size());
      views.Near = light->GetPositional();
      views.Part = std::min(light->GetShadowAttenuation(), 1.f);
      this->Tiles.insert(this->Tiles.end(), tiles.begin(), tiles.end());
    }
    this->Lights.push_back(views);
  }
}

std::vector<double> vtkMesoShadowMapPass::StateOfMaps(vtkRenderer* renderer) const
{
  std::vector<double> state = { double(this->TileSize) };
  const auto address = [](const void* pointer)
  { return static_cast<double>(reinterpret_cast<std::uintptr_t>(pointer)); };
  state.push_back(address(renderer->GetRenderWindow()));
  for (vtkActor* caster : this->Casters)
  {
    state.push_back(address(caster));
    state.push_back(static_cast<double>(caster->GetRedrawMTime()));
    if (auto* own = vtkMesoPolyDataMapper::SafeDownCast(caster->GetMapper()))
    {
      state.push_back(static_cast<double>(own->GetDetailMTime()));
    }
  }
  for (const MesoShadowTile& tile : this->Tiles)
  {
    for (const auto* vector : { &tile.Position, &tile.Direction, &tile.Up })
    {
      state.insert(state.end(), vector->begin(), vector->end());
    }
    state.insert(state.end(),
      { tile.Perspective ? 1. : 0., tile.Left, tile.Right, tile.Bottom, tile.Top, tile.Near,
        tile.Far });
  }
  return state;
}

bool vtkMesoShadowMapPass::Bake(vtkRenderer* renderer)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* glState = window->GetState();
  const int across = TilesAcross(this->Tiles.size());
  const int down = (static_cast<int>(this->Tiles.size()) + across - 1) / across;
  const int width = across * this->TileSize;
  const int height = down * this->TileSize;

  glState->PushFramebufferBindings();
  this->Framebuffer->SetContext(window);
  this->Framebuffer->Bind();
  this->Maps->SetContext(window);
  if (this->Maps->GetWidth() != static_cast<unsigned int>(width) ||
    this->Maps->GetHeight() != static_cast<unsigned int>(height) || !this->Maps->GetHandle())
  {
    this->Maps->Create2D(width, height, 2, VTK_FLOAT, false);
  }
  this->Framebuffer->AddColorAttachment(0, this->Maps);
  this->Framebuffer->ActivateDrawBuffer(0);
  this->Framebuffer->AddDepthAttachment();
  if (!this->Framebuffer->StartNonOrtho(width, height))
  {
    vtkErrorMacro("The device does not take a shadow map of " << width << " x " << height);
    glState->PopFramebufferBindings();
    return false;
  }
  vtkSmartPointer<vtkCamera> camera = renderer->GetActiveCamera();
  {
    vtkOpenGLState::ScopedglViewport viewport(glState);
    vtkOpenGLState::ScopedglScissor scissor(glState);
    vtkOpenGLState::ScopedglEnableDisable scissorTest(glState, GL_SCISSOR_TEST);
    vtkOpenGLState::ScopedglEnableDisable depthTest(glState, GL_DEPTH_TEST);
    vtkOpenGLState::ScopedglEnableDisable blend(glState, GL_BLEND);
    vtkOpenGLState::ScopedglEnableDisable multisample(glState, GL_MULTISAMPLE);
    glState->vtkglEnable(GL_DEPTH_TEST);
    glState->vtkglDepthMask(GL_TRUE);
    glState->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glState->vtkglDisable(GL_BLEND);
    glState->vtkglDisable(GL_MULTISAMPLE);
    glState->vtkglDisable(GL_SCISSOR_TEST);
    const float nothing[4] = { NothingMet, 0.f, 0.f, 0.f };
    const float farthest = 1.f;
    glClearBufferfv(GL_COLOR, 0, nothing);
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    glState->vtkglEnable(GL_SCISSOR_TEST);

    this->CasterPass->Numbers.clear();
    std::vector<vtkProp*> props;
    for (vtkActor* caster : this->Casters)
    {
      props.push_back(caster);
      this->CasterPass->Numbers[caster] = static_cast<int>(props.size());
    }
    vtkRenderState inner(renderer);
    inner.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
    inner.SetFrameBuffer(this->Framebuffer);
    for (std::size_t i = 0; i < this->Tiles.size(); ++i)
    {
      const int x = static_cast<int>(i) % across * this->TileSize;
      const int y = static_cast<int>(i) / across * this->TileSize;
      glState->vtkglViewport(x, y, this->TileSize, this->TileSize);
      glState->vtkglScissor(x, y, this->TileSize, this->TileSize);
      renderer->SetActiveCamera(this->Cameras[i]);
      this->CasterPass->Range[0] = this->Tiles[i].Near;
      this->CasterPass->Range[1] = this->Tiles[i].Far;
      this->CasterPass->Render(&inner);
    }
  }
  renderer->SetActiveCamera(camera);
  glState->PopFramebufferBindings();
  ++this->NumberOfBakes;
  return true;
}

void vtkMesoShadowMapPass::UpdateUniforms(vtkRenderer* renderer)
{
  this->ViewUniform.clear();
  this->FrameUniform.clear();
  this->TileUniform.clear();
  vtkNew<vtkMatrix4x4> viewToWorld;
  viewToWorld->DeepCopy(renderer->GetActiveCamera()->GetModelViewTransformMatrix());
  viewToWorld->Invert();
  const int across = TilesAcross(this->Tiles.size());
  for (std::size_t i = 0; i < this->Tiles.size(); ++i)
  {
    const MesoShadowTile& tile = this->Tiles[i];
    vtkNew<vtkMatrix4x4> view;
    vtkMatrix4x4::Multiply4x4(this->Cameras[i]->GetModelViewTransformMatrix(), viewToWorld, view);
    for (int column = 0; column < 4; ++column)
    {
      for (int row = 0; row < 4; ++row)
      {
        this->ViewUniform.push_back(static_cast<float>(view->GetElement(row, column)));
      }
    }
    const double size = this->TileSize;
    const double first[2] = { static_cast<int>(i) % across * size,
      static_cast<int>(i) / across * size };
    const double perUnit[2] = { size / (tile.Right - tile.Left), size / (tile.Top - tile.Bottom) };
    for (const double value : { perUnit[0], perUnit[1], first[0] - perUnit[0] * tile.Left,
           first[1] - perUnit[1] * tile.Bottom })
    {
      this->FrameUniform.push_back(static_cast<float>(value));
    }
    for (const double value : { first[0], first[1], size, size })
    {
      this->TileUniform.push_back(static_cast<float>(value));
    }
  }
  const std::string definitions = MesoShaderAssembler::DefineLines(
    { { "MESO_SHADOW_LIGHTS", std::to_string(this->Lights.size()) },
      { "MESO_SHADOW_TILES", std::to_string(this->Tiles.size()) } });
  if (definitions != this->Definitions)
  {
    this->Definitions = definitions;
    this->ShaderTime.Modified();
  }
}

void vtkMesoShadowMapPass::Render(const vtkRenderState* state)
{
  vtkOpenGLClearErrorMacro();
  vtkRenderer* renderer = state->GetRenderer();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkRenderPass* delegate = this->DelegatePass ? this->DelegatePass : this->DefaultPass;

  this->NumberOfMaps = 0;
  this->FindCasters(renderer);
  if (this->Casters.size() > 1 ||
    std::any_of(this->Casters.begin(), this->Casters.end(), &CastsOnItself))
  {
    this->PlaceTiles(renderer, this->Resolution);
    this->TileSize = this->Resolution;
    const int limit = vtkTextureObject::GetMaximumTextureSize(window);
    while (
      TilesAcross(this->Tiles.size()) * this->TileSize > limit && this->TileSize > LeastResolution)
    {
      this->TileSize /= 2;
    }
    this->Cameras.clear();
    for (const MesoShadowTile& tile : this->Tiles)
    {
      this->Cameras.push_back(CameraOf(tile));
    }
    if (!this->Tiles.empty() &&
      (this->StateOfMaps(renderer) == this->Baked || this->Bake(renderer)))
    {
      // Drawing may have touched what it has drawn: the state is that after it.
      this->Baked = this->StateOfMaps(renderer);
      this->NumberOfMaps = static_cast<int>(this->Tiles.size());
    }
  }
  if (this->NumberOfMaps > 0)
  {
    this->UpdateUniforms(renderer);
    this->Maps->Activate();
    this->PreRender(state);
    delegate->Render(state);
    this->PostRender(state);
    this->Maps->Deactivate();
  }
  else
  {
    delegate->Render(state);
  }
  this->NumberOfRenderedProps = delegate->GetNumberOfRenderedProps();
  vtkOpenGLCheckErrorMacro("failed after rendering with shadows");
}

void vtkMesoShadowMapPass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->DelegatePass)
  {
    this->DelegatePass->ReleaseGraphicsResources(window);
  }
  this->DefaultPass->ReleaseGraphicsResources(window);
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->Maps->ReleaseGraphicsResources(window);
  this->Baked.clear();
}

bool vtkMesoShadowMapPass::Takes(vtkAbstractMapper* mapper) const
{
  auto* own = vtkMesoPolyDataMapper::SafeDownCast(mapper);
  return own ? own->CastsShadow() : vtkOpenGLPolyDataMapper::SafeDownCast(mapper) != nullptr;
}

bool vtkMesoShadowMapPass::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  if (!this->Takes(mapper))
  {
    return true;
  }
  MesoShaderAssembler fragment("fragment shader", fragmentShader);
  const bool done = fragment.Before("//VTK::CustomUniforms::Dec", "Common/ShadowMapDec.glsl",
    this->Definitions + MesoShaderText("Common/ShadowMapDec.glsl"));
  fragmentShader = fragment.GetText();
  return done;
}

bool vtkMesoShadowMapPass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  // Shaders/Common/Lighting.glsl asks for the shadows itself.
  if (this->Takes(mapper) && fragmentShader.find("#define MESO_LIGHTING\n") == std::string::npos)
  {
    fragmentShader =
      MesoShadeForeignLighting(fragmentShader, static_cast<int>(this->Lights.size()));
  }
  return true;
}

bool vtkMesoShadowMapPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  if (!program->IsUniformUsed("mesoShadowMaps"))
  {
    return true;
  }
  std::vector<int> first;
  std::vector<int> sides;
  std::vector<int> near;
  std::vector<float> part;
  for (const Views& views : this->Lights)
  {
    first.push_back(views.First);
    sides.push_back(views.Count);
    near.push_back(views.Near ? 1 : 0);
    part.push_back(views.Part);
  }
  const int lights = static_cast<int>(this->Lights.size());
  const int tiles = static_cast<int>(this->Tiles.size());
  program->SetUniformi("mesoShadowMaps", this->Maps->GetTextureUnit());
  program->SetUniform1iv("mesoShadowFirst", lights, first.data());
  program->SetUniform1iv("mesoShadowSides", lights, sides.data());
  program->SetUniform1iv("mesoShadowNear", lights, near.data());
  program->SetUniform1fv("mesoShadowPart", lights, part.data());
  program->SetUniformMatrix4x4v("mesoShadowView", tiles, this->ViewUniform.data());
  program->SetUniform4fv("mesoShadowFrame", tiles, this->FrameUniform.data());
  program->SetUniform4fv("mesoShadowTile", tiles, this->TileUniform.data());
  if (program->IsUniformUsed("mesoCaster"))
  {
    const auto found = this->CasterPass->Numbers.find(prop);
    program->SetUniformf(
      "mesoCaster", found == this->CasterPass->Numbers.end() ? 0.f : float(found->second));
  }
  return true;
}
