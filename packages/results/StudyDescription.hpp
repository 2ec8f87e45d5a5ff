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
  struct Parameter {
    std::string name;
    std::string unit;
    std::string formula;               // of a derived parameter, else empty
    std::vector<std::string> entries;  // of the scene that it sets
    std::string phase;                 // what a new value of it makes invalid, in words
  };

  std::string name;  // of the group in the file
  std::string title;
  std::string scene;  // path as given
  double accuracy = 0.0;
  std::vector<Parameter> parameters;
  std::vector<design::Configuration> configurations;  // to begin with; id = position + 1
  std::vector<std::string> curves;                    // names of the scene's responses
  std::vector<double> times;                          // of the load steps
  std::vector<ScalarResponse> responses;
  std::vector<double> recovery;  // in place of the responses where there is no solution; empty: not a number
  std::vector<std::pair<std::string, int>> leftOut;  // by condition
  std::string studyInput, sceneInput;                // XML, all defaults filled in
  Identity identity;                                 // of both inputs and of the files that they name
};

}  // namespace harmos::results
