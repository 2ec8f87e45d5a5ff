#include <harmos/latin/ReferenceMotions.hpp>

#include <algorithm>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/latin/detail/RigidParts.hpp>
#include <harmos/latin/detail/RigidWork.hpp>
#include <harmos/latin/detail/SymmetricEigen.hpp>

namespace harmos::latin {
namespace {

constexpr std::size_t sixfold = 6;
// Eigenvalue of a rigid motion over the largest one, below which the rows of a body cannot tell it.
constexpr double felt = 1e-10;

base::Vector3 meanOf(const std::vector<base::Vector3>& nodes) {
  base::Vector3 mean{};
  for (const base::Vector3& x : nodes) mean = mean + (1.0 / static_cast<double>(nodes.size())) * x;
  return mean;
}

}  // namespace

void ReferenceMotions::add(const base::Matrix& trace, const TraceLayout& layout) {
  const auto steps = static_cast<std::size_t>(assembly_->steps());
  const std::size_t bodies = assembly_->bodies.size();
  const auto dimension = static_cast<std::size_t>(layout.dimension());
  std::vector<base::Vector3> centres;
  std::vector<double> sizes;
  for (const auto& body : assembly_->bodies) {
    centres.push_back(meanOf(body.nodes));
    sizes.push_back(0.0);
    for (const base::Vector3& x : body.nodes) sizes.back() = std::max(sizes.back(), base::distance(x, centres.back()));
  }
  // Normal equations, rotations in units of the body's size.
  std::vector<base::Matrix> grams(bodies, base::Matrix(sixfold, sixfold));
  std::vector<double> right(bodies * steps * sixfold, 0.0);
  for (const TraceLayout::Block& block : layout.blocks()) {
    const auto body = static_cast<std::size_t>(block.body);
    const mesh::TraceOperator& points = assembly_->interfaces[block.interface].trace(block.side);
    for (std::size_t p = 0; p < static_cast<std::size_t>(block.pairs); ++p) {
      const std::size_t row = static_cast<std::size_t>(block.begin) + p * dimension;
      const double area = layout.area()[row];
      const base::Vector3 r =
          (1.0 / sizes[body]) * (points.at(static_cast<int>(p), assembly_->bodies[body].nodes) - centres[body]);
      for (std::size_t c = 0; c < dimension; ++c) {
        base::Vector3 axis{};
        axis[c] = 1.0;
        const auto worked = rigidWork(r, axis);
        for (std::size_t i = 0; i < sixfold; ++i) {
          for (std::size_t j = 0; j < sixfold; ++j) {
            grams[body](static_cast<int>(i), static_cast<int>(j)) += area * worked[i] * worked[j];
          }
          for (std::size_t t = 0; t < steps; ++t) {
            right[(body * steps + t) * sixfold + i] += area * worked[i] * trace[static_cast<int>(t)][row + c];
          }
        }
      }
    }
  }
  if (resists_.empty()) {
    for (const ResistedMotions& own : resistedMotions(*assembly_, layout.comm())) {
      resists_.push_back(std::any_of(own.begin(), own.end(), [](bool one) { return one; }));
    }
  }
  std::vector<double> mine(right.size(), 0.0), all(right.size(), 0.0);
  for (std::size_t b = 0; b < bodies; ++b) {
    if (grams[b].normInf() == 0.0 || resists_[b]) continue;
    const std::vector<double> values = symmetricEigen(grams[b]);
    for (std::size_t t = 0; t < steps; ++t) {
      const double* from = right.data() + (b * steps + t) * sixfold;
      double* to = mine.data() + (b * steps + t) * sixfold;
      for (std::size_t m = 0; m < sixfold; ++m) {
        if (values[m] <= felt * values.back()) continue;
        const double* vector = grams[b][static_cast<int>(m)];
        double share = 0.0;
        for (std::size_t i = 0; i < sixfold; ++i) share += vector[i] * from[i] / values[m];
        for (std::size_t i = 0; i < sixfold; ++i) to[i] += share * vector[i];
      }
    }
  }
  // A body belongs to one rank; the neighbours of its interfaces need its motion, too.
  Teuchos::reduceAll(layout.comm(), Teuchos::REDUCE_SUM, static_cast<int>(mine.size()), mine.data(), all.data());
  motions_.resize(bodies * steps);
  for (std::size_t b = 0; b < bodies; ++b) {
    for (std::size_t t = 0; t < steps; ++t) {
      Motion& motion = motions_[b * steps + t];
      const double* found = all.data() + (b * steps + t) * sixfold;
      motion.centre = centres[b];
      for (std::size_t c = 0; c < 3; ++c) {
        motion.translation[c] += found[c];
        if (sizes[b] > 0.0) motion.rotation[c] += found[3 + c] / sizes[b];
      }
    }
  }
}

ReferenceMotions::Place ReferenceMotions::exactly(int body, int node, int step) const {
  Place place;
  if (motions_.empty() || body < 0) return place;
  const Motion& motion =
      motions_[static_cast<std::size_t>(body) * assembly_->times.size() + static_cast<std::size_t>(step)];
  Extended r[3];
  for (std::size_t c = 0; c < 3; ++c) {
    r[c] = static_cast<Extended>(assembly_->bodies[body].nodes[node][c]) - motion.centre[c];
  }
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t d = (c + 1) % 3, e = (c + 2) % 3;
    place.x[c] = motion.translation[c] + (motion.rotation[d] * r[e] - motion.rotation[e] * r[d]);
  }
  return place;
}

