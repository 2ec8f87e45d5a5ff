#include <filesystem>
#include <utility>

#include <harmos/base/Error.hpp>
#include <harmos/cli/detail/ResultVerb.hpp>
#include <harmos/files/OutputGuard.hpp>
#include <harmos/files/PythonPackage.hpp>

namespace harmos::cli {

int runOnResult(const std::string& verb, const std::string& extension, const std::vector<CommandOption>& options,
                const Arguments& arguments, const CommandEnvironment& environment) {
  arguments.requireOperands({"RESULT.e"});
  const std::string result = arguments.operands()[0];
  if (!environment.isRoot()) return 0;
  if (!std::filesystem::exists(result))
    throw base::Error("Cannot read " + result + ": there is no such file.", base::ExitCode::input);
  const std::string beside = std::filesystem::path(result).replace_extension(extension).string();
  const std::string output = arguments.value("--output", beside);
  if (extension.empty()) {
    files::demandFolder(output);
  } else {
    files::demandWritable({output});
  }
  std::vector<std::string> words = {verb, result, output};
  for (const CommandOption& option : options) {
    if (option.name != "--output" && arguments.has(option.name))
      words.push_back(option.name + "=" + arguments.value(option.name, ""));
  }
  return files::runPythonPackage(std::move(words), environment.interrupted, false).exitCode;
}

}  // namespace harmos::cli
