#pragma once

#include <string>
#include <vector>

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

#include <harmos/latin/LatinResult.hpp>
#include <harmos/laws/LocalLine.hpp>
#include <harmos/mesh/Mesh.hpp>

#include "SceneInput.hpp"

namespace harmos::verification {

/// A pair of nodes of an interface at one load step, in the frame (n, t1, t2).
struct PairValue {
  base::Vector3 position{};  ///< [length], of side 1
  double area = 0.0;         ///< [area]
  base::Vector3 traction{};  ///< on side 1 [stress]
  base::Vector3 jump{};      ///< w2 - w1 [length]
  laws::Status status = laws::Status::bonded;
};

struct NodeValue {
  int meshNode = 0;
  base::Vector3 displacement{};  ///< [length]
};

/// A scene that was solved. Collective over the communicator, by default that of all processes; everything is complete
/// on every rank.
class SolvedScene {
 public:
  explicit SolvedScene(const SceneInput& input);
  SolvedScene(const SceneInput& input, const Teuchos::RCP<const Teuchos::Comm<int>>& comm);

  latin::LatinResult result;
  bool isCertified() const { return result.outcome == latin::Outcome::certified; }

  int steps() const { return static_cast<int>(pairs_.size()); }
  /// A response at all load steps.
  const std::vector<double>& values(const std::string& response) const;
  /// A response at a load step; -1: the last.
  double value(const std::string& response, int step = -1) const;
  /// The pairs of an interface, of all its pieces; step -1: the last.
  std::vector<PairValue> pairs(const std::string& interface, int step = -1) const;
  /// Displacement of every node of every body at the last load step; nodes on cuts occur several times.
  const std::vector<NodeValue>& displacements() const { return displacements_; }

 private:
  struct NamedPair {
    int interface = 0;  // position in names_
    PairValue value;
  };
  std::vector<std::string> names_;
  std::vector<std::vector<NamedPair>> pairs_;  // per load step
  std::vector<NodeValue> displacements_;
};

/// Largest distance of the displacements of two runs on the same mesh, relative to the largest displacement.
double displacementDifference(const SolvedScene& run, const SolvedScene& reference);

}  // namespace harmos::verification
