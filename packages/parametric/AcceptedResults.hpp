#pragma once

#include <map>
#include <vector>

#include <harmos/design/Configuration.hpp>
#include <harmos/parametric/Delivery.hpp>
#include <harmos/results/ResultSink.hpp>

namespace harmos::parametric {

/// What was accepted by its indicators, to be looked at again whenever a ratio falls.
class AcceptedResults {
 public:
  /// Both must outlive it.
  AcceptedResults(const Calibration& calibration, const Delivery& delivery)
      : calibration_(calibration), delivery_(delivery) {}

  /// A result that its evidence says to have been accepted; replaces one of the same id.
  void add(const design::Configuration& configuration, const results::ConfigurationResult& result);
  /// A result that another run has withdrawn and not taken up again: only what it has cost counts.
  void addWithdrawn(const results::ConfigurationResult& result) { withdrawn_[result.id] = result; }
  /// Replaces the result of this id, if there is one.
  void update(const results::ConfigurationResult& result);
  /// What is known of a configuration that is taken up again, and is then accepted no more; empty: nothing.
  results::ConfigurationResult take(int id);
  /// After a ratio fell: records new estimates, and what they do not cover any more as reopened. Returns the
  /// configurations that are to be taken up again.
  std::vector<design::Configuration> review(results::ResultSink& sink);

 private:
  struct Accepted {
    design::Configuration configuration;
    results::ConfigurationResult result;
    bool isReopened = false;  // a ratio fell since
  };

  const Calibration& calibration_;
  const Delivery& delivery_;
  std::map<int, Accepted> accepted_;  // by id
  std::map<int, results::ConfigurationResult> withdrawn_;
};

}  // namespace harmos::parametric