base::Vector3 ReferenceMotions::at(int body, int node, int step) const {
  const Place place = exactly(body, node, step);
  return {static_cast<double>(place.x[0]), static_cast<double>(place.x[1]), static_cast<double>(place.x[2])};
}

ReferenceMotions::Place ReferenceMotions::exactly(const assembly::Interface& interface, int side, int point,
                                                  int step) const {
  Place place;
  if (side >= interface.sides()) return place;
  Extended sum = 0.0L;
  for (const mesh::TraceOperator::Entry& entry : interface.trace(side).row(point)) {
    const Place ofNode = exactly(interface.body(side), entry.node, step);
    for (std::size_t c = 0; c < 3; ++c) place.x[c] += entry.weight * ofNode.x[c];
    sum += entry.weight;
  }
  // The sum is 1 but for round-off, which is no motion.
  for (Extended& x : place.x) x /= sum;
  return place;
}

base::Vector3 ReferenceMotions::at(const assembly::Interface& interface, int side, int point, int step) const {
  const Place place = exactly(interface, side, point, step);
  return {static_cast<double>(place.x[0]), static_cast<double>(place.x[1]), static_cast<double>(place.x[2])};
}

base::Vector3 ReferenceMotions::jump(const assembly::Interface& interface, int point, int step) const {
  const Place from = exactly(interface, 0, point, step), to = exactly(interface, 1, point, step);
  base::Vector3 jump{};
  for (std::size_t c = 0; c < 3; ++c) jump[c] = static_cast<double>(to.x[c] - from.x[c]);
  return jump;
}

base::Vector3 ReferenceMotions::difference(const ReferenceMotions& other, const assembly::Interface& interface,
                                           int side, int point, int step) const {
  const Place mine = exactly(interface, side, point, step), theirs = other.exactly(interface, side, point, step);
  base::Vector3 difference{};
  for (std::size_t c = 0; c < 3; ++c) difference[c] = static_cast<double>(mine.x[c] - theirs.x[c]);
  return difference;
}

base::Vector3 ReferenceMotions::below(const base::Vector3& place, int body, int node, int step) const {
  const Place mine = exactly(body, node, step);
  base::Vector3 difference{};
  for (std::size_t c = 0; c < 3; ++c) difference[c] = static_cast<double>(place[c] - mine.x[c]);
  return difference;
}

}  // namespace harmos::latin
