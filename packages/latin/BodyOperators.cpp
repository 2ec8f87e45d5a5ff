#include <harmos/latin/BodyOperators.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <harmos/latin/detail/BodyTerm.hpp>
#include <harmos/latin/detail/GivenLoads.hpp>
#include <harmos/latin/detail/IsZero.hpp>
#include <harmos/latin/detail/OperatorGroup.hpp>
#include <harmos/latin/detail/SharedBlocks.hpp>

namespace harmos::latin {
namespace {

/// to += Q from (or Q^T from) for the components of one node.
void addRotated(const base::Frame& q, bool transposed, int dimension, const double* from, double* to) {
  base::Vector3 x{};
  std::copy(from, from + dimension, x.begin());
  const base::Vector3 y = transposed ? base::toGlobal(q, x) : base::toFrame(q, x);
  for (int c = 0; c < dimension; ++c) to[c] += y[c];
}

}  // namespace

BodyOperators::BodyOperators(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
                             const TraceLayout& layout, const EliminatedBoundaries& eliminated,
                             const substructure::SolverOptions& options, base::Timers& timers)
    : eliminated_(eliminated),
      dimension_(assembly.dimension),
      cases_(assembly.loadCases()),
      places_(assembly.bodies.size()),
      held_(assembly.bodies.size()) {
  const auto running = timers.start("factor");
  std::vector<int> masters;
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b) {
    const substructure::Substructure& body = assembly.bodies[b];
    if (!layout.owns(static_cast<int>(b))) continue;
    Place& place = places_[b];
    int master = static_cast<int>(b);
    if (body.congruence) {
      master = body.congruence->representative;
      place.rotates = true;
      place.rotation = body.congruence->rotation;
      place.toMaster = body.congruence->toRepresentative();
    }
    substructure::BoundaryTerm term = bodyTerm(assembly, searchDirection, eliminated, static_cast<int>(b),
                                               place.toMaster, place.rotates ? &place.rotation : nullptr);
    for (std::size_t g = 0; g < groups_.size() && place.group < 0; ++g) {
      if (masters[g] == master && groups_[g]->has(term, body.iterates)) place.group = static_cast<int>(g);
    }
    if (place.group < 0) {
      place.group = static_cast<int>(groups_.size());
      groups_.push_back(std::make_unique<OperatorGroup>(body, assembly.bodies[master], std::move(term), options));
      members_.emplace_back();
      masters.push_back(master);
    }
    place.member = static_cast<int>(members_[place.group].size());
    members_[place.group].push_back(static_cast<int>(b));
  }
  mapBlocks(assembly, layout);
  updateLoads(assembly);
}

BodyOperators::~BodyOperators() = default;

void BodyOperators::mapBlocks(const assembly::Assembly& assembly, const TraceLayout& layout) {
  for (const TraceLayout::Block& block : layout.blocks()) {
    const Place& place = places_[block.body];
    BlockMap map{&place, block.begin, {}};
    const mesh::TraceOperator& trace = assembly.interfaces[block.interface].trace(block.side);
    for (int p = 0; p < trace.points(); ++p) {
      std::vector<mesh::TraceOperator::Entry> row;
      for (const auto& [node, weight] : trace.row(p)) {
        row.push_back({groups_[place.group]->rowOf(masterDof(place, node)), weight});
      }
      map.trace.append(row);
    }
    blocks_.push_back(std::move(map));
  }
}

void BodyOperators::toGroup(const Place& place, const base::Matrix& own, base::Matrix& group) const {
  for (int t = 0; t < own.numCols(); ++t) {
    for (int node = 0; node < own.numRows() / dimension_; ++node) {
      const double* from = own[t] + node * dimension_;
      double* to = group[place.member * own.numCols() + t] + masterDof(place, node);
      if (place.rotates) {
        addRotated(place.rotation, true, dimension_, from, to);
      } else {
        for (int c = 0; c < dimension_; ++c) to[c] += from[c];
      }
    }
  }
}

