#include <harmos/recovery/StressRecovery.hpp>

#include <algorithm>
#include <numeric>
#include <string>

#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/mesh/Elements.hpp>

namespace harmos::recovery {
namespace {

// Singular value of a fit, over the largest, below which its points say nothing.
constexpr double undetermined = 1e-3;

/// What the elements say at their sampling points.
struct Samples {
  std::vector<std::size_t> first;  // of each element, and the end
  std::vector<base::Vector3> position;
  std::vector<double> volume;
  std::vector<double> stress;  // 6 x columns of each point
};

Samples sample(const elasticity::ElasticPart& part, const base::Matrix& displacements) {
  Samples samples;
  const std::size_t width = 6 * static_cast<std::size_t>(displacements.numCols());
  elasticity::forEachPoint(part, elasticity::PointSet::sampling, displacements,
                           [&](const elasticity::ElementPoint& point) {
                             while (samples.first.size() <= static_cast<std::size_t>(point.element)) {
                               samples.first.push_back(samples.position.size());
                             }
                             samples.position.push_back(point.position);
                             samples.volume.push_back(point.volume);
                             samples.stress.insert(samples.stress.end(), point.stress, point.stress + width);
                           });
  samples.first.push_back(samples.position.size());
  return samples;
}

/// Which elements of a part a node belongs to, and which nodes an element has.
class Neighbourhood {
 public:
  explicit Neighbourhood(const elasticity::ElasticPart& part) : elements_(part.mesh), part_(part), first_(1, 0) {
    ofNode_.resize(part.piece.nodes.size());
    wasFound_.assign(part.piece.elements.size(), false);
    for (std::size_t e = 0; e < part.piece.elements.size(); ++e) {
      const int number = part.piece.elements[e];
      const int* nodes = elements_.nodes(number);
      for (int a = 0; a < mesh::nodesPerElement(elements_.type(number)); ++a) {
        nodes_.push_back(mesh::localNode(part.piece, nodes[a]));
        ofNode_[nodes_.back()].push_back(static_cast<int>(e));
      }
      first_.push_back(nodes_.size());
    }
  }

  mesh::ElementType type(int element) const { return elements_.type(part_.piece.elements[element]); }
  const std::vector<int>& elementsOf(int node) const { return ofNode_[node]; }
  /// And those that share a node with one of them.
  std::vector<int> widened(const std::vector<int>& elements) {
    std::vector<int> result;
    for (const int element : elements) {
      for (std::size_t k = first_[element]; k < first_[element + 1]; ++k) {
        for (const int neighbour : ofNode_[nodes_[k]]) {
          if (wasFound_[neighbour]) continue;
          wasFound_[neighbour] = true;
          result.push_back(neighbour);
        }
      }
    }
    for (const int element : result) wasFound_[element] = false;
    std::sort(result.begin(), result.end());
    return result;
  }

