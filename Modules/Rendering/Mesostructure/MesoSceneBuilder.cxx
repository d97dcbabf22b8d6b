#include "MesoSceneBuilder.h"

#include "MesoAlgorithmRun.h"
#include "MesoBumpMaps.h"
#include "MesoHeightMap.h"
#include "MesoMapInput.h"
#include "MesoPolarity.h"
#include "MesoScalarBar.h"
#include "MesoSceneArrays.h"
#include "MesoSceneLights.h"
#include "MesoSceneMapper.h"
#include "MesoShellScene.h"
#include "MesoSurfaceColors.h"
#include "MesoVDMInput.h"
#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkMesoImageReader.h"
#include "vtkMesoLoopSubdivision.h"
#include "vtkMesoMeshReader.h"
#include "vtkMesoPolyDataMapper.h"
#include "vtkMesoShadowMapPass.h"
#include "vtkMesoShapeSource.h"
#include "vtkMesoShellMapper.h"
#include "vtkMesoSurfaceFrames.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkReverseSense.h"
#include "vtkScalarBarActor.h"
#include "vtkTexture.h"

#include <algorithm>

namespace
{
void SetMaterial(const MesoSceneMaterial& material, vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  property->SetInterpolationToPhong();
  property->SetColor(material.Color[0], material.Color[1], material.Color[2]);
  property->SetAmbient(material.Ambient);
  property->SetDiffuse(material.Diffuse);
  property->SetSpecular(material.Specular);
  property->SetSpecularPower(material.SpecularPower);
  property->SetOpacity(material.Opacity);
  property->SetBackfaceCulling(!material.TwoSided);
  property->SetEdgeVisibility(material.Edges);
}

/// The colour alone: an alpha channel would make VTK draw the actor as translucent.
vtkSmartPointer<vtkImageData> WithoutAlpha(vtkImageData* image)
{
  vtkDataArray* values = image->GetPointData()->GetScalars();
  const int components = values->GetNumberOfComponents();
  if (components != 2 && components != 4)
  {
    return image;
  }
  auto colour = vtkSmartPointer<vtkDataArray>::Take(values->NewInstance());
  colour->SetNumberOfComponents(components - 1);
  colour->SetNumberOfTuples(values->GetNumberOfTuples());
  for (int component = 0; component < components - 1; ++component)
  {
    colour->CopyComponent(component, values, component);
  }
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->SetExtent(image->GetExtent());
  result->GetPointData()->SetScalars(colour);
  return result;
}

void SetColorMap(const std::string& fileName, const MesoMesostructureOptions& options,
  const std::string& place, vtkActor* actor, std::vector<std::string>& warnings)
{
  vtkNew<vtkMesoImageReader> reader;
  reader->SetFileName(fileName.c_str());
  MesoRunAlgorithm(reader, place, warnings);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(WithoutAlpha(reader->GetOutput()));
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOn();
  texture->MipmapOn();
  // VTK's default of 4 is for hardware: llvmpipe takes eight times as long, and chooses levels by how far
  // the hits of neighbouring pixels lie apart, whatever steps the shader gives, so that pixels stray.
  texture->SetMaximumAnisotropicFiltering(1.f);
  texture->SetWrap(options.Wrap == MesoWrap::Clamp ? vtkTexture::ClampToEdge
      : options.Wrap == MesoWrap::Mirror           ? vtkTexture::MirroredRepeat
                                                   : vtkTexture::Repeat);
  actor->SetTexture(texture);
  if (options.Tiles != std::array<double, 2>{ 1., 1. })
  {
    vtkNew<vtkMatrix4x4> tiles;
    tiles->SetElement(0, 0, options.Tiles[0]);
    tiles->SetElement(1, 1, options.Tiles[1]);
    vtkNew<vtkInformation> keys;
    keys->Set(vtkProp::GeneralTextureTransform(), &(tiles->Element[0][0]), 16);
    actor->SetPropertyKeys(keys);
  }
}

/// A mirror turns the triangles' winding, by which front and back are told.
vtkSmartPointer<vtkPolyData> Turned(vtkPolyData* mesh)
{
  vtkNew<vtkReverseSense> turn;
  turn->SetInputData(mesh);
  turn->ReverseCellsOn();
  turn->ReverseNormalsOff();
  turn->Update();
  return turn->GetOutput();
}

/// Warns where a normal map says that the heights beside it are upside down.
void CheckPolarity(const MesoSceneMap& map, vtkImageData* heights, const MesoNormals& normals,
  const std::string& inScene, std::vector<std::string>& warnings)
{
  if (normals.Meaning.Space != MesoNormalSpace::Tangent)
  {
    return;
  }
  const MesoPolarity polarity = MesoComparePolarity(heights, normals.Image);
  if (polarity.Says(!normals.Meaning.Down) == MesoPolarity::Reading::Depth)
  {
    warnings.push_back(inScene + ".mesostructure: the material's normal map says that this is a " +
      (map.IsDepth ? "height_map, not a depth_map" : "depth_map, not a height_map"));
  }
}

std::array<double, 16> Multiply(
  const std::array<double, 16>& left, const std::array<double, 16>& right)
{
  std::array<double, 16> product;
  vtkMatrix4x4::Multiply4x4(left.data(), right.data(), product.data());
  return product;
}
}