void BodyOperators::fromGroup(const Place& place, const base::Matrix& group, base::Matrix& own) const {
  for (int t = 0; t < own.numCols(); ++t) {
    for (int node = 0; node < own.numRows() / dimension_; ++node) {
      const double* from = group[place.member * own.numCols() + t] + masterDof(place, node);
      double* to = own[t] + node * dimension_;
      if (place.rotates) {
        std::fill_n(to, dimension_, 0.0);
        addRotated(place.rotation, false, dimension_, from, to);
      } else {
        std::copy_n(from, dimension_, to);
      }
    }
  }
}

void BodyOperators::updateLoads(const assembly::Assembly& assembly) {
  const int cases = assembly.loadCases();
  std::vector<bool> owned;
  for (const Place& place : places_) owned.push_back(place.group >= 0);
  auto given = std::make_unique<GivenLoads>(assembly, eliminated_, reference_, owned);
  const bool hasBodyForces = std::any_of(assembly.bodies.begin(), assembly.bodies.end(),
                                         [](const auto& body) { return body.loads.numCols() > 0; });
  // Laws are replaced far more often than loads change.
  if (!hasBodyForces && cases_ == cases && given_ && *given_ == *given) return;
  std::vector<base::Matrix> loads(places_.size()), held(places_.size());
  for (std::size_t b = 0; b < places_.size(); ++b) {
    const base::Matrix& forces = assembly.bodies[b].loads;
    if (!owned[b] || forces.numCols() == 0) continue;
    loads[b].shape(forces.numRows(), cases);
    for (int t = 0; t < forces.numCols(); ++t) std::copy_n(forces[t], forces.numRows(), loads[b][t]);
  }
  given->addTo(assembly, eliminated_, loads, held);
  cases_ = cases;
  setLoads(std::move(loads), std::move(held));
  if (!hasBodyForces) given_ = std::move(given);
}

void BodyOperators::setLoads(std::vector<base::Matrix> loads, std::vector<base::Matrix> held) {
  given_.reset();
  held_ = std::move(held);
  for (const base::Matrix& one : loads) {
    if (one.numRows() > 0) cases_ = one.numCols();
  }
  for (base::Matrix& one : held_) {
    if (isZero(one)) one = base::Matrix();
  }
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const int columns = static_cast<int>(members_[g].size()) * cases_;
    base::Matrix sums(groups_[g]->dofs(), columns), places;
    for (const int body : members_[g]) {
      toGroup(places_[body], loads[body], sums);
      loads[body] = base::Matrix();
      if (held_[body].numCols() == 0) continue;
      if (places.numCols() == 0) places.shape(groups_[g]->dofs(), columns);
      toGroup(places_[body], held_[body], places);
    }
    if (!perturbations_.empty()) sums += perturbations_[g];
    groups_[g]->setLoads(sums, places);
  }
}

long BodyOperators::loadChanges() const {
  long changes = 0;
  for (const auto& group : groups_) changes += group->loads().changes();
  return changes;
}

bool BodyOperators::areLoaded() const {
  return std::any_of(groups_.begin(), groups_.end(),
                     [](const auto& group) { return group->loads().projected().numCols() > 0; });
}

base::Matrix BodyOperators::loads(int body) const {
  const Place& place = places_[body];
  base::Matrix own;  // the only one returned: matrices are copied where it is not made in place
  if (place.group < 0) return own;
  const OperatorGroup& group = *groups_[place.group];
  own.shape(group.dofs(), cases_);
  if (group.loads().projected().numCols() > 0) fromGroup(place, group.loads().projected(), own);
  return own;
}

void BodyOperators::select(const std::vector<int>& steps) {
  steps_ = steps;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    std::vector<int> columns;
    for (std::size_t m = 0; m < members_[g].size(); ++m) {
      for (const int t : steps_)
        columns.push_back(t == withoutLoads ? ColumnLoads::none : static_cast<int>(m) * cases_ + t);
    }
    groups_[g]->select(std::move(columns), static_cast<int>(members_[g].size()));
  }
}

