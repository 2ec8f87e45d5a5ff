// Random glue by LATIN on polynomial chaos and by its rivals, in one process:
//   chaos_rivals xml/glued_assembly.xml [--repeats 5] [--refactored 200] [--condensed 500] [--studied 300]
// prints CPU seconds from the assembled bodies to the standard deviation of the displacement of A, each with its true
// error; the fast methods take turns and give medians. Global matrices are assembled for the rivals free of charge. Run
// it on one thread.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <iostream>
#include <numeric>
#include <random>

#include <Tpetra_Core.hpp>

#include <harmos/parametric/ParametricStudy.hpp>
#include <harmos/stochastic/DirectSpectral.hpp>
#include <harmos/stochastic/StochasticSolver.hpp>

#include "DirectMonteCarlo.hpp"
#include "PeakMemory.hpp"
#include "Study.hpp"

namespace {

using namespace harmos;
using benchmarks::PointDisplacement;
using benchmarks::RandomGlue;

constexpr int order = 3;
constexpr int gaussPoints = order + 1;
constexpr double draws = 10000;

double cpuSeconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Standard deviations along x and y.
using Deviations = std::array<double, 2>;

double errorOf(const Deviations& found, const Deviations& exact) {
  return std::max(std::abs(found[0] / exact[0] - 1.0), std::abs(found[1] / exact[1] - 1.0));
}

Deviations sampleDeviations(const std::vector<PointDisplacement>& sample) {
  Deviations result{};
  for (std::size_t c = 0; c < 2; ++c) {
    double mean = 0.0, square = 0.0;
    for (const auto& one : sample) mean += one[c] / static_cast<double>(sample.size());
    for (const auto& one : sample) square += std::pow(one[c] - mean, 2);
    result[c] = std::sqrt(square / static_cast<double>(sample.size() - 1));
  }
  return result;
}

/// Standard error of the standard deviation of a sample, relative, the larger of both components.
double samplingError(const std::vector<PointDisplacement>& sample) {
  const Deviations deviations = sampleDeviations(sample);
  double largest = 0.0;
  for (std::size_t c = 0; c < 2; ++c) {
    double mean = 0.0, fourth = 0.0;
    for (const auto& one : sample) mean += one[c] / static_cast<double>(sample.size());
    for (const auto& one : sample) fourth += std::pow((one[c] - mean) / deviations[c], 4);
    fourth /= static_cast<double>(sample.size());
    largest = std::max(largest, std::sqrt((fourth - 1.0) / (4.0 * static_cast<double>(sample.size()))));
  }
  return largest;
}

/// Of the expansions through the displacements at the points of a quadrature.
Deviations expandedDeviations(const stochastic::Projection& projection, const std::vector<PointDisplacement>& values) {
  Deviations result{};
  for (std::size_t c = 0; c < 2; ++c) {
    for (int a = 1; a < projection.terms(); ++a) {
      double coefficient = 0.0;
      for (std::size_t q = 0; q < values.size(); ++q) {
        coefficient += projection.projector()(a, static_cast<int>(q)) * values[q][c];
      }
      result[c] += coefficient * coefficient;
    }
    result[c] = std::sqrt(result[c]);
  }
  return result;
}

struct Run {
  Deviations deviations{};
  double seconds = 0.0;
  double factorSeconds = 0.0;
  int iterations = 0;
  double megabytes = 0.0;
};

double secondsOf(const base::Timers& timers, const std::string& name) {
  for (const auto& phase : timers.phases()) {
    if (phase.name == name) return phase.cpuSeconds;
  }
  return 0.0;
}

Run latinChaos(const RandomGlue& glue, double accuracy) {
  Run run;
  base::Timers timers;
  const auto projection = glue.projection(order, gaussPoints);
  const auto laws = glue.realisations(*projection);
  stochastic::StochasticOptions options;
  options.method = stochastic::Method::galerkin;
  options.accuracy = accuracy;
  options.stages = glue.stages();
  const benchmarks::PeakMemory memory;
  const double begin = cpuSeconds();
  stochastic::StochasticSolver solver(glue.assembly(), projection, options, Tpetra::getDefaultComm(), timers);
  for (const auto& response : glue.responses()) solver.addResponse(response);
  solver.setLaws(laws);
  const auto result = solver.solve();
  for (std::size_t c = 0; c < 2; ++c) run.deviations[c] = result.responses[c].at(0).standardDeviation();
  run.seconds = cpuSeconds() - begin;
  run.factorSeconds = secondsOf(timers, "factor");
  run.iterations = result.iterations;
  run.megabytes = memory.megabytes();
  return run;
}

Run directSpectral(const RandomGlue& glue, stochastic::DirectSpectral::Solver method, double tolerance) {
  Run run;
  base::Timers timers;
  const auto projection = glue.projection(order, gaussPoints);
  const auto laws = glue.realisations(*projection);
  stochastic::DirectSpectral solver(glue.assembly(), projection, laws, glue.stages().solver, timers);
  const benchmarks::PeakMemory memory;
  solver.solve(method, tolerance);
  for (std::size_t c = 0; c < 2; ++c) {
    const base::Matrix coefficients = solver.coefficients(glue.displacement(c));
    for (int a = 1; a < coefficients.numRows(); ++a) run.deviations[c] += std::pow(coefficients(a, 0), 2);
    run.deviations[c] = std::sqrt(run.deviations[c]);
  }
  run.factorSeconds = secondsOf(timers, "factor");
  run.seconds = run.factorSeconds + secondsOf(timers, "solve");
  run.iterations = solver.iterations();
  run.megabytes = memory.megabytes();
  return run;
}

/// The run with the coarsest setting 10^(-n/4) whose true error is at most `target`.
template <class Solve>
double coarsest(const Solve& solve, const Deviations& exact, double target) {
  for (int n = 0; n < 60; ++n) {
    const double setting = std::pow(10.0, -0.25 * n);
    if (errorOf(solve(setting).deviations, exact) <= target) return setting;
  }
  throw base::Error("no setting meets the error " + std::to_string(target));
}

/// The last runs of all methods with the medians of their times. The methods take turns, so that what else the machine
/// does meets all alike.
std::vector<Run> inTurns(int times, const std::vector<std::function<Run()>>& methods) {
  std::vector<Run> runs(methods.size());
  std::vector<std::vector<double>> seconds(methods.size()), factorSeconds(methods.size());
  for (int i = 0; i < times; ++i) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
      runs[m] = methods[m]();
      seconds[m].push_back(runs[m].seconds);
      factorSeconds[m].push_back(runs[m].factorSeconds);
    }
  }
  for (std::size_t m = 0; m < methods.size(); ++m) {
    runs[m].seconds = median(seconds[m]);
    runs[m].factorSeconds = median(factorSeconds[m]);
  }
  return runs;
}

