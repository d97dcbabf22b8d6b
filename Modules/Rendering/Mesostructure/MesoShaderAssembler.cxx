#include "MesoShaderAssembler.h"

#include <sstream>

MesoShaderAssembler::MesoShaderAssembler(std::string stage, std::string text)
  : Stage(std::move(stage))
  , Text(std::move(text))
{
}

bool MesoShaderAssembler::Refuse(const std::string& reason)
{
  this->Errors.push_back(this->Stage + ": " + reason);
  return false;
}

int MesoShaderAssembler::Count(const std::string& hook) const
{
  int count = 0;
  for (std::size_t at = this->Text.find(hook); at != std::string::npos;
       at = this->Text.find(hook, at + hook.size()))
  {
    ++count;
  }
  return count;
}

bool MesoShaderAssembler::CheckChunk(const std::string& chunkName, const std::string& chunk)
{
  std::istringstream lines(chunk);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number)
  {
    const std::string place = "chunk " + chunkName + " line " + std::to_string(number);
    for (const char c : line)
    {
      if ((c < ' ' && c != '\t') || c > '~')
      {
        return this->Refuse(place + " has a character that is not printable ASCII");
      }
    }
    if (line.find("//VTK::") != std::string::npos)
    {
      return this->Refuse(place + " contains a VTK hook");
    }
    const std::size_t comment = line.find("//");
    if (comment != std::string::npos && line.find("gl_FragData[", comment) != std::string::npos)
    {
      return this->Refuse(place + " names an output in a comment, which VTK takes for code");
    }
  }
  return true;
}

bool MesoShaderAssembler::Splice(const std::string& hook, const std::string& chunkName,
  const std::string& chunk, bool before, bool keep)
{
  if (!this->CheckChunk(chunkName, chunk))
  {
    return false;
  }
  const int count = this->Count(hook);
  if (count != 1)
  {
    return this->Refuse("hook " + hook + " for chunk " + chunkName + " stands there " +
      std::to_string(count) + " times instead of once");
  }
  std::string block = "// begin " + chunkName + "\n" + chunk;
  if (block.back() != '\n')
  {
    block += '\n';
  }
  block += "// end " + chunkName + "\n";
  const std::string kept = keep ? hook + "\n" : std::string();
  const std::string spliced = before ? block + kept : kept + block;
  this->Text.replace(this->Text.find(hook), hook.size(), spliced);
  return true;
}

bool MesoShaderAssembler::Before(
  const std::string& hook, const std::string& chunkName, const std::string& chunk)
{
  return this->Splice(hook, chunkName, chunk, true, true);
}

bool MesoShaderAssembler::After(
  const std::string& hook, const std::string& chunkName, const std::string& chunk)
{
  return this->Splice(hook, chunkName, chunk, false, true);
}

bool MesoShaderAssembler::Replace(
  const std::string& hook, const std::string& chunkName, const std::string& chunk)
{
  return this->Splice(hook, chunkName, chunk, true, false);
}

bool MesoShaderAssembler::Rename(const std::string& from, const std::string& to, int count)
{
  const int found = this->Count(from);
  if (found != count)
  {
    return this->Refuse("'" + from + "' stands there " + std::to_string(found) +
      " times instead of " + std::to_string(count));
  }
  for (std::size_t at = this->Text.find(from); at != std::string::npos;
       at = this->Text.find(from, at + to.size()))
  {
    this->Text.replace(at, from.size(), to);
  }
  return true;
}

std::string MesoShaderAssembler::DefineLines(
  const std::vector<std::pair<std::string, std::string>>& defines)
{
  std::string lines;
  for (const auto& define : defines)
  {
    lines += "#define " + define.first;
    lines += define.second.empty() ? "\n" : " " + define.second + "\n";
  }
  return lines;
}
