#include "MesoMessage.h"

#include <charconv>

std::string MesoPrintable(const std::string& text)
{
  constexpr std::size_t longest = 160;
  std::string result = text.substr(0, longest);
  for (char& character : result)
  {
    if (static_cast<unsigned char>(character) < 0x20 || character == 0x7f)
    {
      character = ' ';
    }
  }
  return text.size() > longest ? result + "..." : result;
}

std::string MesoNumberText(double value)
{
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value).ptr;
  return std::string(buffer, end);
}
