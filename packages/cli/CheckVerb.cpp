#include <cmath>
#include <iomanip>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <harmos/base/Error.hpp>
#include <harmos/base/MachineSpeed.hpp>
#include <harmos/cli/detail/StudyText.hpp>
#include <harmos/cli/detail/Verbs.hpp>
#include <harmos/cli/detail/Warnings.hpp>
#include <harmos/scene/MemoryPerRank.hpp>
#include <harmos/scene/ProblemCost.hpp>
#include <harmos/study/ChaosCost.hpp>
#include <harmos/study/StudyCost.hpp>
#include <harmos/study/StudyReader.hpp>

namespace harmos::cli {

namespace {

void printBytes(std::ostream& out, const char* what, double bytes) {
  out << "  " << std::left << std::setw(34) << what << std::right << std::setw(10) << std::fixed
      << std::setprecision(bytes < 1e8 ? 1 : 0) << bytes / 1e6 << " MB\n";
}

void printSeconds(std::ostream& out, const std::string& what, double seconds) {
  out << "  " << std::left << std::setw(34) << what << std::right << std::setw(10) << std::fixed
      << std::setprecision(seconds < 1.0 ? 3 : 2) << seconds << " s\n"
      << std::defaultfloat;
}

/// For every interface of the assembly, how many pairs it has besides the first of their nodes, because of creases.
std::vector<int> pairsAtCreases(const scene::Problem& problem) {
  std::vector<std::set<int>> pairs(problem.assembly.interfaces.size());
  for (std::size_t s = 0; s < problem.surfaces.size(); ++s) {
    for (std::size_t p = 0; p < problem.places[s].size(); ++p) {
      const scene::PairPlace& place = problem.places[s][p];
      if (place.interface >= 0 && problem.surfaces[s].patch[p] > 0) pairs[place.interface].insert(place.pair);
    }
  }
  std::vector<int> counts;
  for (const auto& one : pairs) counts.push_back(static_cast<int>(one.size()));
  return counts;
}

bool isOnNodes(const assembly::Interface& interface) {
  return interface.trace1.isSelection() && interface.trace2.isSelection();
}

void printProblem(std::ostream& out, const scene::Problem& problem) {
  const assembly::Assembly& assembly = problem.assembly;
  out << assembly.bodies.size() << " substructures:\n";
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b)
    out << "  " << std::left << std::setw(34) << assembly.bodies[b].name << std::right << std::setw(10)
        << assembly.bodies[b].nodes.size() << " nodes " << std::setw(10) << problem.bodies.pieces[b].elements.size()
        << " elements, rank " << assembly.ownerOf(static_cast<int>(b)) << "\n";
  out << assembly.interfaces.size() << " interfaces and boundaries:\n";
  const std::vector<int> atCreases = pairsAtCreases(problem);
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    // Users must see clearances and overclosures before the solution, not guess them from it.
    double least = 0.0, largest = 0.0;
    for (double gap : interface.gap) {
      least = std::min(least, gap);
      largest = std::max(largest, gap);
    }
    out << "  " << std::left << std::setw(34) << interface.name << std::right << std::setw(10) << interface.pairs()
        << (!isOnNodes(interface)    ? " points, "
            : interface.sides() == 1 ? " nodes, "
                                     : " node pairs, ")
        << interface.law->name();
    if (interface.sides() == 2 && (least != 0.0 || largest != 0.0))
      out << ", initial opening " << std::defaultfloat << std::setprecision(3) << least << " to " << largest;
    if (atCreases[i] > 0) out << ", " << atCreases[i] << " of them added at creases";
    out << "\n";
  }
  if (!problem.joined.empty()) out << "Joined meshes that do not match:\n";
  for (const scene::JoinedMeshes& joined : problem.joined) out << joined.text();
  if (!problem.cuts.empty()) out << "Large parts: " << problem.cuts << "\n";
  out << assembly.steps() << " time steps, " << problem.responses.size() << " responses\n";
}

