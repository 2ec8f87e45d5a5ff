#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <harmos/output/StudyDescription.hpp>
#include <harmos/study/ConfigurationResult.hpp>
#include <harmos/study/StochasticSummary.hpp>

namespace harmos::output {

/// What is known so far of the configurations of a study.
class StudyResults {
 public:
  /// `description` must outlive the results.
  explicit StudyResults(const StudyDescription& description);

  const StudyDescription& description() const { return description_; }
  /// Those of the description and those that were added since.
  const std::vector<study::Configuration>& configurations() const { return configurations_; }
  /// Adds a configuration that an adaptive design has chosen; its id must be the next one, else it is known already.
  void add(const study::Configuration& configuration);
  /// Replaces what was known of this configuration; ids that the study does not have are ignored.
  void set(const study::ConfigurationResult& result);
  /// Null while the configuration with this id is open.
  const study::ConfigurationResult* find(int id) const;
  int count() const { return count_; }
  int count(study::Status status) const;
  /// The scalar responses of a configuration: of its solution, if it has one as accurate as asked for, else what the
  /// study wants in its place, else not a number.
  std::vector<double> responses(int id) const;
  void note(const std::string& name, const std::string& text) { notes_[name] = text; }
  const std::map<std::string, std::string>& notes() const { return notes_; }
  /// What a study with random parameters has come to; null before its end and in other studies.
  void setStatistics(std::shared_ptr<const study::StochasticSummary> statistics) {
    statistics_ = std::move(statistics);
  }
  const study::StochasticSummary* statistics() const { return statistics_.get(); }
  /// In the order of their ids.
  std::vector<study::ConfigurationResult> all() const;

 private:
  const StudyDescription& description_;
  std::vector<study::Configuration> configurations_;
  std::vector<std::optional<study::ConfigurationResult>> results_;  // by id - 1
  int count_ = 0;
  std::map<std::string, std::string> notes_;
  std::shared_ptr<const study::StochasticSummary> statistics_;
};

}  // namespace harmos::output
