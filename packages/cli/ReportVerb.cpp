#include <filesystem>

#include <harmos/base/Error.hpp>
#include <harmos/cli/detail/Verbs.hpp>
#include <harmos/files/OutputGuard.hpp>
#include <harmos/files/PythonPackage.hpp>

namespace harmos::cli {

namespace {

namespace fs = std::filesystem;

int report(const Arguments& arguments, const CommandEnvironment& environment) {
  arguments.requireOperands({"STUDY.h5"});
  if (!environment.isRoot()) return 0;
  const std::string study = arguments.operands()[0];
  if (!fs::exists(study)) throw base::Error("Cannot read " + study + ": there is no such file.", base::ExitCode::input);
  const std::string page = arguments.value("--output", fs::path(study).replace_extension(".html").string());
  files::demandWritable({page});
  for (const std::string& folder : arguments.values("--pictures")) files::demandFolder(folder);
  std::vector<std::string> words = {"report", study, page};
  for (const std::string option : {"--abscissa", "--pictures"}) {
    if (arguments.has(option)) words.insert(words.end(), {option, arguments.value(option, "")});
  }
  return files::runPythonPackage(std::move(words), environment.interrupted, false).exitCode;
}

}  // namespace

Command reportCommand() {
  return {"report",
          "STUDY.h5",
          "Write one HTML file with the pictures and tables of a study.",
          {{"--output", "FILE.html", "the page (default: beside the study, with its name)"},
           {"--abscissa", "CURVE", "draw the other curves against this one (default: against time)"},
           {"--pictures", "DIR", "write the pictures there as well, as PNG files"}},
          {"harmos report results/bolted_joint_study.h5 --abscissa u_load"},
          report};
}

}  // namespace harmos::cli