/// `stateBytes`: of solved configurations, beyond what one run takes. `slowness`: of the machine.
void printCost(std::ostream& out, const scene::CostEstimate& cost, double stateBytes, double slowness) {
  out << cost.unknowns << " displacement and " << cost.interfaceUnknowns << " interface unknowns\n"
      << "Memory, roughly:\n";
  printBytes(out, "stiffness matrices", cost.matrixBytes);
  printBytes(out, "factors", cost.factorBytes);
  if (cost.singleBytes > 0.0) printBytes(out, "the same in single precision, at most", cost.singleBytes);
  if (cost.iteratedBytes > 0.0) printBytes(out, "parts solved iteratively", cost.iteratedBytes);
  printBytes(out, "fields of the iteration", cost.fieldBytes);
  if (cost.inverseBytes > 0.0) printBytes(out, "inverted traces", cost.inverseBytes);
  if (cost.stencilBytes > 0.0) printBytes(out, "reactions of held nodes", cost.stencilBytes);
  if (stateBytes > 0.0) printBytes(out, "solved configurations", stateBytes);
  if (cost.derivativeBytes > 0.0) printBytes(out, "derivatives", cost.derivativeBytes);
  printBytes(out, "whole process at its peak", cost.processBytes);
  out << "CPU time, roughly (this machine takes " << std::setprecision(1) << slowness
      << " times as long as the one of the rates):\n";
  printSeconds(out, "start, reading, stiffness", slowness * (cost.startSeconds + cost.cuttingSeconds));
  printSeconds(out, "factorisation", slowness * cost.factorSeconds);
  if (cost.staticsSeconds > 0.0) printSeconds(out, "statics of the loads", slowness * cost.staticsSeconds);
  printSeconds(out, "one linear stage", slowness * cost.stageSeconds);
  if (cost.correctionSeconds > 0.0)
    printSeconds(out, "least squares of its vectors", slowness * cost.correctionSeconds);
  printSeconds(out, "error of the mesh, files", slowness * cost.resultSeconds());
  if (cost.derivativeSeconds > 0.0) printSeconds(out, "derivatives", slowness * cost.derivativeSeconds);
  std::ostringstream stages;
  stages << std::fixed << std::setprecision(0) << "run of " << cost.stages << " linear stages";
  printSeconds(out, stages.str(), slowness * cost.seconds());
}

void printExpansions(std::ostream& out, const study::ChaosChoice& choice, int ranks) {
  out << "Expansions: " << std::fixed << std::setprecision(0) << choice.cost.terms << " polynomials, "
      << (choice.cost.isGalerkin ? "Galerkin" : "pseudo-spectral") << " local stage " << choice.why << "\n";
  printBytes(out, ranks == 1 ? "memory in all" : "memory of every rank", choice.cost.bytesOf(ranks));
}

/// `mostSeconds`: of as many configurations as an adaptive design may add.
void printStudy(std::ostream& out, const study::Study& study, const study::StudyCost& cost, double mostSeconds,
                double slowness) {
  std::ostringstream what;
  what << std::fixed << std::setprecision(0) << "study of " << cost.solves
       << (study.isChaos() ? " expansions, " : " configurations, ") << cost.stages << " stages";
  printSeconds(out, what.str(), slowness * cost.seconds);
  if (cost.sideBySide > 1) out << "  Side by Side: up to " << cost.sideBySide << " configurations march so\n";
  if (!study.isAdaptive()) return;
  out << "    with which it begins; how many it adds, its results tell\n";
  printSeconds(out, "at most, " + std::to_string(study::mostConfigurations(study)) + " configurations",
               slowness * mostSeconds);
}

/// Why traces of a study are inverted or not.
void printTraces(std::ostream& out, const scene::CostEstimate& cost, const substructure::SolverOptions& solver) {
  using Inversion = substructure::SolverOptions::Inversion;
  out << "  Trace Inverse: of " << cost.inverted << " of " << cost.factored << " operators, for ";
  if (solver.inversion == Inversion::automatic) {
    out << std::fixed << std::setprecision(0) << solver.traceSolves << " load steps that are solved on them";
  } else {
    out << (solver.inversion == Inversion::always ? "Yes" : "No") << " was asked for";
  }
  out << "; " << cost.dense << " traces are kept dense, reactions are found by "
      << (cost.stencilBytes > 0.0 ? "a matrix" : "solves of whole parts") << "\n";
}

