#pragma once

#include <limits>
#include <string>
#include <vector>

#include <harmos/results/Evidence.hpp>
#include <harmos/results/MeshErrorRecord.hpp>

namespace harmos::results {

/// How the solution of one configuration ended.
enum class Status {
  certified,            // two corrections of its own bound its error
  certifiedNotUnique,   // the same, but the problem does not determine all responses; see the reason
  calibrated,           // its free indicators, calibrated on certified configurations, are below the request
  calibratedNotUnique,  // the same, but the problem does not determine all responses; see the reason
  reopened,             // it was calibrated, but what was learned since does not cover it: to be taken up again
  notConverged,         // the request was not met
  noEquilibrium,        // the interface laws cannot carry the loads
  failed,               // something threw; see the reason
  inadmissible          // its parameters violate a range of the scene
};

/// What is known about one configuration; the curves are those of the scene's responses.
struct ConfigurationResult {
  int id = 0;                               // of the design::Configuration, from 1
  Status status = Status::failed;           // how it ended
  std::string reason;                       // why, one sentence
  std::vector<std::vector<double>> curves;  // [response][load step], in their units; empty without a solution
  std::vector<double> curveErrors;          // per response, estimate of the relative error; NaN: none
  /// Relative; the largest of the responses and of the field of interface forces; only a certificate also covers the
  /// field of displacements. NaN: none.
  double errorEstimate = std::numeric_limits<double>::quiet_NaN();
  int iterations = 0;       // of LATIN; of a calibrated configuration marches
  int linearStages = 0;     // whatever for
  std::vector<int> starts;  // ids of the configurations whose solutions it started from; empty: cold
  double cpuSeconds = 0.0;  // of one process of its team [s]
  std::vector<MeshErrorRecord> meshErrors = {};  // at a few configurations; empty: not estimated
  Evidence evidence = {};                        // of studies with calibrated estimates
};

}  // namespace harmos::results
