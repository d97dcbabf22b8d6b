/**
 * @class vtkMesoBuiltInSource
 * @brief What the sources of built-in height maps and volumes have in common.
 *
 * A pattern's name, its seed and its keys. What is unknown or out of range gives one vtkErrorMacro line
 * and an empty output.
 */

#ifndef vtkMesoBuiltInSource_h
#define vtkMesoBuiltInSource_h

#include "mesoFiltersMapsModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <array>  // for sizes
#include <map>    // for parameters
#include <string> // for names

class MESOFILTERSMAPS_EXPORT vtkMesoBuiltInSource : public vtkImageAlgorithm
{
public:
  vtkTypeMacro(vtkMesoBuiltInSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The pattern's name.
  void SetPattern(const char* pattern);
  const char* GetPattern() const { return this->Pattern.c_str(); }
  ///@}

  ///@{
  /// Chooses among patterns of the same look; regular ones do not depend on it. Default: 1.
  vtkSetMacro(Seed, unsigned int);
  vtkGetMacro(Seed, unsigned int);
  ///@}

  /// Sets one of the pattern's keys; keys not set have their defaults.
  void SetParameter(const std::string& key, double value);
  /// Sets all keys back to their defaults.
  void ClearParameters();

  /// Why the last update gave nothing; empty where it gave an image.
  const std::string& GetErrorMessage() const { return this->ErrorMessage; }

protected:
  explicit vtkMesoBuiltInSource(const char* pattern);
  ~vtkMesoBuiltInSource() override = default;

  /// Why pattern, keys or size cannot be; empty where they can.
  virtual std::string Problem() const = 0;
  /// Samples along x, y and z.
  virtual std::array<int, 3> SamplesAlong() const = 0;
  const std::map<std::string, double>& GetParameters() const { return this->Parameters; }

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoBuiltInSource(const vtkMesoBuiltInSource&) = delete;
  void operator=(const vtkMesoBuiltInSource&) = delete;

  std::string Pattern;
  unsigned int Seed = 1;
  std::map<std::string, double> Parameters;
  std::string ErrorMessage;
};

#endif
