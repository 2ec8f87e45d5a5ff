#pragma once

#include <set>
#include <string>
#include <vector>

#include <harmos/input/Parameters.hpp>
#include <harmos/mesh/TouchingParts.hpp>

namespace harmos::scene {

/// Whether a name stands for all parts that it fits: * for any characters, ? for one.
bool isPattern(const std::string& name);
/// Those of `names` that a pattern fits, in their order; the name itself where it is none.
std::vector<std::string> fittingNames(const std::string& pattern, const std::vector<std::string>& names);

/// Names of the parts on which a side set lies; none if there is no such set.
std::set<std::string> partsOf(const std::string& sideSet, const mesh::Mesh& mesh,
                              const std::vector<mesh::Piece>& pieces);

/// Which parts every interface joins whose Part 1 or Part 2 is a pattern.
///
/// All pairs of parts that fit and have faces on each other, but those that another interface names, by parts or by
/// side sets, and those of a pattern before it. Keeps references to its arguments.
class PartPairs {
 public:
  PartPairs(const input::Parameters& scene, const mesh::Mesh& mesh, const std::vector<mesh::Piece>& pieces);

  /// The pairs of an interface given by parts, to be asked in the order of the list Interfaces. Throws
  /// base::Error(input) if there is none.
  std::vector<mesh::PartPair> of(const input::Parameters& interface);

 private:
  const mesh::Mesh& mesh_;
  const std::vector<mesh::Piece>& pieces_;
  std::vector<std::string> parts_;
  std::set<mesh::PartPair> taken_;  // the lesser name first
};

}  // namespace harmos::scene
