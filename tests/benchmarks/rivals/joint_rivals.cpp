// A joint of contacts, preloads and loads by methods that are not LATIN, on the matrices of Harmos:
//   joint_rivals condensed|sparse SCENE.xml [--residual 1e-3] [--set ENTRY=VALUE]... [--configurations FILE]
// condensed: to the contact jumps, once; semi-smooth Newton with GMRES. sparse: semi-smooth Newton with one sparse LU
// per iteration. Prints CSV: linear responses at every load step. FILE has a configuration per line, overrides of the
// scene separated by blanks; condensed, the joint is shared, and lines begin with the number of the configuration.
// Ends with comments: iterations, factorisations, CPU seconds.
#include <algorithm>
#include <ctime>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>

#include <harmos/base/Error.hpp>

#include "CondensedEquations.hpp"
#include "NewtonMarch.hpp"
#include "SparseEquations.hpp"

namespace {

using namespace harmos;
using namespace harmos::benchmarks;

double cpuSeconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

std::string textOf(std::vector<std::string>& arguments, const std::string& option) {
  const auto found = std::find(arguments.begin(), arguments.end(), option);
  if (found == arguments.end() || found + 1 == arguments.end()) return "";
  std::string value = *(found + 1);
  arguments.erase(found, found + 2);
  return value;
}

std::vector<Overrides> readConfigurations(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw base::Error(path + " cannot be read.", base::ExitCode::input);
  std::vector<Overrides> result;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    Overrides& one = result.emplace_back();
    for (std::string word; words >> word;) one.push_back(word);
  }
  return result;
}

int compute(std::vector<std::string> arguments) {
  const double residual = optionOf(arguments, "--residual", 1e-3);
  const std::string table = textOf(arguments, "--configurations");
  Overrides overrides;
  for (std::string one = textOf(arguments, "--set"); !one.empty(); one = textOf(arguments, "--set"))
    overrides.push_back(one);
  if (arguments.size() != 2 || (arguments[0] != "condensed" && arguments[0] != "sparse")) {
    std::cerr << "usage: joint_rivals condensed|sparse SCENE.xml [--residual 1e-3] [--set ENTRY=VALUE]... "
                 "[--configurations FILE]\n";
    return 2;
  }
  const Study study(arguments[1], overrides);
  const JointSystem system(study);
  const double assembled = cpuSeconds();
  std::unique_ptr<JumpEquations> equations;
  if (arguments[0] == "condensed") {
    equations = std::make_unique<CondensedEquations>(system);
  } else {
    equations = std::make_unique<SparseEquations>(system);
  }
  const double prepared = cpuSeconds();

  std::cout.precision(12);
  std::cout << "configuration,time";
  for (const std::string& name : system.responses()) std::cout << "," << name;
  std::cout << ",pressure_force\n";
  const std::vector<Overrides> configurations = table.empty() ? std::vector<Overrides>(1) : readConfigurations(table);
  int iterations = 0;
  for (std::size_t number = 0; number < configurations.size(); ++number) {
    Overrides all = overrides;
    all.insert(all.end(), configurations[number].begin(), configurations[number].end());
    const scene::Scene scene = scene::readScene(arguments[1], all, laws::builtInLaws());
    std::vector<std::vector<double>> frictions;
    for (int t = 0; t < study.problem.assembly.steps(); ++t) frictions.push_back(system.frictions(scene, t));
    const NewtonResult result = marchByNewton(*equations, system.amplitudes(scene), frictions, residual);
    iterations += result.iterations;
    for (std::size_t t = 0; t < result.responses.size(); ++t) {
      std::cout << number << "," << study.problem.assembly.times[t];
      for (const double value : result.responses[t]) std::cout << "," << value;
      std::cout << "," << result.pressureForce[t] << "\n";
    }
  }
  std::cout << "# unknowns " << system.unknowns() << ", jumps " << system.jumps() << "\n# iterations " << iterations
            << ", factorisations " << equations->factorisations() << ", linear iterations "
            << equations->linearIterations() << "\n# CPU seconds: assembled " << assembled << ", prepared "
            << prepared - assembled << ", marched " << cpuSeconds() - prepared << "\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return harmos::benchmarks::runProgram(argc, argv, compute);
}