void MesoSceneBuilder::SetShadows(
  const std::vector<MesoSceneLight>& lights, vtkRenderer* renderer) const
{
  const bool anyLight = std::any_of(lights.begin(), lights.end(),
    [](const MesoSceneLight& light)
    { return light.Shadow && light.Type != MesoSceneLight::Kind::Headlight; });
  const bool several = this->Objects.size() > 1;
  const bool volumes = std::any_of(this->Objects.begin(), this->Objects.end(),
    [](const Object& object)
    {
      auto* shell = vtkMesoShellMapper::SafeDownCast(object.Mapper);
      return shell && shell->CastsShadow();
    });
  vtkSmartPointer<vtkMesoShadowMapPass> shadows;
  if (anyLight && (several || volumes))
  {
    shadows = vtkSmartPointer<vtkMesoShadowMapPass>::New();
    if (!several)
    {
      // A lone volume's map is of itself alone, and of what is far off there: half the texels will do.
      shadows->SetResolution(shadows->GetResolution() / 2);
    }
  }
  renderer->SetPass(shadows);
}

MesoHeights MesoSceneBuilder::MakeHeights(const MesoSceneMap& map, const std::string& place)
{
  const MesoStoredMap stored = MesoReadMap(map, place, this->Warnings);
  try
  {
    MesoHeights heights = MesoToHeights(stored.Image, map.IsDepth, stored.Range);
    for (const std::string& warning : heights.Warnings)
    {
      this->Warnings.push_back(place + ": " + warning);
    }
    return heights;
  }
  catch (const MesoInputError& problem)
  {
    throw MesoInputError(
      place + ": " + (map.File.empty() ? map.Pattern : map.File) + ": " + problem.what());
  }
}

vtkSmartPointer<vtkPolyData> MesoSceneBuilder::MakeMesh(
  const MesoSceneNode& node, const std::string& place, vtkImageData* heights, bool needsFrames)
{
  const MesoSceneMesh& mesh = *node.Mesh;
  if (mesh.File.empty())
  {
    vtkNew<vtkMesoShapeSource> source;
    source->SetShape(mesh.Shape.c_str());
    for (const auto& parameter : mesh.Parameters)
    {
      source->SetParameter(parameter.first, parameter.second);
    }
    const auto spacing = node.Map ? MesoSampleSpacing(*node.Map, heights) : std::nullopt;
    if (mesh.Shape == "plane" && !mesh.Parameters.count("size") && spacing)
    {
      int samples[3];
      heights->GetDimensions(samples);
      source->SetParameter("size",
        { (*spacing)[0] * samples[0] * node.Mesostructure.Tiles[0],
          (*spacing)[1] * samples[1] * node.Mesostructure.Tiles[1] });
    }
    if (mesh.FeatureAngle)
    {
      this->Warnings.push_back(
        place + ": feature_angle is for mesh files; a built-in shape has normals of its own");
    }
    MesoRunAlgorithm(source, place, this->Warnings);
    return source->GetOutput();
  }
  vtkNew<vtkMesoMeshReader> reader;
  reader->SetFileName(mesh.File.c_str());
  MesoRunAlgorithm(reader, place, this->Warnings);
  vtkSmartPointer<vtkPolyDataAlgorithm> source = reader;
  if (mesh.Subdivide > 0)
  {
    vtkNew<vtkMesoLoopSubdivision> smooth;
    smooth->SetInputConnection(reader->GetOutputPort());
    smooth->SetLevels(mesh.Subdivide);
    MesoRunAlgorithm(smooth, place, this->Warnings);
    source = smooth;
  }
  if (!source->GetOutput()->GetPointData()->GetTCoords() && !needsFrames)
  {
    // No frame without texture coordinates; the points are not split, so VTK's normals serve.
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputConnection(source->GetOutputPort());
    normals->ConsistencyOff();
    normals->SetSplitting(mesh.FeatureAngle.has_value());
    normals->SetFeatureAngle(mesh.FeatureAngle.value_or(30.));
    const bool given = source->GetOutput()->GetPointData()->GetNormals() != nullptr;
    MesoRunAlgorithm(given ? static_cast<vtkAlgorithm*>(source) : normals, place, this->Warnings);
    return given ? source->GetOutput() : normals->GetOutput();
  }
  vtkNew<vtkMesoSurfaceFrames> frames;
  frames->SetInputConnection(source->GetOutputPort());
  if (mesh.FeatureAngle)
  {
    frames->SplitNormalsOn();
    frames->SetFeatureAngle(*mesh.FeatureAngle);
  }
  MesoRunAlgorithm(frames, place, this->Warnings);
  return frames->GetOutput();
}

