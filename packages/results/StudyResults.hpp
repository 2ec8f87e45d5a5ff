#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <harmos/results/ConfigurationResult.hpp>
#include <harmos/results/Note.hpp>
#include <harmos/results/StochasticSummary.hpp>
#include <harmos/results/StudyDescription.hpp>

/// What is known of a study: results of configurations, statistics, and surfaces through them.
namespace harmos::results {

/// What is known so far of the configurations of a study.
class StudyResults {
 public:
  /// `description` must outlive the results.
  explicit StudyResults(const StudyDescription& description);

  /// As given.
  const StudyDescription& description() const { return description_; }
  /// Those of the description and those that were added since.
  const std::vector<design::Configuration>& configurations() const { return configurations_; }
  /// Adds a configuration that an adaptive design has chosen; its id must be the next one, else it is known already.
  void add(const design::Configuration& configuration);
  /// Replaces what was known of this configuration; ids that the study does not have are ignored.
  void set(const ConfigurationResult& result);
  /// Null while the configuration with this id is open; 1 <= id <= number of configurations. Valid until the next set()
  /// or add().
  const ConfigurationResult* find(int id) const;
  /// How many configurations have a result.
  int count() const { return count_; }
  /// How many have a result with this status.
  int count(Status status) const;
  /// How many are as accurate as asked for.
  int solved() const;
  /// The scalar responses of a configuration, in the order of the description: of its solution, if it has one as
  /// accurate as asked for, else what the study wants in its place, else not a number, as while it is open or open
  /// again.
  std::vector<double> responses(int id) const;
  /// Replaces the note of this name.
  void note(const std::string& name, const Note& note) { notes_[name] = note; }
  /// About the study as a whole, by name.
  const std::map<std::string, Note>& notes() const { return notes_; }
  /// Whether a note says that the study falls short of what was asked for.
  bool fallsShort() const;
  /// What a study with random parameters has come to; null before its end and in other studies.
  void setStatistics(std::shared_ptr<const StochasticSummary> statistics) { statistics_ = std::move(statistics); }
  /// What setStatistics() was given, else null.
  const StochasticSummary* statistics() const { return statistics_.get(); }
  /// The results that are known, in the order of their ids.
  std::vector<ConfigurationResult> all() const;

 private:
  const StudyDescription& description_;
  std::vector<design::Configuration> configurations_;
  std::vector<std::optional<ConfigurationResult>> results_;  // by id - 1
  int count_ = 0;
  std::map<std::string, Note> notes_;
  std::shared_ptr<const StochasticSummary> statistics_;
};

}  // namespace harmos::results
