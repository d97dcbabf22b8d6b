#include "CommandBake.h"

#include "BakeFromMesh.h"
#include "BakeGDM.h"
#include "BakeGeometryImage.h"
#include "BakeHorizon.h"
#include "BakeNormal.h"
#include "BakeSearchMap.h"
#include "BakeVDM.h"

#include <CLI/CLI.hpp>

CommandBake::CommandBake(CLI::App& app)
  : Command(app.add_subcommand("bake", "Compute once, from a map, what a technique needs."))
{
  this->Kinds.push_back(std::make_unique<BakeFromMesh>());
  this->Kinds.push_back(std::make_unique<BakeGDM>());
  this->Kinds.push_back(std::make_unique<BakeGeometryImage>());
  this->Kinds.push_back(std::make_unique<BakeHorizon>());
  this->Kinds.push_back(std::make_unique<BakeNormal>());
  this->Kinds.push_back(std::make_unique<BakeCone>());
  this->Kinds.push_back(std::make_unique<BakeMaximumMip>());
  this->Kinds.push_back(std::make_unique<BakeVDM>());
  this->Command->require_subcommand(0, 1); // so that a mistyped kind is named
  for (const auto& kind : this->Kinds)
  {
    kind->AddOptions(*this->Command->add_subcommand(kind->GetName()));
  }
  this->Command->footer("Example: meso bake normal stone.png -o stone_normal.png\n"
                        "Each kind has its own help: meso bake normal --help");
}

CommandBake::~CommandBake() = default;

int CommandBake::Run()
{
  for (const auto& kind : this->Kinds)
  {
    if (this->Command->got_subcommand(kind->GetName()))
    {
      kind->Run();
      return 0;
    }
  }
  throw CLI::RequiredError("A kind of bake");
}