void MesoSceneBuilder::AddScalars(const MesoSceneMaterial& material, const Object& object,
  const std::string& inScene, vtkRenderer* renderer)
{
  object.Mapper->ScalarVisibilityOff();
  if (material.ColorBy && object.Options.Technique == MesoTechnique::GeometryImage)
  {
    throw MesoInputError(inScene +
      ".color_by: technique geometry-image draws positions and normals, "
      "and has no numbers to color by");
  }
  if (material.ColorBy)
  {
    MesoSetSurfaceColors(*material.ColorBy, object.Mesh, object.Mapper);
  }
  if (material.Contours)
  {
    const MesoContourLines lines =
      MesoContoursOfScene(*material.Contours, object.Mapper->GetMapNumbers());
    if (!lines.Problem().empty())
    {
      throw MesoInputError(inScene + ".contours: " + lines.Problem());
    }
    object.Mapper->SetContourLines(lines);
  }
  if (material.ScalarBar)
  {
    renderer->AddActor2D(MesoMakeScalarBar(
      *material.ScalarBar, *material.ColorBy, object.Mapper, this->BarCount++, renderer));
  }
}

MesoNormals MesoSceneBuilder::ReadNormals(
  const MesoSceneNode& node, Object& object, const std::string& inScene)
{
  MesoNormals normals;
  if (!node.Material.NormalMap.empty() &&
    MesoEffectsOn(node.Mesostructure).Has(MesoEffect::Shading))
  {
    const std::string inMaterial = inScene + ".material.normal_map";
    if (node.Mesostructure.Technique == MesoTechnique::Tessellated)
    {
      throw MesoInputError(
        inMaterial + ": technique tessellated shows the normals of the diced mesh, and no others");
    }
    normals = MesoReadNormalMap(node.Material, inMaterial, this->Warnings);
    object.NormalMap = normals.Image;
    object.NormalMeaning = normals.Meaning;
    if (node.Map)
    {
      CheckPolarity(*node.Map, object.HeightMap, normals, inScene, this->Warnings);
    }
  }
  return normals;
}

