#include <harmos/mortar/detail/PointBuilder.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <harmos/mesh/SmoothPatches.hpp>

namespace harmos::mortar {
namespace {

constexpr double leastCovered = 0.05;  // of the area that belongs to a point
constexpr double roundOff = 1e-12;     // of a coefficient of B

using Entry = mesh::TraceOperator::Entry;

double coveredShare(const FaceCoupling& face, int corner) {
  return std::accumulate(face.mass[corner].begin(), face.mass[corner].end(), 0.0);
}

/// Sums up entries of one node and leaves out round-off, so that what is a selection but for it is one.
std::vector<Entry> tidied(std::vector<Entry> row, double area) {
  std::stable_sort(row.begin(), row.end(), [](const Entry& a, const Entry& b) { return a.node < b.node; });
  std::vector<Entry> merged;
  for (const Entry& entry : row) {
    if (merged.empty() || merged.back().node != entry.node) merged.push_back({entry.node, 0.0});
    merged.back().weight += entry.weight / area;
  }
  merged.erase(
      std::remove_if(merged.begin(), merged.end(), [](const Entry& e) { return std::abs(e.weight) <= roundOff; }),
      merged.end());
  double sum = 0.0;
  for (const Entry& entry : merged) sum += entry.weight;
  for (Entry& entry : merged) entry.weight /= sum;  // 1 but for round-off, which is no motion
  return merged;
}

}  // namespace

/// Of one side.
struct PointBuilder::Rows {
  explicit Rows(std::size_t points) : row(points) {}

  /// int psi_p N_j dS of a face's points, which are -1 where there is none.
  void add(const std::vector<FaceCoupling::Column>& columns, const CornerMatrix& coefficients,
           const std::vector<int>& points) {
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (points[p] < 0) continue;
      for (const FaceCoupling::Column& column : columns) {
        double sum = 0.0;
        for (std::size_t q = 0; q < points.size(); ++q) sum += coefficients[p][q] * column.value[q];
        row[points[p]].push_back({column.node, sum});
      }
    }
  }

  mesh::TraceOperator build(const std::vector<double>& area) {
    mesh::TraceOperator trace;
    for (std::size_t p = 0; p < row.size(); ++p) trace.append(tidied(std::move(row[p]), area[p]));
    return trace;
  }

  std::vector<std::vector<Entry>> row;
};

PointBuilder::PointBuilder(const std::vector<mesh::Face>& faces, const std::vector<FaceCoupling>& couplings,
                           double creaseAngle)
    : faces_(faces), couplings_(couplings) {
  std::vector<mesh::OrientedFace> oriented;
  for (const FaceCoupling& coupling : couplings) {
    mesh::OrientedFace& face = oriented.emplace_back();
    for (int p = 0; p < coupling.corners; ++p) {
      face.pairs.emplace_back(faces[coupling.face].nodes[p], -1);
      face.normal = face.normal + coupling.normal[p];
    }
  }
  patch_ = mesh::smoothPatches(oriented, creaseAngle);
  std::map<PointKey, std::pair<double, double>> areas;  // covered, all
  for (std::size_t c = 0; c < couplings.size(); ++c) {
    for (int p = 0; p < couplings[c].corners; ++p) {
      auto& [covered, whole] = areas[keyOf(c, p)];
      covered += coveredShare(couplings[c], p);
      whole += couplings[c].whole[p];
    }
  }
  for (const auto& [key, area] : areas) {
    if (area.first >= leastCovered * area.second) {
      number_.emplace(key, static_cast<int>(number_.size()));
    } else {
      ++leftOut_;
    }
  }
}

PointKey PointBuilder::keyOf(std::size_t coupling, int corner) const {
  return {faces_[couplings_[coupling].face].nodes[corner], patch_[coupling][corner]};
}

int PointBuilder::numberOf(const PointKey& key) const {
  const auto found = number_.find(key);
  return found == number_.end() ? -1 : found->second;
}

void PointBuilder::keep(const std::set<PointKey>& points) {
  number_.clear();
  for (const PointKey& key : points) number_.emplace(key, static_cast<int>(number_.size()));
}

