#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <harmos/design/Plan.hpp>
#include <harmos/input/InputTree.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/parametric/CalibratedSchedule.hpp>
#include <harmos/results/ScalarResponse.hpp>
#include <harmos/scene/Scene.hpp>
#include <harmos/study/FailurePolicy.hpp>
#include <harmos/study/StochasticPlan.hpp>
#include <harmos/study/StudyDesign.hpp>
#include <harmos/study/StudyParameters.hpp>

/// Studies: many configurations of one scene, their random parameters, teams of ranks, and what comes of them.
namespace harmos::study {

/// What is computed from expansions and samples.
struct StatisticsOptions {
  std::vector<double> levels;  // of quantiles
  int samples = 0;             // points at which expansions are sampled
  int seed = 0;                // of these
};

/// A checked study: its scene, parameters and all configurations (of an adaptive design the first
/// ones); all that can be known before a mesh is read.
struct Study {
  std::string path;                        // of the study's file
  input::Parameters input;                 // all defaults filled in; what is to be done stands in the members below
  std::string title;                       // in the words of the input
  StudyDesign design;                      // which configurations there are
  FailurePolicy policy;                    // what is done with those without a solution
  StatisticsOptions statistics;            // of random parameters
  std::string pointsFile;                  // of a listed design, else empty
  input::InputTree sceneTree;              // the scene with the changes that hold for the whole study
  scene::Scene scene;                      // made of it, with the values that it has itself
  std::vector<StudyParameter> parameters;  // in the order of the list Parameters, derived ones included
  std::vector<design::Configuration> configurations;             // by id, from 1; values in the order of `parameters`
  std::vector<std::pair<std::string, int>> leftOut;              // how many, by name of condition
  std::vector<results::ScalarResponse> responses;                // in the order of the list Responses
  int sideBySide = parametric::CalibratedSchedule::usualWidest;  // configurations that march so at most
  std::shared_ptr<design::Plan> plan;                            // completes further points
  std::shared_ptr<const StochasticPlan> stochastic;  // null when no parameter is random, or points are listed

  /// Whether the design chooses points as results come.
  bool isAdaptive() const;
  /// Whether expansions are solved for, rather than configurations.
  bool isChaos() const { return stochastic && stochastic->method == StochasticPlan::Method::chaos; }
  /// The scene for values of all parameters, in their order and units. Throws base::Error (input) when they are not
  /// admissible.
  scene::Scene sceneFor(const std::vector<double>& values, const laws::LawRegistry& laws) const;
};

/// The files that `study` is read from: its own, those of its scene, points and samples.
std::vector<std::string> inputFiles(const Study& study);

}  // namespace harmos::study
