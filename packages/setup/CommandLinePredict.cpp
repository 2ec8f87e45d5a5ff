#include <algorithm>
#include <ostream>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/output/AtomicFile.hpp>
#include <harmos/output/StudyData.hpp>
#include <harmos/setup/CommandLineVerbs.hpp>
#include <harmos/setup/PointsFile.hpp>

namespace harmos::setup {

namespace {

/// The point that options "--at NAME=VALUE" describe.
std::vector<double> pointOf(const std::vector<std::string>& assignments, const std::vector<std::string>& parameters) {
  const auto fail = [](const std::string& what) {
    throw base::Error("harmos predict: " + what, base::ExitCode::input);
  };
  std::vector<double> point(parameters.size());
  std::vector<bool> isGiven(parameters.size(), false);
  for (const std::string& assignment : assignments) {
    const auto equals = assignment.find('=');
    const std::string name = assignment.substr(0, equals);
    const auto found = std::find(parameters.begin(), parameters.end(), name);
    if (found == parameters.end()) {
      fail("the study varies no \"" + name + "\".\n  " + base::suggestName(name, parameters, "It varies"));
    }
    const auto value = equals == std::string::npos ? std::nullopt : base::parseNumber(assignment.substr(equals + 1));
    if (!value) fail("--at " + assignment + ": write NAME=NUMBER.");
    const auto p = static_cast<std::size_t>(found - parameters.begin());
    point[p] = *value;
    isGiven[p] = true;
  }
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    if (!isGiven[p]) fail("there is no value of \"" + parameters[p] + "\".\n  Add --at " + parameters[p] + "=NUMBER.");
  }
  return point;
}

int predict(const CommandLineArguments& arguments, const CommandEnvironment& environment) {
  arguments.requireOperands({"STUDY.h5"});
  if (!environment.isRoot()) return 0;
  const output::StudyData data = output::readStudyData(arguments.operands()[0]);
  if (arguments.has("--points") == arguments.has("--at")) {
    throw base::Error("harmos predict wants either --points or --at. Try \"harmos predict --help\".",
                      base::ExitCode::input);
  }
  const auto points = arguments.has("--points")
                          ? readPoints(arguments.value("--points", ""), data.parameters)
                          : std::vector<std::vector<double>>{pointOf(arguments.values("--at"), data.parameters)};
  std::vector<study::Surrogate> surrogates;
  std::string text;
  for (const std::string& name : data.parameters) text += name + ",";
  for (std::size_t r = 0; r < data.responses.size(); ++r) {
    auto surrogate = data.surrogate(r);
    if (!surrogate) {
      throw base::Error("The study has too few solutions for a surface of \"" + data.responses[r] + "\".",
                        base::ExitCode::input);
    }
    surrogates.push_back(std::move(*surrogate));
    text += data.responses[r] + "," + data.responses[r] + "_deviation,";
  }
  text += "extrapolated\n";
  for (const auto& point : points) {
    bool isInside = true;
    for (const double value : point) text += base::toText(value) + ",";
    for (const study::Surrogate& surrogate : surrogates) {
      const auto prediction = surrogate.evaluate(point);
      text += base::toText(prediction.value) + "," + base::toText(prediction.deviation) + ",";
      isInside = isInside && prediction.isInside;
    }
    text += isInside ? "0\n" : "1\n";
  }
  if (arguments.has("--output")) {
    output::replaceFile(arguments.value("--output", ""), text);
  } else {
    environment.out << text;
  }
  return 0;
}

}  // namespace

Command predictCommand() {
  return {"predict",
          "STUDY.h5",
          "Evaluate the response surfaces of a study, with error bars, without solving anything.",
          {{"--at", "NAME=VALUE", "value of a parameter; once for each", true},
           {"--points", "FILE.csv", "a table of points instead; its header names the parameters"},
           {"--output", "FILE.csv", "write the table there (default: print it)"}},
          {"harmos predict results/bolted_joint_study.h5 --at mu=0.22 --at preload_1=0.11 --at preload_2=0.08",
           "harmos predict results/bolted_joint_study.h5 --points points.csv --output surface.csv"},
          predict};
}

}  // namespace harmos::setup
