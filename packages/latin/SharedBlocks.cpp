#include <harmos/latin/detail/SharedBlocks.hpp>

#include <algorithm>
#include <list>
#include <numeric>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/ShareOut.hpp>
#include <harmos/latin/detail/LargestOf.hpp>

namespace harmos::latin {
namespace {

// Reading a factor once takes as long as computing with it for so many columns.
constexpr double columnsOfReading = 3.0;
// Entries from which on a block is worth its messages.
constexpr std::size_t worthSending = 300000;
// Of the largest load: what sharing must take away to be worth its messages.
constexpr double leastGain = 0.1;
// Right-hand sides, of all bodies of a block, that travel together.
constexpr int columnsTogether = 128;

}  // namespace

SharedBlocks::SharedBlocks(const std::vector<std::unique_ptr<OperatorGroup>>& groups, const std::vector<int>& bodies,
                           const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
    : comm_(comm), rank_(comm->getRank()), gives_(groups.size(), false) {
  if (comm->getSize() == 1) return;
  shareOut(collect(groups, bodies));
  sendFactors();
}

std::vector<double> SharedBlocks::collect(const std::vector<std::unique_ptr<OperatorGroup>>& groups,
                                          const std::vector<int>& bodies) {
  std::vector<Block> own;
  double besides = 0.0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const auto costOf = [&](std::size_t entries) {
      return static_cast<double>(entries) * (columnsOfReading + bodies[g]);
    };
    const auto factors = groups[g]->singleFactors();
    if (factors.empty()) besides += costOf(groups[g]->entries());
    for (std::size_t part = 0; part < factors.size(); ++part) {
      const std::size_t entries = factors[part]->traceEntries();
      own.push_back({rank_, rank_, static_cast<int>(g), static_cast<int>(part), factors[part]->traceRows(), bodies[g],
                     costOf(entries), entries >= worthSending, factors[part], std::nullopt});
    }
  }
  const int count = static_cast<int>(own.size());
  std::vector<int> counts(static_cast<std::size_t>(comm_->getSize()));
  Teuchos::gatherAll(*comm_, 1, &count, comm_->getSize(), counts.data());
  const int first = std::accumulate(counts.begin(), counts.begin() + rank_, 0);
  const int all = std::accumulate(counts.begin(), counts.end(), 0);
  // One row for each number that tells about a block, one column for each block.
  base::Matrix mine(7, all), sum(7, all);
  for (int i = 0; i < count; ++i) {
    const Block& block = own[i];
    const double told[] = {static_cast<double>(block.owner),  static_cast<double>(block.group),
                           static_cast<double>(block.part),   static_cast<double>(block.rows),
                           static_cast<double>(block.bodies), block.cost,
                           block.mayBeGiven ? 1.0 : 0.0};
    std::copy(std::begin(told), std::end(told), mine[first + i]);
  }
  if (all > 0) Teuchos::reduceAll(*comm_, Teuchos::REDUCE_SUM, 7 * all, mine.values(), sum.values());
  for (int i = 0; i < all; ++i) {
    const double* const told = sum[i];
    const auto whole = [told](int row) { return static_cast<int>(told[row]); };
    const bool isOwn = i >= first && i < first + count;
    blocks_.push_back({whole(0), whole(0), whole(1), whole(2), whole(3), whole(4), told[5], told[6] > 0.0,
                       isOwn ? own[i - first].factor : nullptr, std::nullopt});
  }
  std::vector<double> besidesOfAll(counts.size());
  Teuchos::gatherAll(*comm_, 1, &besides, comm_->getSize(), besidesOfAll.data());
  return besidesOfAll;
}

void SharedBlocks::shareOut(const std::vector<double>& besides) {
  std::vector<double> cost, load(besides), shared(besides);
  std::vector<int> owner;
  std::vector<Block*> movable;
  for (Block& block : blocks_) {
    load[block.owner] += block.cost;
    if (!block.mayBeGiven) {
      shared[block.owner] += block.cost;
      continue;
    }
    cost.push_back(block.cost);
    owner.push_back(block.owner);
    movable.push_back(&block);
  }
  const std::vector<int> solver = base::shareOut(cost, shared, owner);
  for (std::size_t i = 0; i < cost.size(); ++i) shared[solver[i]] += cost[i];
  if (largest(shared) > (1.0 - leastGain) * largest(load)) return;
  int bodies = 1;
  for (std::size_t i = 0; i < movable.size(); ++i) {
    Block& block = *movable[i];
    if (solver[i] == block.owner) continue;
    block.solver = solver[i];
    if (block.owner == rank_) gives_[block.group] = true;
    bodies = std::max(bodies, block.bodies);
    ++given_;
  }
  columnsAtOnce_ = std::max(1, columnsTogether / bodies);
}

void SharedBlocks::sendFactors() {
  for (Block& block : blocks_) {
    if (block.owner == block.solver) continue;
    if (block.owner == rank_) {
      block.factor->send(*comm_, block.solver);
      block.factor = nullptr;
    } else if (block.solver == rank_) {
      block.otherFactor = substructure::SingleFactor::receive(*comm_, block.owner);
      block.factor = &*block.otherFactor;
    }
  }
}

void SharedBlocks::solve(Parts& parts, int columns, const std::function<void()>& meanwhile) const {
  const auto isHere = [this](const Block& block) { return block.solver == rank_; };
  const auto isOwn = [this](const Block& block) { return block.owner == rank_ && gives_[block.group]; };
  const auto part = [&parts](const Block& block) -> base::Matrix& { return parts[block.group][block.part]; };
  const auto sizeOf = [columns](const Block& block) { return block.rows * block.bodies * columns; };
  using Requests = Teuchos::Array<Teuchos::RCP<Teuchos::CommRequest<int>>>;
  Requests rightSides, solutions;
  const auto send = [this](const base::Matrix& matrix, int rank, Requests& requests) {
    const auto count = static_cast<Teuchos_Ordinal>(matrix.numRows()) * matrix.numCols();
    const Teuchos::ArrayRCP<const double> values(matrix.values(), 0, count, false);
    requests.push_back(Teuchos::isend<int, double>(*comm_, values, rank));
  };
  // All ranks visit the blocks in the same order, so that messages between two of them match without tags.
  for (const Block& block : blocks_) {
    if (isOwn(block) && !isHere(block)) send(part(block), block.solver, rightSides);
  }
  base::Matrix solution;
  for (const Block& block : blocks_) {
    if (!isOwn(block) || !isHere(block)) continue;
    solution.shapeUninitialized(block.rows, block.bodies * columns);
    block.factor->solveTrace(part(block), solution);
    part(block).swap(solution);
  }
  meanwhile();
  std::list<base::Matrix> solved;  // for others; stay where they are until they have arrived
  for (const Block& block : blocks_) {
    if (block.owner == rank_ || !isHere(block)) continue;
    base::Matrix right;
    right.shapeUninitialized(block.rows, block.bodies * columns);
    solution.shapeUninitialized(block.rows, block.bodies * columns);
    Teuchos::receive(*comm_, block.owner, sizeOf(block), right.values());
    block.factor->solveTrace(right, solution);
    solved.emplace_back();
    solved.back().swap(solution);
    send(solved.back(), block.owner, solutions);
  }
  Teuchos::waitAll(*comm_, rightSides());  // in whose place solutions come
  for (const Block& block : blocks_) {
    if (isOwn(block) && !isHere(block)) Teuchos::receive(*comm_, block.solver, sizeOf(block), part(block).values());
  }
  Teuchos::waitAll(*comm_, solutions());
}

}  // namespace harmos::latin