/// The study engine on moduli over their means, from warm starts.
class StudiedDraws : public results::ResultSink {
 public:
  StudiedDraws(const RandomGlue& glue, double accuracy, std::vector<std::vector<double>> factors)
      : factors_(std::move(factors)), values_(factors_.size()), stages_(factors_.size()) {
    assembly::Assembly assembly = glue.assembly();
    latin::LatinOptions options;
    options.accuracy = accuracy;
    options.stages = glue.stages();
    std::vector<design::Configuration> open;
    for (std::size_t i = 0; i < factors_.size(); ++i) open.push_back({static_cast<int>(i) + 1, factors_[i]});
    base::Timers timers;
    const benchmarks::PeakMemory memory;
    const double begin = cpuSeconds();
    parametric::ParametricStudy engine(
        assembly,
        [&](const std::vector<double>& values) {
          const auto laws = glue.laws(values);
          for (std::size_t i = 0; i < laws.size(); ++i) assembly.interfaces[i].law = laws[i];
        },
        glue.responses(), options, Tpetra::getDefaultComm(), timers);
    factorSeconds = cpuSeconds() - begin;
    engine.run(open, *this);
    seconds = cpuSeconds() - begin;
    megabytes = memory.megabytes();
  }

  void record(const results::ConfigurationResult& result) override {
    if (result.curves.empty()) throw base::Error("a draw was not solved: " + result.reason);
    auto& value = values_[result.id - 1];
    for (std::size_t c = 0; c < 2; ++c) value[c] = result.curves[c].back();
    stages_[result.id - 1] = result.linearStages;
  }
  const std::vector<PointDisplacement>& values() const { return values_; }
  double stagesPerDraw() const {
    return std::accumulate(stages_.begin(), stages_.end(), 0.0) / static_cast<double>(stages_.size());
  }

