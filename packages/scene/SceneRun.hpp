#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

#include <harmos/files/DerivativesFile.hpp>
#include <harmos/files/ResultFiles.hpp>
#include <harmos/files/RunRecord.hpp>
#include <harmos/input/InputTree.hpp>
#include <harmos/latin/LatinSolver.hpp>
#include <harmos/laws/LawRegistry.hpp>
#include <harmos/scene/MeshError.hpp>

namespace harmos::scene {

/// What to run and whom to tell.
struct SceneRunRequest {
  std::string scene;                              // path of the XML file
  std::shared_ptr<const input::InputTree> input;  // of a scene in memory, which `scene` only names; or null
  std::vector<std::string> overrides;             // "List/Sublist/Name=value"
  std::string directory = "results";              // of the result files
  bool anySize = false;                           // also what is foreseen not to fit into the memory that is free
  std::function<void(const latin::IterationReport&)> observer;  // after every iteration, on every rank; may be empty
  std::function<bool()> interrupted;                            // asked after every iteration; may be empty
};

/// What came of a run.
struct SceneRunResult {
  latin::LatinResult solution;                         // responses and error estimates; fields are in the files only
  MeshErrors meshErrors;                               // of a certified solution, if they are wanted
  std::vector<files::ResponseDerivative> derivatives;  // of a certified solution, those that the scene asks for
  files::RunRecord record;                             // as it was written last
  files::ResultFiles files;                            // where the files are
  bool hasFields = true;                               // those of parts and interfaces are among them
};

/// From XML, or a scene in memory, to result files: what `harmos run` does, without printing. Collective over `comm`.
/// Nothing of the request is kept.
///
/// The input and the mesh are checked first; if they are wrong, base::Error (input) leaves the directory as it was.
/// So it does when a result would replace an input, and, unless any size is right, when the run would not fit into the
/// memory that is free (demandRoomForMesh(), demandCapacity()). Then the record says "running", and what the record of
/// an earlier run said, whose other files stay until those of this run are complete and replace them together. The
/// outcome, also an interruption or a failure, ends up in the record; a failure is thrown as well.
SceneRunResult runScene(const SceneRunRequest& request, const laws::LawRegistry& laws,
                        const Teuchos::RCP<const Teuchos::Comm<int>>& comm);

/// Exit code of a program for the outcome of a solution; 130 for an interruption, as shells have it for Ctrl-C.
int exitCodeOf(latin::Outcome outcome);

}  // namespace harmos::scene
