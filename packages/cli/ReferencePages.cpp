#include <harmos/cli/detail/ReferencePages.hpp>

#include <csignal>

#include <harmos/base/Error.hpp>
#include <harmos/scene/ResultFields.hpp>

namespace harmos::cli {

namespace {

/// In a cell of a table of Markdown.
std::string cell(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '|' ? "\\|" : std::string(1, c);
  return out;
}

std::string code(const std::string& text) {
  return text.empty() ? "" : "`" + cell(text) + "`";
}

input::Page lawsPage(const laws::LawRegistry& laws) {
  std::string text =
      "Laws of interfaces and boundaries. delta: jump, side 2 less side 1; t: traction on side 1, t_n < 0 is pressure; "
      "opening: delta_n and the gap; p: pressure; s: slip; w: displacement.\n\n"
      "| `Type` | equation | source |\n|---|---|---|\n";
  for (const input::ParameterSpec& law : laws.forms()) {
    text += "| " + code(law.name()) + " | " + code(law.equation()) + " | " + cell(law.source()) + " |\n";
  }
  return {"Laws", text};
}

std::string tableOf(const std::vector<scene::ResultField>& fields) {
  std::string text = "| field | unit | what it is |\n|---|---|---|\n";
  for (const scene::ResultField& field : fields) {
    const std::string components = field.isVector ? "`, `" + field.name + "_y`, `" + field.name + "_z`" : "`";
    text += "| `" + field.name + (field.isVector ? "_x" : "") + components + " | " + field.unit + " | " +
            cell(field.doc) + " |\n";
  }
  return text + "\n";
}

input::Page outputsPage(const laws::LawRegistry& laws) {
  std::string text =
      "`SCENE.e` has the parts, `SCENE_interfaces.e` interfaces and boundaries as surfaces; every response is a global "
      "variable of both. At time 0 all is 0.\n\nAt the nodes of parts:\n\n" +
      tableOf(scene::nodalPartFields()) + "With `Output/Nodal Stress` besides:\n\n" +
      tableOf(scene::nodalStressFields()) + "In elements of parts, means:\n\n" + tableOf(scene::elementFields()) +
      "At points of interfaces and boundaries:\n\n" + tableOf(scene::interfaceFields()) +
      "What laws add, 0 where another law is:\n\n";
  text += "| law | field | unit | what it is |\n|---|---|---|---|\n";
  for (const input::ParameterSpec& law : laws.forms()) {
    for (const auto& field : law.outputs()) {
      text += "| " + cell(law.name()) + " | `" + field.name + "` | " + field.unit + " | " + cell(field.doc) + " |\n";
    }
  }
  return {"Outputs", text};
}

input::Page exitCodesPage() {
  std::string text = "| code | meaning |\n|---|---|\n";
  for (const ExitCodeMeaning& each : exitCodeMeanings()) {
    text += "| " + std::to_string(each.code) + " | " + each.meaning + " |\n";
  }
  return {"Exit Codes", text};
}

}  // namespace

std::vector<ExitCodeMeaning> exitCodeMeanings() {
  return {
      {static_cast<int>(base::ExitCode::ok), "done; for run and study: all solutions are as accurate as asked for"},
      {static_cast<int>(base::ExitCode::failure),
       "failure, also of memory or disk, the message says which; for compare: the files are different"},
      {static_cast<int>(base::ExitCode::input), "the input or the command line is wrong, nothing was run or written"},
      {static_cast<int>(base::ExitCode::notConverged),
       "not converged: iteration limit or stagnation; for study: some configurations have no solution, a "
       "tolerance of the design was not reached, or an audit found a larger error than was accepted"},
      {static_cast<int>(base::ExitCode::noEquilibrium),
       "no equilibrium exists under the given loads, or no path leads to it; for study: of some configurations, "
       "all others are solved"},
      {128 + SIGINT,
       "interrupted (SIGINT, SIGTERM, SIGUSR1), within a second; what was complete stays, what was being written is "
       "removed"}};
}

std::vector<input::Page> referencePages(const laws::LawRegistry& laws) {
  return {lawsPage(laws), outputsPage(laws), exitCodesPage()};
}

}  // namespace harmos::cli