void PointBuilder::leaveOutCreases() {
  std::vector<std::vector<PointKey>> points(couplings_.size());
  for (std::size_t c = 0; c < couplings_.size(); ++c) {
    for (int p = 0; p < couplings_[c].corners; ++p) {
      if (number_.count(keyOf(c, p)) > 0) points[c].push_back(keyOf(c, p));
    }
  }
  const SmoothPoints smooth = withoutCreases(points);
  for (const auto& [key, number] : number_) {
    if (smooth.kept.count(key) == 0) creased_.insert(key);
  }
  adopted_ = smooth.adopted;
  keep(smooth.kept);
}

int PointBuilder::leaveOut(const std::vector<bool>& unwanted) {
  std::set<PointKey> stay;
  for (const auto& [key, number] : number_) {
    if (!unwanted[number]) stay.insert(key);
  }
  for (const auto& [coupling, key] : adopted_) stay.insert(key);
  for (std::size_t c = 0; c < couplings_.size(); ++c) {
    int largest = -1;
    bool isEmpty = true;
    for (int p = 0; p < couplings_[c].corners; ++p) {
      const PointKey key = keyOf(c, p);
      if (number_.count(key) == 0) continue;
      isEmpty = isEmpty && stay.count(key) == 0;
      if (largest < 0 || coveredShare(couplings_[c], p) > coveredShare(couplings_[c], largest)) largest = p;
    }
    if (isEmpty && largest >= 0) stay.insert(keyOf(c, largest));
  }
  const std::size_t before = number_.size();
  keep(stay);
  return static_cast<int>(before - number_.size());
}

void PointBuilder::addFace(std::size_t coupling, const std::vector<int>& points, Corners& corners,
                           JoinedSurface& surface) const {
  const int count = static_cast<int>(number_.size());
  std::vector<int> face;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const PointKey key = keyOf(coupling, static_cast<int>(p));
    if (creased_.count(key) == 0) {
      if (points[p] < 0) return;
      face.push_back(points[p]);
      continue;
    }
    const auto [corner, isNew] = corners.emplace(key, count + static_cast<int>(surface.creased.size()));
    if (isNew) {
      const std::size_t n = points.size();
      const int heirs[] = {points[p], points[(p + 1) % n], points[(p + n - 1) % n], points[(p + 2) % n]};
      surface.creased.push_back({key.first, *std::find_if(heirs, heirs + 4, [](int heir) { return heir >= 0; }), {}});
    }
    face.push_back(corner->second);
  }
  surface.face.push_back(face);
}

JoinedSurface PointBuilder::build() const {
  JoinedSurface surface;
  for (const auto& [key, number] : number_) {
    surface.node.push_back(key.first);
    surface.patch.push_back(key.second);
  }
  const std::size_t count = number_.size();
  surface.area.assign(count, 0.0);
  surface.normal.assign(count, base::Vector3{});
  std::array<Rows, 2> rows = {Rows(count), Rows(count)};
  Corners corners;
  double whole = 0.0;
  for (std::size_t c = 0; c < couplings_.size(); ++c) {
    const FaceCoupling& face = couplings_[c];
    std::vector<int> points;
    std::array<bool, FaceShape::mostCorners> isKept{};
    for (int p = 0; p < face.corners; ++p) {
      points.push_back(numberOf(keyOf(c, p)));
      isKept[p] = points[p] >= 0;
      whole += face.whole[p];
    }
    if (std::none_of(isKept.begin(), isKept.end(), [](bool is) { return is; })) {
      const auto adopted = adopted_.find(static_cast<int>(c));
      if (adopted == adopted_.end()) continue;
      points[0] = numberOf(adopted->second);  // with the constant function, as the only corner that is kept
      isKept[0] = true;
    }
    const DualBasis basis(face, isKept);
    for (int p = 0; p < face.corners; ++p) {
      if (!isKept[p]) continue;
      surface.area[points[p]] += basis.areas()[p];
      for (int q = 0; q < face.corners; ++q) {
        surface.normal[points[p]] = surface.normal[points[p]] + basis.shares()[p][q] * face.normal[q];
      }
    }
    for (int side = 0; side < 2; ++side) rows[side].add(face.columns[side], basis.coefficients(), points);
    addFace(c, points, corners, surface);
  }
  for (int side = 0; side < 2; ++side) surface.trace[side] = rows[side].build(surface.area);
  const double covered = std::accumulate(surface.area.begin(), surface.area.end(), 0.0);
  surface.report.leftOut = leftOut_;
  surface.report.uncovered[0] = whole > 0.0 ? std::max(0.0, 1.0 - covered / whole) : 0.0;
  return surface;
}

}  // namespace harmos::mortar
