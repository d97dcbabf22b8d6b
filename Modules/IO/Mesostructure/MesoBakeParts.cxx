#include "MesoBakeParts.h"

#include "MesoAtomicFile.h"
#include "MesoBakeCache.h"
#include "MesoChecksum.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

namespace
{
std::string SumOf(int part, const float* numbers, std::size_t count)
{
  MesoChecksum sum;
  sum.Add(static_cast<std::int64_t>(part));
  sum.Add(static_cast<std::int64_t>(count));
  sum.Add(numbers, count * sizeof(float));
  return sum.Text();
}
}

MesoBakeParts::MesoBakeParts(const std::string& kind,
  const std::map<std::string, MesoBakedParameter>& parameters, double patience)
  : Patience(patience)
{
  const std::string cache = MesoBakeCacheFolder();
  if (!cache.empty())
  {
    this->Folder = cache + "/" + MesoBakeName(kind, parameters) + ".parts";
  }
}

std::string MesoBakeParts::FileOf(int part) const
{
  return this->Folder + "/" + std::to_string(part);
}

bool MesoBakeParts::Take(int part, float* numbers, std::size_t count)
{
  if (this->Folder.empty())
  {
    return false;
  }
  const std::string file = this->FileOf(part);
  std::string sum = SumOf(part, nullptr, 0);
  const std::uintmax_t bytes = count * sizeof(float);
  std::error_code error;
  if (std::filesystem::file_size(file, error) != bytes + sum.size())
  {
    return false;
  }
  std::vector<float> kept(count);
  std::ifstream stream(file, std::ios::binary);
  stream.read(reinterpret_cast<char*>(kept.data()), static_cast<std::streamsize>(bytes));
  stream.read(sum.data(), static_cast<std::streamsize>(sum.size()));
  if (!stream || sum != SumOf(part, kept.data(), count))
  {
    return false;
  }
  std::copy(kept.begin(), kept.end(), numbers);
  ++this->Taken;
  return true;
}

void MesoBakeParts::Keep(int part, const float* numbers, std::size_t count)
{
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - this->Start;
  if (this->Folder.empty() || !this->Problem.empty() || passed.count() < this->Patience)
  {
    return;
  }
  try
  {
    std::filesystem::create_directories(this->Folder);
    const std::string sum = SumOf(part, numbers, count);
    const std::size_t bytes = count * sizeof(float);
    std::vector<char> file(bytes + sum.size());
    std::memcpy(file.data(), numbers, bytes);
    std::memcpy(file.data() + bytes, sum.data(), sum.size());
    MesoAtomicFile::Write(this->FileOf(part), file.data(), file.size());
  }
  catch (const std::exception& problem)
  {
    this->Problem = problem.what();
  }
}

void MesoBakeParts::Remove()
{
  std::error_code error; // what cannot be removed takes no harm: it is whole
  if (!this->Folder.empty())
  {
    std::filesystem::remove_all(this->Folder, error);
  }
}
