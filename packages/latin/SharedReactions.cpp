#include <harmos/latin/detail/SharedReactions.hpp>

#include <algorithm>
#include <cmath>
#include <map>

#include <harmos/base/DisjointSets.hpp>
#include <harmos/latin/detail/SymmetricEigen.hpp>

namespace harmos::latin {
namespace {

using assembly::Assembly;
using assembly::Interface;
using assembly::NodeClusters;
using Cluster = NodeClusters::Cluster;
using Row = std::vector<double>;

// Square of what unit fields do to nodes, or of their resultant, below which it is nothing.
constexpr double noForce = 1e-10;
// Of the weights of a sum: a smaller change is none.
constexpr double noAction = 1e-6;

double dot(const Row& a, const Row& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// to += factor x
void add(double factor, const Row& x, Row& to) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += factor * x[i];
}

base::Matrix productsOf(const std::vector<Row>& rows) {
  const int count = static_cast<int>(rows.size());
  base::Matrix products(count, count);
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) products(i, j) = dot(rows[i], rows[j]);
  }
  return products;
}

/// An orthonormal basis of what the rows span.
std::vector<Row> basisOf(const std::vector<Row>& rows) {
  std::vector<Row> basis;
  if (rows.empty()) return basis;
  base::Matrix modes = productsOf(rows);
  const Row values = symmetricEigen(modes);
  for (int j = 0; j < modes.numCols(); ++j) {
    if (values[j] <= noForce) continue;
    basis.emplace_back(rows.front().size(), 0.0);
    for (std::size_t i = 0; i < rows.size(); ++i) add(modes[j][i] / std::sqrt(values[j]), rows[i], basis.back());
  }
  return basis;
}

}  // namespace

/// The tractions of the pairs of a cluster that bear anything by themselves.
class SharedReactions::LocalFields {
 public:
  LocalFields(const Assembly& assembly, const HeldFaces& faces, const Cluster& cluster) : assembly_(assembly) {
    for (const NodeClusters::Pair& pair : cluster.pairs) {
      const Interface& interface = assembly.interfaces[pair.interface];
      for (int side = 0; side < interface.sides(); ++side)
        rows_.emplace(std::pair(interface.body(side), interface.trace(side).node(pair.pair)), 3 * rows_.size());
      largestRoot_ = std::max(largestRoot_, std::sqrt(interface.area[pair.pair]));
    }
    // Of clusters that are too large none is taken.
    if (cluster.pairs.size() > NodeClusters::mostPairs) return;
    for (const NodeClusters::Pair& pair : cluster.pairs) {
      for (const base::Vector3& axis : faces.axesOf(pair)) {
        unknowns_.push_back(share(pair, axis));
        columns_.push_back(none());
        addForces(unknowns_.back(), columns_.back());
      }
    }
    if (unknowns_.empty()) return;
    modes_ = productsOf(columns_);
    values_ = symmetricEigen(modes_);
  }

  Share share(const NodeClusters::Pair& pair, const base::Vector3& field) const {
    return {pair, std::sqrt(assembly_.interfaces[pair.interface].area[pair.pair]), field};
  }
  Row none() const { return Row(3 * rows_.size(), 0.0); }
  /// Nodal forces over the largest sqrt(h).
  void addForces(const Share& share, Row& forces) const {
    const Interface& interface = assembly_.interfaces[share.pair.interface];
    for (int side = 0; side < interface.sides(); ++side) {
      const std::size_t row = rows_.at({interface.body(side), interface.trace(side).node(share.pair.pair)});
      const double factor = (side == 0 ? share.root : -share.root) / largestRoot_;
      for (std::size_t c = 0; c < 3; ++c) forces[row + c] += factor * share.field[c];
    }
  }

  /// A basis of those that no node feels, with orthonormal t sqrt(h).
  std::vector<std::vector<Share>> free() const {
    std::vector<std::vector<Share>> fields;
    for (int j = 0; j < modes_.numCols(); ++j) {
      if (isFree(j)) fields.push_back(fieldOf({modes_[j], modes_[j] + modes_.numRows()}));
    }
    return fields;
  }

