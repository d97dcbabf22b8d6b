#include "vtk_glew.h" // must come first

#include "MesoGLDebugLog.h"

#include <algorithm> // for std::find
#include <utility>   // for std::move

namespace
{
constexpr std::size_t KeptMessages = 64;

void Receive(GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* text, const void* log)
{
  if (type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR)
  {
    std::string message = text;
    while (!message.empty() && message.back() == '\n')
    {
      message.pop_back();
    }
    const_cast<MesoGLDebugLog*>(static_cast<const MesoGLDebugLog*>(log))->Add(message);
  }
}
}

bool MesoGLDebugLog::Attach(Report report)
{
  this->Tell = std::move(report);
  this->Attached = GLEW_KHR_debug || GLEW_VERSION_4_3;
  if (this->Attached)
  {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS); // a debugger's stack then shows the call at fault
    glDebugMessageCallback(Receive, this);
  }
  return this->Attached;
}

void MesoGLDebugLog::Detach()
{
  if (this->Attached)
  {
    glDebugMessageCallback(nullptr, nullptr);
    this->Attached = false;
  }
}

void MesoGLDebugLog::Clear()
{
  this->Messages.clear();
  this->Count = 0;
}

void MesoGLDebugLog::Add(const std::string& message)
{
  ++this->Count;
  auto& kept = this->Messages;
  if (kept.size() < KeptMessages && std::find(kept.begin(), kept.end(), message) == kept.end())
  {
    kept.push_back(message);
    if (this->Tell)
    {
      this->Tell(message);
    }
  }
}
