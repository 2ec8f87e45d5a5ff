#include <harmos/recovery/StressRecovery.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include <Teuchos_BLAS.hpp>
#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/mesh/Elements.hpp>
#include <harmos/recovery/detail/StressSamples.hpp>

namespace harmos::recovery {
namespace {

// Singular value of a fit, over the largest, below which its points say nothing.
constexpr double undetermined = 1e-3;

/// Which elements of a part a node belongs to, and which nodes an element has.
class Neighbourhood {
 public:
  Neighbourhood(const elasticity::ElasticPart& part, const StressSamples& samples)
      : elements_(part.mesh),
        part_(part),
        samples_(samples),
        ofNode_(part.piece.nodes.size()),
        wasFound_(part.piece.elements.size(), false) {
    for (std::size_t e = 0; e < wasFound_.size(); ++e) {
      for (std::size_t k = samples.firstNode[e]; k < samples.firstNode[e + 1]; ++k) {
        ofNode_[samples.node[k]].push_back(static_cast<int>(e));
      }
    }
  }

  mesh::ElementType type(int element) const { return elements_.type(part_.piece.elements[element]); }
  const std::vector<int>& elementsOf(int node) const { return ofNode_[node]; }
  /// And those that share a node with one of them.
  std::vector<int> widened(const std::vector<int>& elements) {
    std::vector<int> result;
    for (const int element : elements) {
      for (std::size_t k = samples_.firstNode[element]; k < samples_.firstNode[element + 1]; ++k) {
        for (const int neighbour : ofNode_[samples_.node[k]]) {
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
  const StressSamples& samples_;
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

/// The monomials of x up to the given order, 1 first; returns how many.
int monomials(const base::Vector3& x, int dimension, bool isQuadratic, double* to) {
  int count = 0;
  to[count++] = 1.0;
  for (int i = 0; i < dimension; ++i) to[count++] = x[i];
  for (int i = 0; i < dimension && isQuadratic; ++i) {
    for (int j = i; j < dimension; ++j) to[count++] = x[i] * x[j];
  }
  return count;
}

double sizeOf(const base::Matrix& matrix) {
  double sum = 0.0;
  for (int i = 0; i < matrix.numRows(); ++i) {
    for (int j = 0; j <= i; ++j) sum += (i == j ? 1.0 : 2.0) * matrix(j, i) * matrix(j, i);
  }
  return std::sqrt(sum);
}

/// The first row of the inverse of a symmetric matrix, whose upper triangle is given; of its pseudo-inverse where
/// singular values of the fit have to be dropped.
std::vector<double> firstOfInverse(const base::Matrix& gram) {
  const int size = gram.numRows();
  const Teuchos::LAPACK<int, double> lapack;
  std::vector<double> first(size, 0.0);
  int info = 0;
  base::Matrix inverse(gram);
  lapack.POTRF('U', size, inverse.values(), inverse.stride(), &info);
  if (info == 0) lapack.POTRI('U', size, inverse.values(), inverse.stride(), &info);
  // No less than the quotient of the largest and the smallest eigenvalue.
  if (info == 0 && sizeOf(gram) * sizeOf(inverse) * undetermined * undetermined < 1.0) {
    for (int i = 0; i < size; ++i) first[i] = inverse(0, i);
    return first;
  }
  base::Matrix vectors(gram);
  std::vector<double> values(size), work(64 * static_cast<std::size_t>(size));
  lapack.SYEV('V', 'U', size, vectors.values(), vectors.stride(), values.data(), work.data(),
              static_cast<int>(work.size()), &info);
  if (info != 0) throw base::Error("LAPACK's SYEV failed with " + std::to_string(info) + " in the recovery of stress.");
  for (int k = 0; k < size; ++k) {
    if (values[k] < undetermined * undetermined * values.back()) continue;
    for (int i = 0; i < size; ++i) first[i] += vectors(i, k) * vectors(0, k) / values[k];
  }
  return first;
}

/// Fits polynomials to samples.
class Fit {
 public:
  Fit(const StressSamples& samples, int dimension) : samples_(samples), dimension_(dimension) {}

  /// Adds to `stress`, as wide as a sample, the value at a place of the polynomial fitted to those of these elements.
  void evaluate(const std::vector<int>& patch, const base::Vector3& place, bool isQuadratic, double* stress) {
    look(patch, place, isQuadratic);
    const Teuchos::BLAS<int, double> blas;
    const int width = static_cast<int>(samples_.width);
    // Those that follow one another at once.
    for (std::size_t begin = 0, end = 0; begin < sample_.size(); begin = end) {
      for (end = begin + 1; end < sample_.size() && sample_[end] == sample_[end - 1] + 1;) ++end;
      blas.GEMV(Teuchos::NO_TRANS, width, static_cast<int>(end - begin), 1.0, samples_.at(sample_[begin]), width,
                weight_.data() + begin, 1, 1.0, stress, 1);
    }
  }

 private:
  static constexpr int mostMonomials = 10;

  /// What each sample counts in the value.
  void look(const std::vector<int>& patch, const base::Vector3& place, bool isQuadratic) {
    sample_.clear();
    double size = 0.0;
    for (const int element : patch) {
      for (std::size_t s = samples_.first[element]; s < samples_.first[element + 1]; ++s) {
        sample_.push_back(s);
        const base::Vector3 x = samples_.position[s] - place;
        size = std::max(size, base::dot(x, x));
      }
    }
    const double scale = 1.0 / std::sqrt(size);
    rows_.resize(mostMonomials * sample_.size());
    double sums[mostMonomials][mostMonomials] = {};
    int unknowns = 0;
    for (std::size_t s = 0; s < sample_.size(); ++s) {
      double* row = rows_.data() + mostMonomials * s;
      unknowns = monomials(scale * (samples_.position[sample_[s]] - place), dimension_, isQuadratic, row);
      for (int i = 0; i < unknowns; ++i) {
        const double weighted = samples_.volume[sample_[s]] * row[i];
        for (int j = 0; j <= i; ++j) sums[i][j] += weighted * row[j];
      }
    }
    base::Matrix gram(unknowns, unknowns);
    for (int i = 0; i < unknowns; ++i) std::copy_n(sums[i], i + 1, gram[i]);
    const std::vector<double> first = firstOfInverse(gram);
    weight_.resize(sample_.size());
    for (std::size_t s = 0; s < sample_.size(); ++s) {
      weight_[s] = samples_.volume[sample_[s]] *
                   std::inner_product(first.begin(), first.end(), rows_.begin() + mostMonomials * s, 0.0);
    }
  }

  const StressSamples& samples_;
  int dimension_;
  std::vector<std::size_t> sample_;
  std::vector<double> weight_;  // of each of these
  std::vector<double> rows_;    // their monomials
};

}  // namespace

StressRecovery::StressRecovery(const elasticity::ElasticPart& part, const std::vector<bool>& boundary,
                               const base::Matrix& displacements)
    : StressRecovery(part, boundary, StressSamples(part, displacements)) {}

StressRecovery::StressRecovery(const elasticity::ElasticPart& part, const std::vector<bool>& boundary,
                               const StressSamples& samples) {
  const int nodes = static_cast<int>(part.piece.nodes.size());
  Neighbourhood neighbourhood(part, samples);
  Fit fit(samples, part.mesh.dimension);
  stress_.shape(static_cast<int>(samples.width), nodes);
  for (int node = 0; node < nodes; ++node) {
    const std::vector<int> patch = patchOf(neighbourhood, node, boundary[node]);
    if (patch.empty()) continue;
    const bool isQuadratic = mesh::isQuadratic(neighbourhood.type(patch.front()));
    fit.evaluate(patch, part.mesh.nodes[part.piece.nodes[node]], isQuadratic, stress_[node]);
  }
}

}  // namespace harmos::recovery