  /// Their field that takes as much of nodal forces as they can; what they cannot is left in `forces`.
  std::vector<Share> answerTo(Row& forces) const {
    Row factors(unknowns_.size(), 0.0);
    for (int j = 0; j < modes_.numCols(); ++j) {
      if (isFree(j)) continue;
      double work = 0.0;
      for (std::size_t i = 0; i < columns_.size(); ++i) work += modes_[j][i] * dot(columns_[i], forces);
      for (std::size_t i = 0; i < columns_.size(); ++i) factors[i] -= work / values_[j] * modes_[j][i];
    }
    for (std::size_t i = 0; i < columns_.size(); ++i) add(factors[i], columns_[i], forces);
    return fieldOf(factors);
  }

 private:
  bool isFree(int mode) const { return values_[mode] <= noForce * values_.back(); }

  std::vector<Share> fieldOf(const Row& factors) const {
    std::vector<Share> field = unknowns_;
    for (std::size_t i = 0; i < field.size(); ++i) field[i].field = factors[i] * field[i].field;
    return field;
  }

  const Assembly& assembly_;
  std::map<NodeClusters::Node, std::size_t> rows_;
  double largestRoot_ = 0.0;
  std::vector<Share> unknowns_;  // pairs with unit vectors
  std::vector<Row> columns_;     // their forces
  base::Matrix modes_;
  Row values_;
};

/// Faces that clusters connect.
class SharedReactions::FaceFields {
 public:
  FaceFields(const Assembly& assembly, const HeldFaces& faces, std::vector<int> numbers)
      : assembly_(assembly), faces_(faces), numbers_(std::move(numbers)) {
    for (const int f : numbers_) {
      first_[f] = group_.fields.size();
      if (!face(f).isRigid) group_.fields.resize(group_.fields.size() + face(f).fields());
    }
    ofFaces_ = group_.fields.size();
  }

  void take(const Cluster& cluster) {
    const LocalFields local(assembly_, faces_, cluster);
    std::map<std::size_t, Row> forces;  // of the fields of faces that may deform
    for (const NodeClusters::Pair& pair : cluster.pairs) {
      const int f = faces_.faceOf(pair.interface);
      if (f < 0 || face(f).isRigid) continue;
      const auto units = faces_.unitsAt(face(f), pair);
      for (std::size_t k = 0; k < units.size(); ++k) {
        const std::size_t field = first_.at(f) + k;
        group_.fields[field].push_back(local.share(pair, units[k]));
        local.addForces(group_.fields[field].back(), forces.try_emplace(field, local.none()).first->second);
      }
    }
    for (auto& [field, left] : forces) {
      const std::vector<Share> answer = local.answerTo(left);
      group_.fields[field].insert(group_.fields[field].end(), answer.begin(), answer.end());
    }
    for (std::size_t row = 0; row < local.none().size() && !forces.empty(); ++row) {
      Row condition(ofFaces_, 0.0);
      for (const auto& [field, left] : forces) condition[field] = left[row];
      unmet_.push_back(std::move(condition));
    }
    for (auto& field : local.free()) group_.fields.push_back(std::move(field));
    if (unmet_.size() > mostUnmet) condense();
  }

  Group group() {
    condense();
    std::vector<Row> rows = unmet_;
    for (Row& row : rows) row.resize(group_.fields.size(), 0.0);
    for (const int f : numbers_) {
      if (face(f).isRigid) addResultants(f, rows);
    }
    group_.conditions = basisOf(rows);
    return std::move(group_);
  }

 private:
  static constexpr std::size_t mostUnmet = 200;

  const HeldFaces::Face& face(int f) const { return faces_.all()[f]; }

