#ifndef MesoFirstEqual_h
#define MesoFirstEqual_h

/**
 * @file MesoFirstEqual.h
 * @brief Finds equal tuples of numbers.
 */

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

/// For each tuple the index of the first that is equal to it, in expected linear time. -0 equals 0;
/// NaN equals nothing.
template <std::size_t N>
std::vector<std::int64_t> MesoFirstEqual(const std::vector<std::array<double, N>>& tuples)
{
  std::size_t slots = 16;
  while (slots < 2 * tuples.size())
  {
    slots *= 2;
  }
  std::vector<std::int64_t> table(slots, -1);
  std::vector<std::int64_t> first(tuples.size());
  for (std::size_t i = 0; i < tuples.size(); ++i)
  {
    std::uint64_t hash = 0;
    for (double component : tuples[i])
    {
      const double value = component + 0.; // -0 becomes 0
      std::uint64_t bits;
      std::memcpy(&bits, &value, sizeof(bits));
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    std::size_t slot = hash & (slots - 1);
    while (table[slot] >= 0 && tuples[table[slot]] != tuples[i])
    {
      slot = (slot + 1) & (slots - 1);
    }
    if (table[slot] < 0)
    {
      table[slot] = static_cast<std::int64_t>(i);
    }
    first[i] = table[slot];
  }
  return first;
}

#endif