  double factorSeconds = 0.0, seconds = 0.0, megabytes = 0.0;

 private:
  std::vector<std::vector<double>> factors_;
  std::vector<PointDisplacement> values_;
  std::vector<int> stages_;
};

void print(const char* method, double seconds, const std::string& error, double ratio, double megabytes) {
  std::printf("| %s | %.3g | %s | %.3g | %.0f |\n", method, seconds, error.c_str(), ratio, megabytes);
  std::fflush(stdout);
}

std::string text(double error) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.1e", error);
  return buffer;
}

int measure(std::vector<std::string> arguments) {
  const int repeats = static_cast<int>(benchmarks::optionOf(arguments, "--repeats", 5));
  const auto refactored = static_cast<std::size_t>(benchmarks::optionOf(arguments, "--refactored", 200));
  const auto condensedDense = static_cast<std::size_t>(benchmarks::optionOf(arguments, "--condensed", 500));
  const auto studied = static_cast<std::size_t>(benchmarks::optionOf(arguments, "--studied", 300));
  if (arguments.size() != 1) {
    std::cerr << "usage: chaos_rivals xml/glued_assembly.xml [--repeats 5] [--refactored 200] [--condensed 500] "
                 "[--studied 300]\n";
    return 2;
  }
  const RandomGlue glue(arguments[0]);
  using Solver = stochastic::DirectSpectral::Solver;
  const auto latin = [&](double accuracy) { return latinChaos(glue, accuracy); };
  const auto gradients = [&](double tolerance) { return directSpectral(glue, Solver::conjugateGradients, tolerance); };

  const auto factorisation = [&] { return directSpectral(glue, Solver::factorisation, 0.0); };
  const Deviations exact = factorisation().deviations;
  std::printf("standard deviation of u_A: %.9f, %.9f mm\n", exact[0], exact[1]);
  const double accuracy = coarsest(latin, exact, 1e-3), fineAccuracy = coarsest(latin, exact, 1e-5);
  const double tolerance = coarsest(gradients, exact, 1e-3), fineTolerance = coarsest(gradients, exact, 1e-5);
  const std::vector<Run> runs =
      inTurns(repeats, {[&] { return latin(accuracy); }, [&] { return gradients(tolerance); }, factorisation,
                        [&] { return latin(fineAccuracy); }, [&] { return gradients(fineTolerance); }});
  const Run &best = runs[0], &iterated = runs[1], &direct = runs[2], &fine = runs[3], &fineIterated = runs[4];
  std::printf("LATIN: accuracy %.2g, %d iterations, %.3f s of it factor; accuracy %.2g, %d iterations\n", accuracy,
              best.iterations, best.factorSeconds, fineAccuracy, fine.iterations);
  std::printf(
      "conjugate gradients: tolerance %.2g, %d iterations, %.3f s of it factor; tolerance %.2g, %d iterations\n",
      tolerance, iterated.iterations, iterated.factorSeconds, fineTolerance, fineIterated.iterations);
  std::printf("| method | CPU s | error | ratio | MB |\n|---|---|---|---|---|\n");
  const auto row = [&](const char* method, const Run& run, const Run& reference) {
    print(method, run.seconds, text(errorOf(run.deviations, exact)), run.seconds / reference.seconds, run.megabytes);
  };
  row("LATIN chaos", best, best);
  row("direct spectral, conjugate gradients", iterated, best);
  row("direct spectral, factorisation", direct, best);
  row("LATIN chaos, to 1e-5", fine, fine);
  row("conjugate gradients, to 1e-5", fineIterated, fine);

  const auto projection = glue.projection(order, gaussPoints);
  std::vector<std::vector<double>> points;
  for (const auto& germs : projection->quadrature().points) points.push_back(glue.factors(germs));
  std::vector<PointDisplacement> atPoints;

  const benchmarks::GluedMatrices matrices(glue);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<std::vector<double>> factors;
  for (int i = 0; i < static_cast<int>(draws); ++i) {
    const double first = normal(random);
    factors.push_back(glue.factors({first, normal(random)}));
  }

  benchmarks::PeakMemory memory;
  double begin = cpuSeconds();
  benchmarks::CondensedMonteCarlo condensed(glue, matrices);
  const double condensing = cpuSeconds() - begin;
  begin = cpuSeconds();
  double difference = 0.0;
  std::vector<PointDisplacement> dense;
  for (std::size_t i = 0; i < condensedDense; ++i) dense.push_back(condensed.solveDense(factors[i]));
  const double denseSeconds = condensing + (cpuSeconds() - begin) * draws / static_cast<double>(condensedDense);
  begin = cpuSeconds();
  condensed.diagonalise();
  std::vector<PointDisplacement> sample;
  for (const auto& draw : factors) sample.push_back(condensed.solve(draw));
  const double reducedSeconds = condensing + cpuSeconds() - begin;
  const double condensedMegabytes = memory.megabytes();
  for (std::size_t i = 0; i < condensedDense; ++i) {
    for (std::size_t c = 0; c < 2; ++c) {
      difference = std::max(difference, std::abs(dense[i][c] - sample[i][c]) / exact[c]);
    }
  }
  const std::string sampling = text(samplingError(sample)) + " sampling";
  {
    memory = benchmarks::PeakMemory();
    begin = cpuSeconds();
    benchmarks::RefactoringMonteCarlo refactoring(glue, matrices);
    const double once = cpuSeconds() - begin;
    begin = cpuSeconds();
    for (std::size_t i = 0; i < refactored; ++i) {
      const PointDisplacement found = refactoring.solve(factors[i]);
      for (std::size_t c = 0; c < 2; ++c) {
        difference = std::max(difference, std::abs(found[c] - sample[i][c]) / exact[c]);
      }
    }
    const double seconds = once + (cpuSeconds() - begin) * draws / static_cast<double>(refactored);
    print("Monte Carlo, each draw factored", seconds, sampling, seconds / best.seconds, memory.megabytes());
  }
  {
    begin = cpuSeconds();
    for (const auto& point : points) atPoints.push_back(condensed.solveDense(point));
    const double seconds = condensing + cpuSeconds() - begin;
    const Deviations found = expandedDeviations(*projection, atPoints);
    print("16 Gauss points, one factor and a dense solve of the jumps", seconds, text(errorOf(found, exact)),
          seconds / best.seconds, condensedMegabytes);
  }
  print("Monte Carlo, one factor and a dense solve of the jumps", denseSeconds, sampling, denseSeconds / best.seconds,
        condensedMegabytes);
  print("Monte Carlo, the same in eigenvectors", reducedSeconds, sampling, reducedSeconds / best.seconds,
        condensedMegabytes);

  // The same equations at the same points decide what the iterations of LATIN leave.
  const std::vector<std::vector<double>> some(factors.begin(), factors.begin() + static_cast<std::ptrdiff_t>(studied));
  const Deviations someExact =
      sampleDeviations({sample.begin(), sample.begin() + static_cast<std::ptrdiff_t>(studied)});
  for (const double studyAccuracy : {1e-2, 1e-3, 1e-4, 1e-5}) {
    const StudiedDraws study(glue, studyAccuracy, some);
    const double error = errorOf(sampleDeviations(study.values()), someExact);
    if (error > 1e-3 && studyAccuracy > 1e-5) continue;
    const double seconds =
        study.factorSeconds + (study.seconds - study.factorSeconds) * draws / static_cast<double>(some.size());
    print("Monte Carlo by LATIN, warm starts", seconds, text(error) + "; " + sampling, seconds / best.seconds,
          study.megabytes);
    std::printf("  accuracy %g, %.1f linear stages per draw\n", studyAccuracy, study.stagesPerDraw());
    break;
  }
  const Deviations exactCollocation = expandedDeviations(*projection, atPoints);
  for (const double studyAccuracy : {1e-2, 1e-3, 1e-4, 1e-5}) {
    const StudiedDraws study(glue, studyAccuracy, points);
    const double error = errorOf(expandedDeviations(*projection, study.values()), exactCollocation);
    if (error > 1e-3 && studyAccuracy > 1e-5) continue;
    print("collocation by LATIN, 16 points", study.seconds, text(error), study.seconds / best.seconds, study.megabytes);
    std::printf("  accuracy %g, %.1f linear stages per point\n", studyAccuracy, study.stagesPerDraw());
    break;
  }
  std::printf(
      "direct methods among each other: %.1e of the standard deviation; glues coupled by rank %d of %d jumps; "
      "condensing %.2f s\n",
      difference, condensed.rank(), condensed.jumps(), condensing);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return harmos::benchmarks::runProgram(argc, argv, measure);
}