void BodyOperators::solve(const base::Matrix& forces, int first, substructure::Precision precision) {
  const int columns = static_cast<int>(steps_.size()), count = forces.numCols();
  std::vector<std::vector<int>> solved(groups_.size());
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    for (std::size_t m = 0; m < members_[g].size(); ++m) {
      for (int t = first; t < first + count; ++t) {
        solved[g].push_back(static_cast<int>(m) * columns + t);
        std::fill_n(groups_[g]->forces()[solved[g].back()], groups_[g]->rows(), 0.0);
      }
    }
  }
  addForces(forces, first);
  if (precision == substructure::Precision::single && blocksGiven() > 0) {
    solveShared(solved, count);
  } else {
    for (std::size_t g = 0; g < groups_.size(); ++g) groups_[g]->solve(solved[g], precision);
  }
}

void BodyOperators::solveShared(const std::vector<std::vector<int>>& columns, int count) {
  for (int first = 0; first < count; first += shared_->columnsAtOnce()) {
    const int width = std::min(shared_->columnsAtOnce(), count - first);
    std::vector<std::vector<int>> together(groups_.size());
    SharedBlocks::Parts parts(groups_.size());
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      if (!shared_->gives(g)) continue;
      for (std::size_t m = 0; m < members_[g].size(); ++m) {
        const auto begin = columns[g].begin() + static_cast<std::ptrdiff_t>(m) * count + first;
        together[g].insert(together[g].end(), begin, begin + width);
      }
      parts[g] = groups_[g]->split(together[g]);
    }
    shared_->solve(parts, width, [&] {
      for (std::size_t g = 0; g < groups_.size() && first == 0; ++g) {
        if (!shared_->gives(g)) groups_[g]->solve(columns[g], substructure::Precision::single);
      }
    });
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      if (shared_->gives(g)) groups_[g]->join(together[g], parts[g]);
    }
  }
}

double BodyOperators::prepareSingle(const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  double largest = 0.0;
  for (auto& group : groups_) largest = std::max(largest, group->prepareSingle());
  std::vector<int> bodies;
  for (const std::vector<int>& members : members_) bodies.push_back(static_cast<int>(members.size()));
  shared_ = std::make_unique<SharedBlocks>(groups_, bodies, comm);
  return largest;
}

int BodyOperators::blocksGiven() const {
  return shared_ ? shared_->given() : 0;
}

void BodyOperators::addForces(const base::Matrix& forces, int first) {
  const int columns = static_cast<int>(steps_.size());
  for (const BlockMap& block : blocks_) {
    base::Matrix& right = groups_[block.place->group]->forces();
    for (int j = 0; j < forces.numCols(); ++j) {
      const double* from = forces[j] + block.begin;
      double* to = right[block.place->member * columns + first + j];
      for (int p = 0; p < block.trace.points(); ++p, from += dimension_) {
        base::Vector3 turned{};
        if (block.place->rotates) addRotated(block.place->rotation, true, dimension_, from, turned.data());
        const double* force = block.place->rotates ? turned.data() : from;
        for (const auto& [row, weight] : block.trace.row(p)) {
          for (int c = 0; c < dimension_; ++c) to[row + c] += weight * force[c];
        }
      }
    }
  }
}

void BodyOperators::keepUnit() {
  for (auto& group : groups_) group->keepUnit();
}

void BodyOperators::addUnit(const std::vector<double>& factors) {
  const int columns = static_cast<int>(steps_.size());
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    for (std::size_t m = 0; m < members_[g].size(); ++m) {
      const int member = static_cast<int>(m);
      for (int t = 0; t < columns; ++t) groups_[g]->addUnit(member * columns + t, member, factors[t]);
    }
  }
}

void BodyOperators::addBalanced(const base::Matrix& forces) {
  addForces(forces, 0);
  for (auto& group : groups_) group->keepSolution();
}

