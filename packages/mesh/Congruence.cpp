#include <harmos/mesh/Congruence.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <harmos/base/Vector3.hpp>
#include <harmos/mesh/Elements.hpp>
#include <harmos/mesh/PointSearch.hpp>

namespace harmos::mesh {
namespace {

constexpr double relativeTolerance = 1e-9;

/// Nodes of a part relative to their centroid.
struct Cloud {
  Cloud(const Mesh& mesh, const Piece& piece) : points(pointsOf(mesh, piece.nodes)) {
    base::Vector3 centroid{};
    for (const base::Vector3& p : points) centroid = centroid + (1.0 / static_cast<double>(points.size())) * p;
    for (base::Vector3& p : points) {
      p = p - centroid;
      radius.push_back(norm(p));
      size = std::max(size, radius.back());
    }
  }

  std::vector<base::Vector3> points;
  std::vector<double> radius;
  double size = 0.0;  // largest radius
};

/// Columns e1, e2, e3 of the frame that has a on its first axis and b in the plane of its first two.
base::Frame frameOf(const base::Vector3& a, const base::Vector3& b, double orientation) {
  const base::Vector3 e1 = (1.0 / norm(a)) * a;
  const base::Vector3 across = b - dot(b, e1) * e1;
  const base::Vector3 e2 = (1.0 / norm(across)) * across;
  return {e1, e2, orientation * cross(e1, e2)};
}

/// The orthogonal matrix that carries the axes of `from` onto those of `to`.
base::Frame turn(const base::Frame& from, const base::Frame& to) {
  base::Frame q{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) q[i][j] += to[k][i] * from[k][j];
      // Multiples of right angles without rounding.
      if (std::abs(q[i][j] - std::round(q[i][j])) < relativeTolerance) q[i][j] = std::round(q[i][j]);
    }
  }
  return q;
}

/// Of the nodes that `isUsable`, one whose `key` the fewest others share.
template <typename Key, typename Usable>
std::size_t rarest(const std::vector<base::Vector3>& points, double tolerance, const Key& key, const Usable& isUsable) {
  std::vector<std::pair<double, std::size_t>> sorted;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (isUsable(points[i])) sorted.emplace_back(key(points[i]), i);
  }
  std::sort(sorted.begin(), sorted.end());
  std::size_t best = sorted.front().second;
  std::size_t fewest = sorted.size() + 1;
  for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
    while (end < sorted.size() && sorted[end].first <= sorted[begin].first + tolerance) ++end;
    if (end - begin < fewest) {
      fewest = end - begin;
      best = sorted[begin].second;
    }
  }
  return best;
}

class CongruenceSearch {
 public:
  CongruenceSearch(const Mesh& mesh, const Piece& first, const Piece& second, const std::vector<int>& kindsOfFirst,
                   const std::vector<int>& kindsOfSecond)
      : mesh_(mesh),
        elements_(mesh),
        first_(first),
        second_(second),
        kindsOfFirst_(kindsOfFirst),
        kindsOfSecond_(kindsOfSecond),
        a_(mesh, first),
        b_(mesh, second),
        tolerance_(relativeTolerance * a_.size),
        search_(b_.points) {}

  std::optional<Congruence> find() {
    auto radiiA = a_.radius;
    auto radiiB = b_.radius;
    std::sort(radiiA.begin(), radiiA.end());
    std::sort(radiiB.begin(), radiiB.end());
    for (std::size_t i = 0; i < radiiA.size(); ++i) {
      if (std::abs(radiiA[i] - radiiB[i]) > tolerance_) return std::nullopt;
    }
    if (carries({base::Vector3{1.0, 0.0, 0.0}, base::Vector3{0.0, 1.0, 0.0}, base::Vector3{0.0, 0.0, 1.0}}))
      return result_;
    return mesh_.dimension == 2 ? findInPlane() : findInSpace();
  }

 private:
  std::optional<Congruence> findInPlane() {
    const base::Vector3 a = anchor();
    const base::Vector3 up = {0.0, 0.0, 1.0};
    for (const base::Vector3& b : b_.points) {
      if (std::abs(norm(b) - norm(a)) > tolerance_) continue;
      for (const double orientation : {1.0, -1.0}) {
        const base::Frame from = {(1.0 / norm(a)) * a, (1.0 / norm(a)) * cross(up, a), up};
        const base::Frame to = {(1.0 / norm(b)) * b, (orientation / norm(b)) * cross(up, b), up};
        if (carries(turn(from, to))) return result_;
      }
    }
    return std::nullopt;
  }

