#ifndef MesoVertexAttributes_h
#define MesoVertexAttributes_h

#include <map>
#include <string>
#include <vector>

class vtkOpenGLPolyDataMapper;
class vtkPolyData;
struct MesoShaderShape;

/**
 * @class MesoVertexAttributes
 * @brief The point arrays of a mapper's input as attributes of its vertex shader.
 *
 * Texture coordinates and normals are `mesoTCoord` and `mesoNormal`; the others are those that the
 * shape names. Only what changes is mapped anew, since that builds the vertex buffers again.
 */
class MesoVertexAttributes
{
public:
  /// What the input lacks of that which a technique of this shape needs, in words; empty where
  /// nothing. Attributes are mapped by the arrays' names, so each array needs one.
  static std::string Missing(vtkPolyData* input, const MesoShaderShape& shape);

  /// Map the arrays of the input that the shape reads.
  void Map(vtkOpenGLPolyDataMapper* mapper, vtkPolyData* input, const MesoShaderShape& shape);
  /// Map none.
  void Clear(vtkOpenGLPolyDataMapper* mapper);

  /// The names of the attributes that are mapped.
  std::vector<std::string> Names() const;

private:
  std::map<std::string, std::string> Mapped; ///< attribute to array
};

#endif
