#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/detail/OperatorGroup.hpp>
#include <harmos/substructure/SingleFactor.hpp>

namespace harmos::latin {

/// Which rank solves for which blocks of the operators of all ranks in single precision, and what travels between them.
///
/// A block is what of an operator is even or odd about the same mirror planes, or all of it without such planes; it is
/// solved for all bodies that share the operator. Where ranks with the bodies they own have unequally much to solve,
/// those with more give blocks to others: the factors once, right-hand sides and solutions at each solve. So two ranks
/// with three like plates, of which two have one operator, solve for a half of these two and for two quarters of the
/// third each, if it has two planes. What is exact is solved by the owner alone, which keeps its factors.
class SharedBlocks {
 public:
  /// Right-hand sides of the groups of this rank, or their solutions: for each group its blocks in the order of
  /// SubstructureSolver::split(); none for groups that do not give away any.
  using Parts = std::vector<std::vector<base::Matrix>>;

  /// Collective: finds out what all ranks have to solve, shares it out and sends factors. `groups`: the operators of
  /// this rank, whose factors in single precision are ready; they must outlive it and not be factored anew. `bodies`:
  /// that share each of them.
  SharedBlocks(const std::vector<std::unique_ptr<OperatorGroup>>& groups, const std::vector<int>& bodies,
               const Teuchos::RCP<const Teuchos::Comm<int>>& comm);

  /// Blocks that are not solved by the rank of their bodies, of all ranks.
  int given() const { return given_; }
  /// Whether a group of this rank gives any away, so that solve() is for it.
  bool gives(std::size_t group) const { return gives_[group]; }
  /// Columns of each body that should be solved for together at most.
  int columnsAtOnce() const { return columnsAtOnce_; }

  /// Collective. Puts solutions in the place of right-hand sides, of which each body has so many columns, the same on
  /// all ranks; blocks that other ranks have given are solved for as well. `meanwhile` is called once, while messages
  /// travel.
  void solve(Parts& parts, int columns, const std::function<void()>& meanwhile) const;

 private:
  struct Block {
    int owner, solver;  // ranks
    int group, part;    // of the owner
    int rows, bodies;
    double cost;                                            // about proportional to the time of a solve
    bool mayBeGiven;                                        // is worth the messages
    const substructure::SingleFactor* factor;               // null: is not solved here
    std::optional<substructure::SingleFactor> otherFactor;  // of another rank
  };

  /// Finds the blocks of all ranks; returns the costs of what else each rank solves for in the same stage.
  std::vector<double> collect(const std::vector<std::unique_ptr<OperatorGroup>>& groups,
                              const std::vector<int>& bodies);
  void shareOut(const std::vector<double>& besides);
  void sendFactors();

  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  int rank_;
  std::vector<Block> blocks_;  // of all ranks, in the same order on each
  std::vector<bool> gives_;    // of groups of this rank
  int given_ = 0;
  int columnsAtOnce_ = 0;
};

}  // namespace harmos::latin
