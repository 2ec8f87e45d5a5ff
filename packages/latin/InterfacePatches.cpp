#include <harmos/latin/detail/InterfacePatches.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <harmos/base/Matrix.hpp>
#include <harmos/base/Vector3.hpp>
#include <harmos/latin/detail/SymmetricEigen.hpp>

namespace harmos::latin {
namespace {

// Length over width of faces that get patches, and from which on a patch is halved.
constexpr double slender = 16.0;
constexpr double slenderPatch = 8.0;
// A patch has no fewer pairs, or its motions would be all that there are.
constexpr std::size_t leastPairs = 12;
// Of one face, and of all together: each takes six solves of its bodies.
constexpr std::size_t mostOfFace = 16;
constexpr std::size_t mostOfAll = 128;
// Of the length: pairs in the middle, which round-off must not part.
constexpr double middle = 1e-9;

using Pairs = std::vector<int>;

/// Where some pairs of an interface lie: the direction in which they reach farthest, how far, and that over the width.
struct Extent {
  base::Vector3 centre{};
  base::Vector3 direction{};
  double length = 0.0;
  double slenderness = 0.0;
};

Extent extentOf(const assembly::Interface& interface, const Pairs& pairs) {
  Extent extent;
  double total = 0.0;
  for (const int p : pairs) {
    extent.centre = extent.centre + interface.area[p] * interface.position[p];
    total += interface.area[p];
  }
  extent.centre = (1.0 / total) * extent.centre;
  base::Matrix moments(3, 3);
  for (const int p : pairs) {
    const base::Vector3 r = interface.position[p] - extent.centre;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) moments(i, j) += interface.area[p] / total * r[i] * r[j];
    }
  }
  const std::vector<double> squares = symmetricEigen(moments);
  for (int i = 0; i < 3; ++i) extent.direction[i] = moments(i, 2);
  extent.length = std::sqrt(12.0 * squares.back());
  extent.slenderness = extent.length * extent.length / total;
  return extent;
}

/// Appends the pairs, or where they are slender those of their halves, no more than `most` patches.
void halve(const assembly::Interface& interface, const Pairs& pairs, std::size_t most, std::vector<Pairs>& patches) {
  const Extent extent = extentOf(interface, pairs);
  Pairs before, behind;
  for (const int p : pairs) {
    const double along = base::dot(extent.direction, interface.position[p] - extent.centre);
    (along < -middle * extent.length ? before : behind).push_back(p);
  }
  if (most < 2 || extent.slenderness < slenderPatch || std::min(before.size(), behind.size()) < leastPairs) {
    patches.push_back(pairs);
    return;
  }
  halve(interface, before, most / 2, patches);
  halve(interface, behind, most / 2, patches);
}

}  // namespace

std::vector<std::vector<Pairs>> interfacePatches(const assembly::Assembly& assembly) {
  std::vector<std::vector<Pairs>> whole, parted;
  std::size_t count = 0;
  for (const assembly::Interface& interface : assembly.interfaces) {
    Pairs all(static_cast<std::size_t>(interface.pairs()));
    std::iota(all.begin(), all.end(), 0);
    whole.push_back({all});
    parted.emplace_back();
    const bool mayBeParted = assembly.dimension == 3 && interface.sides() == 2 && interface.law->bonds() &&
                             interface.mass.empty() && all.size() >= 2 * leastPairs;
    if (mayBeParted && extentOf(interface, all).slenderness >= slender) {
      halve(interface, all, mostOfFace, parted.back());
      count += parted.back().size();
    } else {
      parted.back() = whole.back();
    }
  }
  return count <= mostOfAll ? parted : whole;
}

}  // namespace harmos::latin