void BodyOperators::trace(base::Matrix& trace, int first, int count) const {
  const int columns = static_cast<int>(steps_.size());
  for (const BlockMap& block : blocks_) {
    const base::Matrix& solution = groups_[block.place->group]->solution();
    for (int t = first; t < first + count; ++t) {
      const double* from = solution[block.place->member * columns + t];
      double* to = trace[t] + block.begin;
      for (int p = 0; p < block.trace.points(); ++p, to += dimension_) {
        base::Vector3 w{};
        for (const auto& [row, weight] : block.trace.row(p)) {
          for (int c = 0; c < dimension_; ++c) w[c] += weight * from[row + c];
        }
        if (block.place->rotates) {
          std::fill(to, to + dimension_, 0.0);
          addRotated(block.place->rotation, false, dimension_, w.data(), to);
        } else {
          std::copy_n(w.data(), dimension_, to);
        }
      }
    }
  }
}

base::Matrix BodyOperators::solveBody(int body, const base::Matrix& forces) const {
  Place place = places_[body];
  place.member = 0;
  const OperatorGroup& group = *groups_[place.group];
  base::Matrix right(forces.numRows(), forces.numCols()), master(right), solution(right);
  toGroup(place, forces, right);
  group.solveLinearly(right, master);
  fromGroup(place, master, solution);
  return solution;
}

base::Vector3 BodyOperators::displacement(int body, int node, int column) const {
  const Place& place = places_[body];
  base::Vector3 u{};
  const int at = place.member * static_cast<int>(steps_.size()) + column;
  const double* from = groups_[place.group]->displacement(masterDof(place, node), at);
  if (place.rotates) {
    addRotated(place.rotation, false, dimension_, from, u.data());
  } else {
    std::copy_n(from, dimension_, u.begin());
  }
  return u;
}

base::Vector3 BodyOperators::reaction(int body, std::size_t node, int column) const {
  const Place& place = places_[body];
  const EliminatedBoundaries::Node& held = eliminated_.nodes(body)[node];
  if (!held.isHeld) return {};
  const OperatorGroup& group = *groups_[place.group];
  const int at = place.member * static_cast<int>(steps_.size()) + column;
  const base::Vector3 reaction = group.reaction(group.heldPlace(masterDof(place, held.node) / dimension_), at);
  return place.rotates ? base::toFrame(place.rotation, reaction) : reaction;
}

void BodyOperators::perturb(const assembly::Assembly& assembly, unsigned seed, double times) {
  std::vector<base::Matrix> forces;
  perturbation_.assign(places_.size(), 0.0);
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    forces.push_back(groups_[g]->roundOffForces(seed));
    forces.back().scale(times);
    for (const int body : members_[g]) {
      for (int t = 0; t < cases_; ++t) {
        const double* column = forces.back()[places_[body].member * cases_ + t];
        const double square = std::inner_product(column, column + forces.back().numRows(), column, 0.0);
        perturbation_[body] = std::max(perturbation_[body], std::sqrt(square));
      }
    }
  }
  perturbations_ = std::move(forces);
  given_.reset();
  updateLoads(assembly);
}

void BodyOperators::unperturb(const assembly::Assembly& assembly) {
  perturbations_.clear();
  given_.reset();
  updateLoads(assembly);
}

std::vector<double> BodyOperators::solutionErrors() const {
  std::vector<double> errors(places_.size(), 0.0);
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    for (const int body : members_[g]) errors[body] = groups_[g]->solutionError();
  }
  return errors;
}

double BodyOperators::squaredTerms() const {
  double sum = 0.0;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const double terms = groups_[g]->largestDisplacement(1.0) * groups_[g]->stiffnessNorm();
    sum += static_cast<double>(members_[g].size()) * terms * terms;
    const double unit = std::numeric_limits<double>::epsilon();
    sum += groups_[g]->squaredResidual() / (unit * unit);
  }
  return sum;
}

double BodyOperators::largestDisplacement(double share) const {
  double largest = 0.0;
  for (const auto& group : groups_) largest = std::max(largest, group->largestDisplacement(share));
  return largest;
}

double BodyOperators::entries() const {
  double sum = 0.0;
  for (const auto& group : groups_) sum += static_cast<double>(group->entries());
  return sum;
}

}  // namespace harmos::latin
