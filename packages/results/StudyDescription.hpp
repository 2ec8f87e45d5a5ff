#pragma once

#include <string>
#include <utility>
#include <vector>

#include <harmos/design/Configuration.hpp>
#include <harmos/results/ScalarResponse.hpp>

namespace harmos::results {

/// A named text per entry of an input, by which two inputs are compared.
using Identity = std::vector<std::pair<std::string, std::string>>;

/// What a study is about; everything in its files that is known before the first solution.
struct StudyDescription {
  /// One parameter of the study.
  struct Parameter {
    std::string name;                  // as in formulas and tables
    std::string unit;                  // as the user has written it; empty when not given
    std::string formula;               // of a derived parameter, else empty
    std::vector<std::string> entries;  // of the scene that it sets
    std::string phase;                 // what a new value of it makes invalid, in words
  };

  std::string name;                                   // of the group in the file
  std::string title;                                  // as in the input
  std::string scene;                                  // path as given
  double accuracy = 0.0;                              // relative error that is asked for
  std::vector<Parameter> parameters;                  // in the order of Configuration::values
  std::vector<design::Configuration> configurations;  // to begin with; id = position + 1
  std::vector<std::string> curves;                    // names of the scene's responses
  std::vector<double> times;                          // ends of the load steps
  std::vector<ScalarResponse> responses;              // scalar ones, of every configuration
  std::vector<double> recovery;  // in place of the responses where there is no solution; empty: not a number
  std::vector<std::pair<std::string, int>> leftOut;  // points of the design, by the condition that leaves them out
  /// XML of the study, all defaults filled in.
  std::string studyInput, sceneInput;  // the same of the scene
  Identity identity;                   // of both inputs and of the files that they name
};

}  // namespace harmos::results