  std::optional<Congruence> findInSpace() {
    const base::Vector3 a1 = anchor();
    // A second node well away from the line through the centroid and the first.
    const auto sine = [&](const base::Vector3& p) { return norm(cross(p, a1)) / (norm(a1) * a_.size); };
    double largest = 0.0;
    for (const base::Vector3& p : a_.points) largest = std::max(largest, sine(p));
    const base::Vector3 a2 = a_.points[rarest(
        a_.points, tolerance_, [&](const base::Vector3& p) { return norm(p) + distance(p, a1); },
        [&](const base::Vector3& p) { return sine(p) >= 0.5 * largest; })];
    for (const base::Vector3& b1 : b_.points) {
      if (std::abs(norm(b1) - norm(a1)) > tolerance_) continue;
      for (const base::Vector3& b2 : b_.points) {
        if (std::abs(norm(b2) - norm(a2)) > tolerance_) continue;
        if (std::abs(distance(b1, b2) - distance(a1, a2)) > tolerance_) continue;
        for (const double orientation : {1.0, -1.0}) {
          if (carries(turn(frameOf(a1, a2, 1.0), frameOf(b1, b2, orientation)))) return result_;
        }
      }
    }
    return std::nullopt;
  }

  /// A node far from the centroid; a near one would make Q inaccurate.
  base::Vector3 anchor() const {
    return a_.points[rarest(
        a_.points, tolerance_, [](const base::Vector3& p) { return norm(p); },
        [&](const base::Vector3& p) { return norm(p) >= 0.5 * a_.size; })];
  }

  bool carries(const base::Frame& q) {
    std::vector<int> image(a_.points.size());
    std::vector<bool> isTaken(a_.points.size(), false);
    for (std::size_t i = 0; i < a_.points.size(); ++i) {
      const auto near = search_.within(toFrame(q, a_.points[i]), tolerance_);
      if (near.size() != 1 || isTaken[near[0]]) return false;
      if (!kindsOfFirst_.empty() && kindsOfFirst_[i] != kindsOfSecond_[near[0]]) return false;
      isTaken[near[0]] = true;
      image[i] = near[0];
    }
    if (!carriesElements(image)) return false;
    result_ = {std::move(image), q};
    return true;
  }

  /// Sorted sides of sorted local nodes, what is not there negative: equal if and only if the elements are.
  using Side = std::array<int, 9>;
  using Key = std::pair<ElementType, std::vector<Side>>;

  Key keyOf(const Piece& piece, int element, const std::vector<int>* image) const {
    Key key{elements_.type(element), {}};
    const int* nodes = elements_.nodes(element);
    key.second.resize(static_cast<std::size_t>(sidesPerElement(key.first)));
    std::array<int, 27> local{};
    for (int i = 0; i < nodesPerElement(key.first); ++i) {
      local[i] = localNode(piece, nodes[i]);
      if (image != nullptr) local[i] = (*image)[local[i]];
    }
    for (std::size_t side = 0; side < key.second.size(); ++side) {
      key.second[side].fill(-1);
      auto end = key.second[side].begin();
      for (const int i : sideNodes(key.first, static_cast<int>(side))) *end++ = local[i];
      std::sort(key.second[side].begin(), end);
    }
    std::sort(key.second.begin(), key.second.end());
    return key;
  }

  /// Whether the image of an element of the first part has the nodes, in their order, of the one at the same place in
  /// the second: most have where parts were meshed alike.
  bool isInPlace(std::size_t place, const std::vector<int>& image) const {
    const int from = first_.elements[place], to = second_.elements[place];
    const ElementType type = elements_.type(from);
    if (elements_.type(to) != type) return false;
    const int *own = elements_.nodes(from), *other = elements_.nodes(to);
    for (int i = 0; i < nodesPerElement(type); ++i) {
      if (second_.nodes[image[localNode(first_, own[i])]] != other[i]) return false;
    }
    return true;
  }

  bool carriesElements(const std::vector<int>& image) {
    std::vector<int> moved;
    for (std::size_t e = 0; e < first_.elements.size(); ++e) {
      if (!isInPlace(e, image)) moved.push_back(first_.elements[e]);
    }
    if (moved.empty()) return true;
    if (keys_.empty()) {
      for (const int element : second_.elements) keys_.push_back(keyOf(second_, element, nullptr));
      std::sort(keys_.begin(), keys_.end());
    }
    return std::all_of(moved.begin(), moved.end(), [&](int element) {
      return std::binary_search(keys_.begin(), keys_.end(), keyOf(first_, element, &image));
    });
  }

  const Mesh& mesh_;
  Elements elements_;
  const Piece& first_;
  const Piece& second_;
  const std::vector<int>& kindsOfFirst_;
  const std::vector<int>& kindsOfSecond_;
  Cloud a_, b_;
  double tolerance_;
  PointSearch search_;
  std::vector<Key> keys_;  // of the second part
  Congruence result_;
};

}  // namespace

std::optional<Congruence> findCongruence(const Mesh& mesh, const Piece& first, const Piece& second,
                                         const std::vector<int>& kindsOfFirst, const std::vector<int>& kindsOfSecond) {
  if (first.nodes.size() != second.nodes.size() || first.elements.size() != second.elements.size()) {
    return std::nullopt;
  }
  std::vector<int> ofFirst(kindsOfFirst), ofSecond(kindsOfSecond);
  std::sort(ofFirst.begin(), ofFirst.end());
  std::sort(ofSecond.begin(), ofSecond.end());
  if (ofFirst != ofSecond) return std::nullopt;
  return CongruenceSearch(mesh, first, second, kindsOfFirst, kindsOfSecond).find();
}

}  // namespace harmos::mesh
