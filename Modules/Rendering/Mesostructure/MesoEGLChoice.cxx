#include "MesoEGLChoice.h"

#include <cstdlib> // for std::strtoul

namespace
{
using Reasons = std::vector<std::string>;

std::string Label(const std::vector<MesoEGLCandidate>& candidates, std::size_t i)
{
  return std::to_string(i) + ": " + candidates[i].Name;
}

std::string List(const std::vector<MesoEGLCandidate>& candidates, const Reasons& reasons)
{
  std::string text;
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    text += "\n  " + Label(candidates, i);
    text += reasons[i].empty() ? "" : ": " + reasons[i];
  }
  return candidates.empty() ? "\n  (EGL lists no device and no surfaceless platform)" : text;
}

bool TakeWanted(MesoEGLContext& context, const std::vector<MesoEGLCandidate>& candidates,
  const char* wanted, bool debug, std::string& text)
{
  char* end = nullptr;
  const std::size_t index = std::strtoul(wanted, &end, 10);
  Reasons reasons(candidates.size());
  if (*wanted < '0' || *wanted > '9' || *end != '\0' || index >= candidates.size())
  {
    text = std::string("MESO_EGL_DEVICE is \"") + wanted +
      "\", which is no index of this list:" + List(candidates, reasons);
    return false;
  }
  if (!context.Create(candidates[index], debug, reasons[index]))
  {
    text = std::string("The EGL device that MESO_EGL_DEVICE=") + wanted +
      " names cannot be drawn with:" + List(candidates, reasons);
    return false;
  }
  text = Label(candidates, index);
  return true;
}

/// What was taken, and the hardware that was not, with its reasons.
std::string Describe(
  const std::vector<MesoEGLCandidate>& candidates, std::size_t taken, const Reasons& reasons)
{
  std::string text = Label(candidates, taken);
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    if (i != taken && candidates[i].Hardware && !reasons[i].empty())
    {
      text += "; passed over " + Label(candidates, i) + ": " + reasons[i];
    }
  }
  return text;
}
}

bool MesoChooseEGLContext(MesoEGLContext& context, const std::vector<MesoEGLCandidate>& candidates,
  const char* wanted, bool debug, std::string& text)
{
  if (wanted && *wanted)
  {
    return TakeWanted(context, candidates, wanted, debug, text);
  }
  Reasons reasons(candidates.size());
  const std::size_t none = candidates.size();
  std::size_t disguised = none;
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    if (!context.Create(candidates[i], debug, reasons[i]))
    {
      continue;
    }
    const std::string renderer = context.GetRenderer();
    if (!candidates[i].Hardware || !MesoIsSoftwareRenderer(renderer))
    {
      text = Describe(candidates, i, reasons);
      return true;
    }
    context.Destroy();
    reasons[i] = "draws on the CPU (" + renderer + ")";
    disguised = disguised == none ? i : disguised;
  }
  std::string reason;
  if (disguised != none && context.Create(candidates[disguised], debug, reason))
  {
    text = Describe(candidates, disguised, reasons);
    return true;
  }
  text = "No EGL device gives an OpenGL 3.2 core context:" + List(candidates, reasons);
  return false;
}