  /// Leaves of the conditions on the faces that may deform as many as there are fields of them.
  void condense() {
    if (unmet_.size() <= ofFaces_) return;
    std::vector<Row> columns(ofFaces_, Row(unmet_.size(), 0.0));
    for (std::size_t i = 0; i < unmet_.size(); ++i) {
      for (std::size_t j = 0; j < ofFaces_; ++j) columns[j][i] = unmet_[i][j];
    }
    base::Matrix modes = productsOf(columns);
    const Row values = symmetricEigen(modes);
    unmet_.clear();
    for (int j = 0; j < modes.numCols(); ++j) {
      if (values[j] <= 0.0) continue;
      Row row(modes[j], modes[j] + modes.numRows());
      for (double& value : row) value *= std::sqrt(values[j]);
      unmet_.push_back(std::move(row));
    }
  }

  /// Force and moment about the centre, over the largest sqrt(h) and the size.
  void addResultant(int f, const Share& share, Row& to) const {
    const base::Vector3 force = (share.root / std::sqrt(face(f).area)) * share.field;
    const base::Vector3& place = assembly_.interfaces[share.pair.interface].position[share.pair.pair];
    const base::Vector3 moment = (1.0 / face(f).size) * base::cross(place - face(f).centre, force);
    for (std::size_t c = 0; c < 3; ++c) {
      to[c] += force[c];
      to[3 + c] += moment[c];
    }
  }

  /// The resultant of a rigid face is one of those that it holds.
  void addResultants(int f, std::vector<Row>& rows) const {
    constexpr std::size_t six = 6;
    std::vector<Row> held(face(f).fields(), Row(six, 0.0));
    for (const std::size_t i : face(f).interfaces) {
      for (int p = 0; p < assembly_.interfaces[i].pairs(); ++p) {
        const HeldFaces::Pair pair{static_cast<int>(i), p};
        const auto units = faces_.unitsAt(face(f), pair);
        for (std::size_t k = 0; k < units.size(); ++k)
          addResultant(f, {pair, std::sqrt(assembly_.interfaces[i].area[p]), units[k]}, held[k]);
      }
    }
    for (Row& one : held) {
      const double norm = std::sqrt(dot(one, one));
      for (double& value : one) value /= norm;
    }
    std::vector<Row> resultants(six, Row(group_.fields.size(), 0.0));
    const std::vector<Row> basis = basisOf(held);
    for (std::size_t j = 0; j < group_.fields.size(); ++j) {
      Row sum(six, 0.0);
      for (const Share& share : group_.fields[j]) {
        if (faces_.faceOf(share.pair.interface) == f) addResultant(f, share, sum);
      }
      for (const Row& one : basis) add(-dot(one, sum), one, sum);
      for (std::size_t c = 0; c < six; ++c) resultants[c][j] = sum[c];
    }
    rows.insert(rows.end(), resultants.begin(), resultants.end());
  }

  const Assembly& assembly_;
  const HeldFaces& faces_;
  std::vector<int> numbers_;
  std::map<int, std::size_t> first_;  // of the fields of a face that may deform
  std::size_t ofFaces_ = 0;           // those fields
  std::vector<Row> unmet_;            // what nodes ask of them
  Group group_;
};

namespace {

/// Of every face whether what other pairs at its nodes bear may leave something of it open.
std::vector<bool> mayShare(const HeldFaces& faces, const NodeClusters& clusters) {
  std::vector<bool> may(faces.all().size(), false);
  std::vector<base::Matrix>
      alone;  // products of the fields of a face over the pairs that have their node for themselves
  for (const HeldFaces::Face& face : faces.all()) alone.emplace_back(face.fields(), face.fields());
  for (const Cluster& cluster : clusters.all()) {
    for (const NodeClusters::Pair& pair : cluster.pairs) {
      const int f = faces.faceOf(pair.interface);
      if (f < 0) continue;
      if (cluster.pairs.size() > 1) may[f] = true;
      if (cluster.pairs.size() > 1 || faces.all()[f].isRigid) continue;
      const auto units = faces.unitsAt(faces.all()[f], pair);
      for (std::size_t i = 0; i < units.size(); ++i) {
        for (std::size_t j = 0; j < units.size(); ++j)
          alone[f](static_cast<int>(i), static_cast<int>(j)) += base::dot(units[i], units[j]);
      }
    }
  }
  for (std::size_t f = 0; f < may.size(); ++f) {
    if (!may[f] || faces.all()[f].isRigid) continue;
    may[f] = faces.all()[f].fields() > 0 && symmetricEigen(alone[f]).front() <= noForce;
  }
  return may;
}

}  // namespace