 private:
  mesh::Elements elements_;
  const elasticity::ElasticPart& part_;
  std::vector<std::size_t> first_;  // in nodes_ of each element, and the end
  std::vector<int> nodes_;          // of the piece
  std::vector<std::vector<int>> ofNode_;
  std::vector<bool> wasFound_;  // per element, during widened()
};

bool isSimplex(mesh::ElementType type) {
  const mesh::ElementType linear = mesh::linearType(type);
  return linear == mesh::ElementType::tri3 || linear == mesh::ElementType::tet4;
}

/// Fewer elements around a node do not determine a linear polynomial well.
std::size_t fewest(mesh::ElementType type) {
  const bool isPlane = mesh::dimensionOf(type) == 2;
  if (isSimplex(type)) return isPlane ? 5 : 10;
  return isPlane ? 4 : 8;
}

std::vector<int> patchOf(Neighbourhood& neighbourhood, int node, bool isOnBoundary) {
  const std::vector<int>& own = neighbourhood.elementsOf(node);
  if (own.empty()) return {};
  const mesh::ElementType type = neighbourhood.type(own.front());
  const bool isTooSmall = own.size() < fewest(type) || (isSimplex(type) && isOnBoundary);
  return isTooSmall ? neighbourhood.widened(own) : own;
}

/// Appends the monomials of x up to the given order, 1 first.
void appendMonomials(const base::Vector3& x, int dimension, bool isQuadratic, std::vector<double>& to) {
  to.push_back(1.0);
  for (int i = 0; i < dimension; ++i) to.push_back(x[i]);
  for (int i = 0; i < dimension && isQuadratic; ++i) {
    for (int j = i; j < dimension; ++j) to.push_back(x[i] * x[j]);
  }
}

/// What each sample counts in the value at the node of the polynomial fitted to the samples of these elements.
struct Fit {
  std::vector<std::size_t> point;
  std::vector<double> weight;
};

Fit fit(const Samples& samples, const std::vector<int>& patch, const base::Vector3& node, int dimension,
        bool isQuadratic) {
  Fit result;
  double size = 0.0;
  for (const int element : patch) {
    for (std::size_t p = samples.first[element]; p < samples.first[element + 1]; ++p) {
      result.point.push_back(p);
      size = std::max(size, base::distance(samples.position[p], node));
    }
  }
  std::vector<double> rows;  // monomials of each point, one point after the other
  for (const std::size_t p : result.point) {
    appendMonomials((1.0 / size) * (samples.position[p] - node), dimension, isQuadratic, rows);
  }
  const int unknowns = static_cast<int>(rows.size() / result.point.size());
  base::Matrix gram(unknowns, unknowns);
  for (std::size_t s = 0; s < result.point.size(); ++s) {
    const double volume = samples.volume[result.point[s]];
    const double* row = rows.data() + s * unknowns;
    for (int i = 0; i < unknowns; ++i) {
      for (int j = 0; j <= i; ++j) gram[i][j] += volume * row[i] * row[j];
    }
  }
  std::vector<double> values(unknowns), work(64 * static_cast<std::size_t>(unknowns));
  int info = 0;
  Teuchos::LAPACK<int, double>().SYEV('V', 'U', unknowns, gram.values(), gram.stride(), values.data(), work.data(),
                                      static_cast<int>(work.size()), &info);
  if (info != 0) throw base::Error("LAPACK's SYEV failed with " + std::to_string(info) + " in the recovery of stress.");
  std::vector<double> first(unknowns, 0.0);  // of the inverse, the row of the constant
  for (int k = 0; k < unknowns; ++k) {
    if (values[k] < undetermined * undetermined * values.back()) continue;
    for (int i = 0; i < unknowns; ++i) first[i] += gram(i, k) * gram(0, k) / values[k];
  }
  for (std::size_t s = 0; s < result.point.size(); ++s) {
    result.weight.push_back(samples.volume[result.point[s]] *
                            std::inner_product(first.begin(), first.end(), rows.begin() + s * unknowns, 0.0));
  }
  return result;
}

}  // namespace

StressRecovery::StressRecovery(const elasticity::ElasticPart& part, const std::vector<bool>& boundary,
                               const base::Matrix& displacements) {
  const int columns = displacements.numCols();
  const int nodes = static_cast<int>(part.piece.nodes.size());
  const Samples samples = sample(part, displacements);
  Neighbourhood neighbourhood(part);
  stress_.shape(6 * nodes, columns);
  std::vector<double> sum(6 * static_cast<std::size_t>(columns));
  for (int node = 0; node < nodes; ++node) {
    const std::vector<int> patch = patchOf(neighbourhood, node, boundary[node]);
    if (patch.empty()) continue;
    const bool isQuadratic = mesh::isQuadratic(neighbourhood.type(patch.front()));
    const Fit weights = fit(samples, patch, part.mesh.nodes[part.piece.nodes[node]], part.mesh.dimension, isQuadratic);
    std::fill(sum.begin(), sum.end(), 0.0);
    for (std::size_t s = 0; s < weights.point.size(); ++s) {
      const double* stress = samples.stress.data() + weights.point[s] * sum.size();
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weights.weight[s] * stress[i];
    }
    for (int column = 0; column < columns; ++column) std::copy_n(&sum[6 * column], 6, stress_[column] + 6 * node);
  }
}

}  // namespace harmos::recovery