/// `study`: whose scene it is, or null.
int checkScene(const scene::Scene& scene, const study::Study* study, const Arguments& arguments,
               const CommandEnvironment& environment) {
  base::Timers timers;
  const double freeBytes = scene::memoryOfAllRanks(*environment.communicator);
  scene::demandRoomForMesh(scene, freeBytes);
  const scene::Problem problem = scene::makeProblem(
      scene, *environment.communicator, timers, study == nullptr ? scene::Cutting::automatic : scene::Cutting::asGiven);
  latin::LatinOptions options = study != nullptr && !study->isChaos() ? study::solverOptions(*study) : scene.solver;
  if (study && study->isChaos()) options.stages.solver.allowsSingle = false;  // nothing marches
  scene::CostEstimate cost =
      scene::estimateCost(problem, options, scene::FactorSizes::fromOrder, *environment.communicator);
  if (scene.wantsMeshErrors) {
    cost.processBytes += cost.meshErrorBytes;
  } else {
    cost.meshErrorSeconds = 0.0;
  }
  const bool writesFields = scene.output.fields && study == nullptr;
  cost.processBytes += writesFields ? cost.fileBytes : 0.0;
  if (!writesFields) cost.fileSeconds = 0.0;
  if (study) cost.cuttingSeconds = 0.0;  // parts stay as they are given
  if (!study) cost.addDerivatives(static_cast<int>(scene.output.derivatives.size()));
  study::StudyCost ofStudy;
  if (study && !study->isChaos())
    ofStudy = study::estimateStudy(*study, cost, static_cast<int>(study->configurations.size()));
  cost.processBytes += ofStudy.bytes;
  const bool isShown = environment.isRoot() && !arguments.has("--quiet");
  const double slowness = isShown ? base::machineSlowness() : 1.0;
  if (isShown) {
    printProblem(environment.out, problem);
    printCost(environment.out, cost, ofStudy.bytes, slowness);
    printWarnings(environment.out, problem.warnings);
  }
  scene::demandCapacity(cost, freeBytes);
  if (study && study->isChaos()) {
    const study::ChaosChoice choice = study::chooseLocalStage(*study, problem, *environment.communicator);
    if (isShown) {
      printExpansions(environment.out, choice, environment.communicator->getSize());
      printStudy(environment.out, *study, study::estimateStudy(*study, cost, choice.cost), 0.0, slowness);
    }
    study::demandMemory(*study, choice, *environment.communicator);
  }
  if (study && !study->isChaos() && isShown) {
    const int most = study::mostConfigurations(*study);
    printStudy(environment.out, *study, ofStudy, study::estimateStudy(*study, cost, most).seconds, slowness);
    printTraces(environment.out, cost, options.stages.solver);
  }
  if (!environment.isRoot()) return 0;
  environment.out << scene.path << " is valid.\n";
  return 0;
}

/// Every configuration is made, so that values outside of a range show before anything is solved.
int checkStudy(const study::Study& study, const Arguments& arguments, const CommandEnvironment& environment) {
  const laws::LawRegistry laws = laws::builtInLaws();
  if (environment.isRoot() && !arguments.has("--quiet")) printPlan(environment.out, study);
  int inadmissible = 0;
  std::string reason;
  for (const design::Configuration& configuration : study.configurations) {
    try {
      study.sceneFor(configuration.values, laws);
    } catch (const base::Error& error) {
      if (inadmissible++ == 0) reason = "configuration " + std::to_string(configuration.id) + ": " + error.what();
    }
  }
  checkScene(study.scene, &study, arguments, environment);
  if (!environment.isRoot()) return 0;
  if (inadmissible > 0) {
    environment.out << inadmissible << " configurations are not admissible; the first is " << reason << "\n";
  }
  environment.out << study.path << " is valid.\n";
  return 0;
}

int check(const Arguments& arguments, const CommandEnvironment& environment) {
  arguments.requireOperands({"SCENE.xml"});
  const std::string& path = arguments.operands()[0];
  const laws::LawRegistry laws = laws::builtInLaws();
  if (study::isStudyFile(path))
    return checkStudy(study::readStudy(path, arguments.values("--set"), "", laws), arguments, environment);
  return checkScene(scene::readScene(path, arguments.values("--set"), laws), nullptr, arguments, environment);
}

}  // namespace

Command checkCommand() {
  return {"check",
          "SCENE.xml",
          "Validate a scene or a study, say what it will allocate and roughly cost; nothing is solved.",
          {{"--set", "'LIST/NAME=VALUE'", "replace an entry of the scene; may be repeated", true},
           {"--quiet", "", "only say whether it is valid"}},
          {"harmos check xml/bolted_joint.xml", "harmos check xml/bolted_joint.xml --set 'Parts/cover_bottom/Pieces=4'",
           "harmos check xml/bolted_joint_study.xml"},
          check};
}

}  // namespace harmos::cli