SharedReactions::SharedReactions(const Assembly& assembly, const assembly::SearchDirection& searchDirection,
                                 const EliminatedBoundaries& eliminated) {
  HeldFaces faces(assembly, searchDirection, eliminated);
  const NodeClusters ofBoundaries = faces.clusters(false);
  for (const Cluster& cluster : ofBoundaries.all()) {
    if (cluster.pairs.size() < 2) continue;
    Group group{LocalFields(assembly, faces, cluster).free(), {}, Open::atNodes};
    if (!group.fields.empty()) groups_.push_back(std::move(group));
  }
  if (faces.all().empty()) return;
  NodeClusters clusters = faces.clusters(true);
  // A face that shares nothing is given to others' nodes, which may share nothing then, either.
  for (std::vector<bool> may = mayShare(faces, clusters); std::count(may.begin(), may.end(), false) > 0;
       may = mayShare(faces, clusters)) {
    faces.keep(may);
    if (faces.all().empty()) return;
    clusters = faces.clusters(true);
  }
  base::DisjointSets sets(faces.all().size());
  std::vector<std::pair<int, const Cluster*>> ofFaces;
  for (const Cluster& cluster : clusters.all()) {
    int first = -1;
    for (const NodeClusters::Pair& pair : cluster.pairs) {
      const int f = faces.faceOf(pair.interface);
      if (f >= 0 && first >= 0) sets.join(f, first);
      if (f >= 0) first = f;
    }
    if (first >= 0) ofFaces.emplace_back(first, &cluster);
  }
  std::map<int, std::vector<int>> connected;
  for (int f = 0; f < static_cast<int>(faces.all().size()); ++f) connected[sets.root(f)].push_back(f);
  for (const auto& [root, numbers] : connected) {
    FaceFields fields(assembly, faces, numbers);
    for (const auto& [face, cluster] : ofFaces) {
      if (sets.root(face) == root) fields.take(*cluster);
    }
    Group group = fields.group();
    group.whatItLeaves = Open::atFaces;
    if (!group.fields.empty()) groups_.push_back(std::move(group));
  }
}

bool SharedReactions::change(const Group& group, const std::function<base::Vector3(int, int)>& weightOf) {
  std::map<std::pair<int, int>, base::Vector3> weights;  // over sqrt(h)
  Row changes;
  for (const std::vector<Share>& field : group.fields) {
    double change = 0.0;
    for (const Share& share : field) {
      const auto [at, isNew] = weights.try_emplace({share.pair.interface, share.pair.pair});
      if (isNew) at->second = (1.0 / share.root) * weightOf(share.pair.interface, share.pair.pair);
      change += base::dot(at->second, share.field);
    }
    changes.push_back(change);
  }
  double size = 0.0;
  for (const auto& [pair, weight] : weights) size += base::dot(weight, weight);
  for (const Row& condition : group.conditions) add(-dot(condition, changes), condition, changes);
  return dot(changes, changes) > noAction * noAction * size;
}

SharedReactions::Open SharedReactions::leaveOpen(const std::function<base::Vector3(int, int)>& weightOf) const {
  Open open = Open::no;
  for (const Group& group : groups_) {
    if (group.whatItLeaves > open && change(group, weightOf)) open = group.whatItLeaves;
  }
  return open;
}

}  // namespace harmos::latin
