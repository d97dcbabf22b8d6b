#ifndef MesoVolumeFields_h
#define MesoVolumeFields_h

/**
 * @file MesoVolumeFields.h
 * @brief A volume's header of text: fields by their keys, checked where they are asked for.
 */

#include <array>
#include <map>
#include <string>
#include <vector>

class MesoVolumeFields
{
public:
  explicit MesoVolumeFields(const std::string& fileName)
    : FileName(fileName)
  {
  }

  /// Blanks around the value are dropped; what is said last counts.
  void Set(const std::string& key, const std::string& value);
  bool Has(const std::string& key) const { return this->Fields.count(key) > 0; }
  /// Empty where there is none.
  std::string Of(const std::string& key) const;
  /// The first of the keys that the header has; the last where it has none.
  std::string OneOf(const std::vector<std::string>& keys) const;

  /// `count` finite numbers, between blanks, commas and parentheses. Throws for what is no such list.
  std::vector<double> Numbers(const std::string& key, std::size_t count) const;
  /// A whole number in [least, most]; `otherwise` where there is none.
  double WholeNumber(const std::string& key, double least, double most, double otherwise) const;
  /// Samples along three axes, 1 to MesoVolumeLargestSide each.
  std::array<int, 3> Size(const std::string& key) const;
  /// A truth value: True, true, 1, and so on; false where there is none.
  bool IsTrue(const std::string& key) const;

  /// The bytes of the file that a key names, which lies beside the header's or in a folder below.
  std::string BytesBeside(const std::string& key) const;

  /// Throws MesoInputError "file: key: reason", or "file: reason" without a key.
  [[noreturn]] void Fail(const std::string& key, const std::string& reason) const;

private:
  const std::string& FileName;
  std::map<std::string, std::string> Fields;
};

#endif
