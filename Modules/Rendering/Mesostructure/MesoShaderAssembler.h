#ifndef MesoShaderAssembler_h
#define MesoShaderAssembler_h

#include "mesoRenderingMesostructureModule.h" // for export macro

#include <string>
#include <utility>
#include <vector>

/**
 * @class MesoShaderAssembler
 * @brief Splices named chunks of GLSL into a shader template at its hooks. Plain text, no GL.
 *
 * A hook is a marker such as `//VTK::Normal::Impl`. VTK's own substitution does nothing, in
 * silence, where a marker is missing; this one demands that each hook stands in the text exactly
 * once and remembers every failure with the hook's name and the count found.
 *
 * Splice before vtkOpenGLPolyDataMapper::ReplaceShaderValues consumes the hooks: there each of them
 * still stands exactly once.
 *
 * Each chunk is marked in the text by a line before and after it. A chunk that contains hook text,
 * a carriage return, a character outside ASCII, or gl_FragData in a comment (VTK counts that as the
 * real thing) is refused.
 */
class MESORENDERINGMESOSTRUCTURE_EXPORT MesoShaderAssembler
{
public:
  /// `stage` names the text in messages ("fragment shader").
  MesoShaderAssembler(std::string stage, std::string text);

  ///@{
  /// Put a chunk before or after a hook's line, and keep the hook. Returns false, and remembers
  /// why, when that cannot be done; the text is then unchanged.
  bool Before(const std::string& hook, const std::string& chunkName, const std::string& chunk);
  bool After(const std::string& hook, const std::string& chunkName, const std::string& chunk);
  ///@}

  /// Put a chunk in place of a hook.
  bool Replace(const std::string& hook, const std::string& chunkName, const std::string& chunk);

  /// Put `to` for every `from`; there must be exactly `count` of them.
  bool Rename(const std::string& from, const std::string& to, int count);

  /// How often a string stands in the text.
  int Count(const std::string& hook) const;

  const std::string& GetText() const { return this->Text; }
  /// One line for each thing that went wrong; empty when all went well.
  const std::vector<std::string>& GetErrors() const { return this->Errors; }

  /// `#define` lines, sorted as given. An empty value defines the name alone.
  static std::string DefineLines(const std::vector<std::pair<std::string, std::string>>& defines);

private:
  bool Splice(const std::string& hook, const std::string& chunkName, const std::string& chunk,
    bool before, bool keep);
  bool Refuse(const std::string& reason);
  bool CheckChunk(const std::string& chunkName, const std::string& chunk);

  std::string Stage;
  std::string Text;
  std::vector<std::string> Errors;
};

#endif