void MesoSceneBuilder::AddNode(const MesoScene& scene, const MesoSceneNode& node,
  const std::string& place, const std::array<double, 16>& parentMatrix, vtkRenderer* renderer)
{
  const std::array<double, 16> matrix = Multiply(parentMatrix, node.Matrix);
  ++this->NodeCount;
  if (node.Mesh)
  {
    Object object;
    object.Number = this->NodeCount;
    object.Name = node.Name;
    object.Options = node.Mesostructure;
    const std::string inScene = scene.File + ": " + place;
    MesoHeights heights;
    if (node.Map)
    {
      heights = this->MakeHeights(*node.Map, inScene + ".mesostructure");
      object.HeightMap = heights.Image;
    }
    else if (MesoUsesHeightMap(node.Mesostructure.Technique) && !node.Baked.empty())
    {
      // The technique itself, or the reference, which draws what the table was baked from.
      object.HeightMap = MesoReadVDMHeights(node.Baked, inScene + ".mesostructure.baked");
    }
    if (MesoUsesVolume(node.Mesostructure.Technique))
    {
      MesoCheckShellMaterial(node.Material, inScene);
      const MesoShellVolume read =
        MesoReadShellVolume(node, object.HeightMap, inScene + ".mesostructure", this->Warnings);
      object.Volume = read.Volume;
      object.VolumeTable = read.Table;
    }
    object.Base = this->MakeMesh(node, inScene + ".mesh", object.HeightMap,
      node.Mesostructure.Technique != MesoTechnique::Plain ||
        (node.Material.ColorBy && MesoArrayNeedsFrames(node.Material.ColorBy->Array)) ||
        (node.Part && MesoArrayNeedsFrames(node.Part->By)));
    MesoCheckSampleSpacing(
      node, object.HeightMap, object.Base, inScene + ".mesostructure", this->Warnings);
    if (node.Material.ColorBy && !node.Material.ColorBy->IsHeight())
    {
      object.Base = MesoWithArray(object.Base, node.Material.ColorBy->Array,
        node.Material.ColorBy->Component, inScene + ".material.color_by", this->Warnings);
    }
    if (node.Part)
    {
      object.Base = MesoPartOfMesh(object.Base, *node.Part, inScene + ".part", this->Warnings);
    }
    vtkNew<vtkMatrix4x4> userMatrix;
    userMatrix->DeepCopy(matrix.data());
    if (userMatrix->Determinant() < 0.)
    {
      object.Base = Turned(object.Base);
    }
    object.Mesh = object.Base;
    const MesoTechnique technique = node.Mesostructure.Technique;
    const MesoNormals normals = this->ReadNormals(node, object, inScene);
    if (MesoUsesHeightMap(technique) && object.HeightMap && node.Mesostructure.Scale == 0.)
    {
      this->Warnings.push_back(inScene + ".mesostructure: scale is 0, so the relief is flat");
    }
    MesoMakeSceneMapper(node, object, normals, inScene, this->Warnings);
    if (normals.Image)
    {
      object.Mapper->SetNormalMap(normals.Image, normals.Meaning);
    }
    object.Mapper->SetMapNumbers(heights.Numbers[0], heights.Numbers[1]);
    for (const MesoSceneClippingPlane& clip : scene.ClippingPlanes)
    {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(clip.Point.data());
      plane->SetNormal(clip.Normal.data());
      object.Mapper->AddClippingPlane(plane);
    }
    this->AddScalars(node.Material, object, inScene + ".material", renderer);

    object.Actor = vtkSmartPointer<vtkActor>::New();
    object.Actor->SetMapper(object.Mapper);
    SetMaterial(node.Material, object.Actor);
    if (!node.Material.ColorMap.empty())
    {
      SetColorMap(node.Material.ColorMap, node.Mesostructure, inScene + ".material.color_map",
        object.Actor, this->Warnings);
    }
    object.Actor->SetUserMatrix(userMatrix);
    renderer->AddActor(object.Actor);
    this->Objects.push_back(object);
  }
  for (std::size_t i = 0; i < node.Children.size(); ++i)
  {
    this->AddNode(
      scene, node.Children[i], place + ".children[" + std::to_string(i) + "]", matrix, renderer);
  }
}

void MesoSceneBuilder::Build(const MesoScene& scene, vtkRenderer* renderer)
{
  this->Objects.clear();
  this->Warnings.clear();
  this->NodeCount = 0;
  this->BarCount = 0;
  renderer->SetBackground(scene.Background[0], scene.Background[1], scene.Background[2]);
  renderer->AutomaticLightCreationOff();
  renderer->RemoveAllLights();
  for (const MesoSceneLight& light : scene.Lights)
  {
    MesoAddSceneLight(light, scene.Camera, renderer);
  }
  const std::array<double, 16> identity = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  for (std::size_t i = 0; i < scene.Nodes.size(); ++i)
  {
    this->AddNode(scene, scene.Nodes[i], "nodes[" + std::to_string(i) + "]", identity, renderer);
  }
  MesoSetSceneCamera(scene.Camera, renderer);
  this->SetShadows(scene.Lights, renderer);
}
