#ifndef BenchSettings_h
#define BenchSettings_h

#include "MesoOptions.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

/// One way to draw a scene: a point of a curve.
struct BenchArm
{
  MesoTechnique Technique = MesoTechnique::Plain;
  std::optional<MesoQuality> Quality; ///< none where the technique has one setting
  /// Of a part of an ablation: the effect that is off. `IsAblation` without one: all are on.
  std::optional<MesoEffect> Without;
  bool IsAblation = false;
  std::optional<MesoSearch> Search; ///< none: what the quality stands for

  std::string TechniqueName() const { return MesoName(this->Technique); }
  std::string QualityName() const { return this->Quality ? MesoName(*this->Quality) : ""; }
  std::string SearchName() const { return this->Search ? MesoName(*this->Search) : ""; }
  /// "relief-high", "relief-high-cone", for files and messages.
  std::string Name() const
  {
    return this->TechniqueName() + (this->Quality ? "-" + this->QualityName() : "") +
      (this->Search ? "-" + this->SearchName() : "") +
      (this->IsAblation ? "-without-" + this->WithoutName() : "");
  }
  /// The effect that is off, or "none".
  std::string WithoutName() const { return this->Without ? MesoName(*this->Without) : "none"; }
};

/// What `meso bench` is asked for.
struct BenchSettings
{
  std::vector<std::string> SceneFiles;
  std::string Folder;
  std::vector<BenchArm> Arms;
  std::array<int, 2> Size = { 512, 384 };
  int WarmUp = 5;             ///< rounds of frames before those that count
  int Runs = 20;              ///< rounds that count
  bool Quick = false;         ///< fewer settings of what is scaled
  bool Fresh = false;         ///< measure again what the folder holds already
  bool Ablation = false;      ///< measure each effect's share as well
  bool MapsAsVolumes = false; ///< draw maps by techniques of volumes too, which takes long
  bool Scaling = false;       ///< and how time grows with pixels, triangles, texels and lights
};

#endif
