#ifndef MessageOf_h
#define MessageOf_h

#include "MesoScene.h" // for MesoInputError

#include <cstring>
#include <string>

/// What `call` says is wrong, or "read without an error".
template <typename Call>
std::string MessageOf(const Call& call)
{
  try
  {
    call();
  }
  catch (const MesoInputError& error)
  {
    return error.what();
  }
  return "read without an error";
}

/// The bytes of a number, in the machine's order or turned.
template <typename T>
std::string BytesOf(T number, bool isTurned = false)
{
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &number, sizeof(T));
  return isTurned ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

#endif
