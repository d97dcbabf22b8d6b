#ifndef MesoBakeParts_h
#define MesoBakeParts_h

#include "MesoBakedFile.h"             // for MesoBakedParameter
#include "mesoIOMesostructureModule.h" // for export macro

#include <chrono>
#include <cstddef>
#include <map>
#include <string>

/**
 * @class MesoBakeParts
 * @brief What a long bake has finished so far, so that one that was stopped goes on from there.
 *
 * Parts are numbered arrays of floats. They lie in a folder of their own in that of the cache
 * (MesoBakeCache.h), named by all that they depend on, a file each: its numbers and a checksum, written
 * whole or not at all. A file that is damaged or of another size is as good as none. The folder may be
 * removed at any time, and is when the bake is done; without a cache nothing is kept.
 *
 * Keeping costs about as long as a quick bake does, so it begins only once a bake takes long.
 */
class MESOIOMESOSTRUCTURE_EXPORT MesoBakeParts
{
public:
  /**
   * @param kind, parameters as of MesoBakeOnce
   * @param patience seconds from now on for which nothing is kept
   */
  MesoBakeParts(const std::string& kind,
    const std::map<std::string, MesoBakedParameter>& parameters, double patience);

  /// Reads a part; false where none of so many numbers was kept.
  bool Take(int part, float* numbers, std::size_t count);

  /// Keeps a part. Where that fails nothing more is kept, and GetProblem() says why.
  void Keep(int part, const float* numbers, std::size_t count);

  /// Removes what was kept.
  void Remove();

  /// How many parts were read.
  int GetTaken() const { return this->Taken; }

  /// Why a part could not be kept; empty where none was refused.
  const std::string& GetProblem() const { return this->Problem; }

private:
  std::string FileOf(int part) const;

  std::string Folder; ///< empty: none
  std::string Problem;
  double Patience;
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
  int Taken = 0;
};

#endif
