#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

#include <harmos/files/StudyWriter.hpp>
#include <harmos/laws/LawRegistry.hpp>
#include <harmos/results/StudyResults.hpp>
#include <harmos/study/Study.hpp>

namespace harmos::study {

/// What to study and whom to tell.
struct StudyRunRequest {
  std::string study;  // path of the XML file
  /// Of a study in memory, which `study` only names, and of its scene, which may be null as well: then it is a file.
  std::shared_ptr<const input::InputTree> input, scene;
  std::vector<std::string> overrides;  // as for readStudy()
  std::string pointsFile;              // as for readStudy()
  std::string directory = "results";   // of the result files
  bool anySize = false;                // also a mesh that will not fit into the memory that is free
  bool restart = false;                // forget the results of an earlier run
  int ranksPerConfiguration = 1;       // size of the teams that solve configurations side by side
  /// Once, before the first solution; may be empty. `damaged`: lines of the journal that could not be read.
  std::function<void(const Study&, const results::StudyResults&, int damaged)> started;
  /// After every result that a rank keeps (rank 0: all); may be empty.
  std::function<void(const results::StudyResults&)> observer;
  /// On rank 0: what happens before configurations are solved, one sentence at a time; may be empty. Only the solver of
  /// expansions says anything.
  std::function<void(const std::string&)> message;
  std::function<bool()> interrupted;  // asked between iterations; may be empty
};

/// A study and what became of it.
struct StudyRunResult {
  std::unique_ptr<const Study> study;                            // as it was read
  std::unique_ptr<const results::StudyDescription> description;  // `results` refers to it
  std::unique_ptr<results::StudyResults> results;  // on rank 0 all of them, elsewhere those of the own team
  files::StudyFiles files;                         // where the files are
  std::string state;                               // complete, interrupted, aborted
  int exitCode = 0;                                // 0: all solved; 3, 4, 130 as for a scene; 1: aborted
};

/// Solves all configurations of a study that are not solved yet and writes its files: what `harmos study` does, without
/// printing. Collective over `comm`. `laws` and the request are not kept.
///
/// Input, mesh and the files of an earlier run are checked first; if they are wrong, base::Error (input) leaves all
/// files as they were. An error inside one configuration is recorded with it, and the study goes on as its failure
/// policy says. After an interruption, or after the process was killed, the same request resumes.
StudyRunResult runStudy(const StudyRunRequest& request, const laws::LawRegistry& laws,
                        const Teuchos::RCP<const Teuchos::Comm<int>>& comm);

}  // namespace harmos::study
