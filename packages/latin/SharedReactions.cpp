#include <harmos/latin/detail/SharedReactions.hpp>

#include <algorithm>
#include <cmath>
#include <map>

#include <harmos/base/DisjointSets.hpp>
#include <harmos/latin/detail/SymmetricEigen.hpp>

namespace harmos::latin {
namespace {

using assembly::Assembly;
using assembly::NodeClusters;
using Cluster = NodeClusters::Cluster;

// Of the weights of a sum: a smaller change is none.
constexpr double noAction = 1e-6;

}  // namespace

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
    const ClusterFields local(assembly_, faces_, cluster);
    std::map<std::size_t, Row> forces;  // of the fields of faces that may deform
    for (const NodeClusters::Pair& pair : cluster.pairs) {
      const int f = faces_.faceOf(pair.interface);
      if (f < 0 || face(f).isRigid) continue;
      const auto units = faces_.unitsAt(face(f), pair);
      for (std::size_t k = 0; k < units.size(); ++k) {
        const std::size_t field = first_.at(f) + k;
        group_.fields[field].push_back(local.at(pair, units[k]));
        local.addForces(group_.fields[field].back(), forces.try_emplace(field, local.none()).first->second);
      }
    }
    for (auto& [field, left] : forces) {
      const ClusterFields::Field answer = local.answerTo(left);
      group_.fields[field].insert(group_.fields[field].end(), answer.begin(), answer.end());
    }
    for (std::size_t row = 0; row < local.none().size() && !forces.empty(); ++row) {
      Row condition(ofFaces_, 0.0);
      for (const auto& [field, left] : forces) condition[field] = left[row];
      unmet_.push_back(std::move(condition));
    }
    for (auto& field : local.free()) group_.fields.push_back(std::move(field));
    if (unmet_.size() > mostUnmet + ofFaces_) condense();
  }

  Group group() {
    condense();
    std::vector<Row> rows = unmet_;
    for (Row& row : rows) row.resize(group_.fields.size(), 0.0);
    for (const int f : numbers_) {
      if (face(f).isRigid) addResultants(f, rows);
    }
    group_.conditions = basisOf(rows, ClusterFields::noForce);
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
  void addResultant(int f, const TractionAtPair& at, Row& to) const {
    const base::Vector3 force = (at.root / std::sqrt(face(f).area)) * at.traction;
    const base::Vector3& place = assembly_.interfaces[at.pair.interface].position[at.pair.pair];
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
    const std::vector<Row> basis = basisOf(held, ClusterFields::noForce);
    for (std::size_t j = 0; j < group_.fields.size(); ++j) {
      Row sum(six, 0.0);
      for (const TractionAtPair& at : group_.fields[j]) {
        if (faces_.faceOf(at.pair.interface) == f) addResultant(f, at, sum);
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
    may[f] = faces.all()[f].fields() > 0 && symmetricEigen(alone[f]).front() <= ClusterFields::noForce;
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
    Group group{ClusterFields(assembly, faces, cluster).free(), {}, Open::atNodes};
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
  for (const ClusterFields::Field& field : group.fields) {
    double change = 0.0;
    for (const TractionAtPair& at : field) {
      const auto [weight, isNew] = weights.try_emplace({at.pair.interface, at.pair.pair});
      if (isNew) weight->second = (1.0 / at.root) * weightOf(at.pair.interface, at.pair.pair);
      change += base::dot(weight->second, at.traction);
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
