#include <algorithm>
#include <cmath>
#include <ostream>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/cli/detail/Verbs.hpp>
#include <harmos/files/AtomicFile.hpp>
#include <harmos/files/OutputGuard.hpp>
#include <harmos/files/StoredExpansions.hpp>
#include <harmos/files/StoredInterpolant.hpp>
#include <harmos/files/StoredSurfaceData.hpp>
#include <harmos/study/PointsFile.hpp>

namespace harmos::cli {

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
    if (isGiven[p]) fail("--at " + assignment + ": the value of \"" + name + "\" is given twice.");
    point[p] = *value;
    isGiven[p] = true;
  }
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    if (!isGiven[p]) fail("there is no value of \"" + parameters[p] + "\".\n  Add --at " + parameters[p] + "=NUMBER.");
  }
  return point;
}

std::vector<std::vector<double>> pointsOf(const Arguments& arguments, const std::vector<std::string>& parameters) {
  if (arguments.has("--points")) return study::readPoints(arguments.value("--points", ""), parameters);
  return {pointOf(arguments.values("--at"), parameters)};
}

/// A number that may be unknown as a cell of the table.
std::string cell(double value) {
  return (std::isnan(value) ? "" : base::toText(value)) + ",";
}

std::string header(const std::vector<std::string>& parameters, const std::vector<std::string>& responses) {
  std::string text;
  for (const std::string& name : parameters) text += name + ",";
  for (const std::string& name : responses) text += name + "," + name + "_deviation,";
  return text + "extrapolated\n";
}

std::string evaluate(const files::StoredExpansions& expansions, const Arguments& arguments) {
  std::string text = header(expansions.parameters(), expansions.responses());
  for (const auto& point : pointsOf(arguments, expansions.parameters())) {
    for (const double value : point) text += cell(value);
    const std::vector<double> values = expansions.evaluate(point);
    for (std::size_t r = 0; r < values.size(); ++r) text += cell(values[r]) + cell(expansions.deviation(r));
    text += expansions.isInside(point) ? "0\n" : "1\n";
  }
  return text;
}

std::string evaluate(const files::StoredInterpolant& interpolant, const Arguments& arguments) {
  std::string text = header(interpolant.parameters(), interpolant.responses());
  for (const auto& point : pointsOf(arguments, interpolant.parameters())) {
    for (const double value : point) text += cell(value);
    const auto prediction = interpolant.evaluate(point);
    for (std::size_t r = 0; r < prediction.values.size(); ++r) {
      text += cell(prediction.values[r]) + cell(prediction.deviations[r]);
    }
    text += prediction.isInside ? "0\n" : "1\n";
  }
  return text;
}

std::string evaluate(const results::SurfaceData& data, const Arguments& arguments) {
  const auto points = pointsOf(arguments, data.parameters);
  std::vector<design::Surrogate> surrogates;
  for (std::size_t r = 0; r < data.responses.size(); ++r) {
    auto surrogate = data.surrogate(r);
    if (!surrogate) {
      throw base::Error("The study has too few solutions for a surface of \"" + data.responses[r] + "\".",
                        base::ExitCode::input);
    }
    surrogates.push_back(std::move(*surrogate));
  }
  std::string text = header(data.parameters, data.responses);
  for (const auto& point : points) {
    bool isInside = true;
    for (const double value : point) text += cell(value);
    for (const design::Surrogate& surrogate : surrogates) {
      const auto prediction = surrogate.evaluate(point);
      text += cell(prediction.value) + cell(prediction.deviation);
      isInside = isInside && prediction.isInside;
    }
    text += isInside ? "0\n" : "1\n";
  }
  return text;
}

int predict(const Arguments& arguments, const CommandEnvironment& environment) {
  arguments.requireOperands({"STUDY.h5"});
  if (!environment.isRoot()) return 0;
  const std::string& path = arguments.operands()[0];
  files::demandDistinct({path, arguments.value("--points", "")}, {arguments.value("--output", "")});
  files::demandWritable(arguments.values("--output"));
  const results::SurfaceData data = files::readSurfaceData(path);
  if (arguments.has("--points") == arguments.has("--at")) {
    throw base::Error("harmos predict wants either --points or --at. Try \"harmos predict --help\".",
                      base::ExitCode::input);
  }
  const auto expansions = files::StoredExpansions::read(path);
  const auto interpolant = files::StoredInterpolant::read(path);
  const std::string text = interpolant  ? evaluate(*interpolant, arguments)
                           : expansions ? evaluate(*expansions, arguments)
                                        : evaluate(data, arguments);
  if (arguments.has("--output")) {
    files::createFolderOf(arguments.value("--output", ""));
    files::replaceFile(arguments.value("--output", ""), text);
  } else {
    environment.out << text;
  }
  return 0;
}

}  // namespace

Command predictCommand() {
  return {"predict",
          "STUDY.h5",
          "Evaluate the response surfaces, expansions or interpolation of a study, with error bars, without solving "
          "anything.",
          {{"--at", "NAME=VALUE", "value of a parameter; once for each", true},
           {"--points", "FILE.csv", "a table of points instead; its header names the parameters"},
           {"--output", "FILE.csv", "write the table there (default: print it)"}},
          {"harmos predict results/glued_assembly_chaos.h5 --at E_1=550 --at E_2=900",
           "harmos predict results/bolted_joint_study.h5 --at mu=0.22 --at preload_1=0.11 --at preload_2=0.08",
           "harmos predict results/bolted_joint_study.h5 --points points.csv --output surface.csv"},
          predict};
}

}  // namespace harmos::cli
