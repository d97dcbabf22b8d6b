#ifndef MesoTechniqueShader_h
#define MesoTechniqueShader_h

#include "MesoOptions.h"                      // for MesoEffects
#include "mesoRenderingMesostructureModule.h" // for export macro

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

/// What a shader is built of. Equal shapes give equal text, so an unequal one asks for a build.
struct MESORENDERINGMESOSTRUCTURE_EXPORT MesoShaderShape
{
  std::vector<std::string> Chunks; ///< names in Shaders/, kernels first, the technique last
  std::vector<std::pair<std::string, std::string>> Defines;
  std::vector<std::string> VertexChunks; ///< the same for the vertex stage
  /// Vertex attributes beside normals and texture coordinates, and the point arrays that hold them.
  std::vector<std::pair<std::string, std::string>> Attributes;
  bool Traces = false;        ///< the technique looks for a surface other than the base mesh
  bool UsesFrame = false;     ///< it needs the tangent frame of the vertices
  bool WritesDepth = false;   ///< the depth buffer is that of the detail
  bool NormalMapped = false;  ///< a normal map is read where the ray hit
  bool MeshCasts = false;     ///< into shadow maps the mesh itself is drawn, whatever else is seen
  bool Displaced = false;     ///< the mesh itself is the detail, with its depth in MesoRelief
  bool Prisms = false;        ///< the mesh is a shell of prisms, their numbers in MesoPrism
  bool MatterColored = false; ///< colours are the volume's own where the ray hit
  bool Diced = false;         ///< vertices are placed by the vertex stage, not read from the mesh

  /// Asks for the tangent frame of the vertices, and the arrays that hold it.
  void UseFrame();

  /// Defines MESO_SHADING, MESO_OCCLUSION, ... of the effects that are on.
  void DefineEffects(const MesoEffects& effects);

  bool operator==(const MesoShaderShape& other) const
  {
    return this->Chunks == other.Chunks && this->VertexChunks == other.VertexChunks &&
      this->Attributes == other.Attributes && this->Defines == other.Defines &&
      this->Traces == other.Traces && this->UsesFrame == other.UsesFrame &&
      this->WritesDepth == other.WritesDepth && this->NormalMapped == other.NormalMapped &&
      this->MeshCasts == other.MeshCasts && this->Displaced == other.Displaced &&
      this->Prisms == other.Prisms && this->MatterColored == other.MatterColored &&
      this->Diced == other.Diced;
  }
};

/**
 * @class MesoTechniqueShader
 * @brief What a mapper asks its technique: which shader, which textures and uniforms.
 *
 * The base class is the technique `plain`: the base mesh and nothing else.
 */
class MESORENDERINGMESOSTRUCTURE_EXPORT MesoTechniqueShader
{
public:
  MesoTechniqueShader() = default;
  virtual ~MesoTechniqueShader() = default;
  MesoTechniqueShader(const MesoTechniqueShader&) = delete;
  void operator=(const MesoTechniqueShader&) = delete;

  virtual MesoShaderShape GetShape() const;

  /// Make the textures ready and bind them. Returns why that failed, or an empty text.
  virtual std::string Activate(vtkOpenGLRenderWindow* window);
  virtual void SetUniforms(vtkShaderProgram* program);
  /// The point of the model that the uniform mesoBaseCentreVC stands for, or null.
  virtual const double* GetCentre() const;
  virtual void Deactivate();
  virtual void ReleaseGraphicsResources(vtkWindow* window);
  /// Bytes of textures held on the GPU.
  virtual std::size_t GetGPUBytes() const;
};

#endif
