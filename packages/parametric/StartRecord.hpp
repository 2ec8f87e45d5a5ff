#pragma once

#include <limits>
#include <vector>

namespace harmos::parametric {

/// Tells from what was paid before in the same study whether a configuration should start from its neighbours.
///
/// Neighbours that are far away cost more than they save: the iteration first has to get rid of their contact status.
/// How far that is depends on scene and study. A warm start is favoured while the last of those at the same distance or
/// nearer took fewer linear stages on average than cold starts, or where hardly any were tried; now and then one is
/// tried again, at first more often. The same on every rank.
class StartRecord {
 public:
  /// A warm start at this distance [-], see SolvedStates::distance(): linear stages until the configuration was solved,
  /// those of a cold start included where the warm one had to be given up.
  void addWarm(double distance, int stages) { warm_.push_back({distance, stages}); }
  /// Linear stages of a configuration that was solved from nothing.
  void addCold(int stages);
  /// Whether a warm start at this distance [-] should be made; asked once for every configuration that could have one.
  bool favoursWarm(double distance);
  /// Mean linear stages of cold starts; infinite before the first.
  double coldStages() const {
    return coldRuns_ == 0 ? std::numeric_limits<double>::infinity() : static_cast<double>(coldSum_) / coldRuns_;
  }

 private:
  struct Warm {
    double distance;
    int stages;
  };

  std::vector<Warm> warm_;
  int coldSum_ = 0;
  int coldRuns_ = 0;
  int refused_ = 0;   // since a warm start was tried last against the record
  int patience_ = 8;  // refusals until the next
};

}  // namespace harmos::parametric
