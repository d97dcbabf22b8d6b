#ifndef BakeVolume_h
#define BakeVolume_h

#include "MesoScene.h" // for the volume
#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;

namespace CLI
{
class App;
}

/// The volume that a kind bakes: INPUT and what it is made of, by options named as the scene file's keys.
class BakeVolume
{
public:
  /// Adds INPUT, --size, --threshold, --solid, --crop, --blend, --seed, --parameter.
  void AddOptions(CLI::App& command);

  /// The file's name, or empty where INPUT is a built-in volume.
  const std::string& GetFileName() const { return this->Volume.File; }

  /// What INPUT is made out to be. Throws MesoInputError where a built-in volume's numbers are wrong.
  const MesoSceneVolume& Resolve();

  /// A canonical volume. What is odd about it is said on standard error.
  vtkSmartPointer<vtkImageData> Read() const;

private:
  std::string Input;
  MesoSceneVolume Volume;
};

#endif
