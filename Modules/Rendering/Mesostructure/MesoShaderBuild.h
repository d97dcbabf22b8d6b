#ifndef MesoShaderBuild_h
#define MesoShaderBuild_h

#include <string>
#include <vector>

class MesoShaderAssembler;
struct MesoShaderShape;

/**
 * @class MesoShaderBuild
 * @brief What decides the text of one of a mapper's shaders, and the splicing that follows from it.
 *
 * Chunks are those of Shaders/; Shaders/README.md lists which hook each goes to. Splice before VTK
 * consumes the hooks; AddLighting is for vtkOpenGLPolyDataMapper::ReplaceShaderLight.
 */
struct MesoShaderBuild
{
  bool Surface = false;       ///< the contract of Shaders/Common/Surface.glsl is in the shader
  bool Traces = false;        ///< the technique looks for a surface other than the base mesh
  bool WritesDepth = false;   ///< the depth buffer is that of the detail
  bool Caster = false;        ///< a shadow map is drawn: no lighting
  bool Diced = false;         ///< vertices are placed by the technique's vertex chunks
  bool Lit = false;           ///< VTK's normal and position are in the shader
  bool OwnLighting = false;   ///< Shaders/Common/Lighting.glsl in place of VTK's
  bool Textured = false;      ///< colour textures are read where the ray hit
  bool NormalMapped = false;  ///< a normal map is read where the ray hit
  bool HeightColored = false; ///< the colour is that of the height where the ray hit
  bool MatterColored = false; ///< or that of the volume there
  bool Contoured = false;     ///< contour lines of the height are drawn where the ray hit
  bool Clipped = false;       ///< clipping planes cut what the rays hit
  bool TakesShadows = false;  ///< other objects' shadows are looked up
  bool Numbers = false;       ///< every pixel's hit is written out as numbers
  bool Specular = false;      ///< the material has a highlight
  bool TextureMoved = false;  ///< the actor carries a texture transform
  bool Scalars = false;       ///< colours by a point array are those where the ray hit
  bool ScalarTexture = false; ///< VTK reads them in a texture of the lookup table
  int ContourHeights = 0;     ///< contour lines given one by one
  int LightComplexity = 0;    ///< VTK's: 0 none, 1 a headlight, 2 directional lights, 3 any
  int LightCount = 0;
  std::vector<std::string> Chunks;       ///< kernels and technique
  std::vector<std::string> VertexChunks; ///< kernels of the vertex stage
  std::string Definitions;               ///< `#define` lines; unequal ones ask for a new shader

  /// Take the technique's chunks, and make the definitions of it and of all the above.
  void Define(const MesoShaderShape& shape);

  /// Whether what is drawn where the ray hit needs to know the hit's step to the next pixel.
  bool UsesDifferential() const { return this->Contoured || this->Textured || this->NormalMapped; }

  void SpliceVertexShader(MesoShaderAssembler& vertex) const;
  void SpliceGeometryShader(MesoShaderAssembler& geometry) const;
  void SpliceFragmentShader(MesoShaderAssembler& fragment) const;

  /// Let the technique place the vertices: what VTK reads as attributes becomes variables that it sets. To
  /// be called when VTK has consumed its hooks.
  static void PlaceVertices(
    MesoShaderAssembler& vertex, MesoShaderAssembler& geometry, MesoShaderAssembler& fragment);

  /// Let VTK's shadow map passes store the depth of the detail instead of the triangle's.
  static void ShowDetailToVTKShadows(MesoShaderAssembler& fragment);

  /// Put the lighting in place of VTK's. `lightUniforms` declares VTK's uniforms of the lights.
  void AddLighting(MesoShaderAssembler& fragment, const std::string& lightUniforms) const;
};

#endif
