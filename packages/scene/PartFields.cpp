#include <harmos/scene/detail/PartFields.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/latin/PrescribedForces.hpp>
#include <harmos/mesh/Skin.hpp>

namespace harmos::scene {
namespace {

// Cosine of the angle between the normals of a face and of a point of it: 37 degrees.
constexpr double sameNormal = 0.8;

void fillDisplacements(const Problem& problem, const std::vector<std::vector<std::vector<double>>>& fields,
                       const Teuchos::Comm<int>& comm, WholePart& part) {
  const int dimension = problem.assembly.dimension, columns = static_cast<int>(fields.size());
  const int dofs = dimension * static_cast<int>(part.piece.nodes.size());
  base::Matrix mine(dofs, columns + 1);  // and how many bodies have the dof
  for (const int body : part.bodies) {
    if (fields[0][body].empty()) continue;
    const std::vector<int>& nodes = problem.bodies.pieces[body].nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const int row = dimension * mesh::localNode(part.piece, nodes[i]);
      for (int c = 0; c < dimension; ++c) {
        for (int j = 0; j < columns; ++j) {
          mine(row + c, j) += fields[j][body][static_cast<std::size_t>(dimension) * i + static_cast<std::size_t>(c)];
        }
        mine(row + c, columns) += 1.0;
      }
    }
  }
  base::Matrix sums(mine);
  if (comm.getSize() > 1) {
    Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, dofs * (columns + 1), mine.values(), sums.values());
  }
  part.displacements.shape(dofs, columns);
  for (int j = 0; j < columns; ++j) {
    for (int row = 0; row < dofs; ++row) part.displacements(row, j) = sums(row, j) / sums(row, columns);
  }
}

/// A point of an interface that feels a node of a part.
struct Touch {
  int interface;
  int point;
};

/// Which points feel each node; those between bodies of the part itself count as none.
std::vector<std::vector<Touch>> touchesOf(const Problem& problem, const WholePart& part) {
  std::vector<std::vector<Touch>> touches(part.piece.nodes.size());
  const auto isMine = [&](int body) {
    return body >= 0 && std::count(part.bodies.begin(), part.bodies.end(), body) > 0;
  };
  for (std::size_t i = 0; i < problem.assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = problem.assembly.interfaces[i];
    if (isMine(interface.body1) && isMine(interface.body2)) continue;
    for (int side = 0; side < interface.sides(); ++side) {
      if (!isMine(interface.body(side))) continue;
      const std::vector<int>& nodes = problem.bodies.pieces[interface.body(side)].nodes;
      const mesh::TraceOperator& trace = interface.trace(side);
      for (int p = 0; p < trace.points(); ++p) {
        for (const auto& entry : trace.row(p)) {
          touches[mesh::localNode(part.piece, nodes[entry.node])].push_back({static_cast<int>(i), p});
        }
      }
    }
  }
  return touches;
}

/// Area of a face times its normal out of the part; in the plane with the depth at its middle.
base::Vector3 areaVector(const Problem& problem, const std::vector<int>& nodes) {
  const std::vector<base::Vector3>& x = problem.mesh.nodes;
  if (problem.mesh.dimension == 2) {
    const base::Vector3 along = x[nodes[1]] - x[nodes[0]];
    const double depth = depthOf(problem.model).at(0.5 * (x[nodes[0]] + x[nodes[1]]));
    return depth * base::Vector3{along[1], -along[0], 0.0};
  }
  const int corners = mesh::cornersOfFace(problem.mesh.dimension, nodes.size());
  base::Vector3 sum{};
  for (int i = 0; i < corners; ++i) {
    sum = sum + 0.5 * base::cross(x[nodes[i]] - x[nodes[0]], x[nodes[(i + 1) % corners]] - x[nodes[0]]);
  }
  return sum;
}

/// What tractions are known of the surface of a part.
class Surface {
 public:
  /// `steps`: load steps of the first columns.
  Surface(const Problem& problem, const std::vector<int>& steps, std::size_t columns, WholePart& part)
      : problem_(problem), steps_(steps.size()), columns_(columns), part_(part), touches_(touchesOf(problem, part)) {
    for (std::size_t i = 0; i < problem.assembly.interfaces.size(); ++i) {
      const assembly::Interface& interface = problem.assembly.interfaces[i];
      if (!interface.law->prescribesTraction()) continue;
      std::vector<std::vector<base::Vector3>>& tractions = prescribed_[interface.name][static_cast<int>(i)];
      for (const int step : steps) {
        tractions.push_back(latin::prescribedTractions(interface, problem.assembly.times, step));
      }
    }
    part.boundary.assign(part.piece.nodes.size(), false);
    part.skipped.assign(part.piece.nodes.size(), false);
    for (const mesh::Face& face : mesh::skin(mesh::Elements(problem.mesh), part.piece.elements)) include(face);
  }

  /// Loads of one column, which act on nodes of the part: spread over faces, or concentrated.
  void load(std::size_t column, const std::map<int, base::Vector3>& weights) {
    std::vector<std::size_t> loaded;
    std::vector<bool> isSpread(part_.piece.nodes.size(), false);
    base::Vector3 total{};
    double area = 0.0;
    for (std::size_t f = 0; f < part_.faces.size(); ++f) {
      const std::vector<int>& nodes = part_.faces[f].node;
      if (!std::all_of(nodes.begin(), nodes.end(), [&](int node) { return weights.count(node) > 0; })) continue;
      loaded.push_back(f);
      area += areas_[f];
      for (const int node : nodes) isSpread[node] = true;
    }
    for (const auto& [node, weight] : weights) {
      total = total + weight;
      if (!isSpread[node]) part_.skipped[node] = true;
    }
    for (const std::size_t f : loaded) {
      recovery::KnownFace& face = part_.faces[f];
      face.traction.resize(face.node.size() * columns_, base::Vector3{});
      for (std::size_t a = 0; a < face.node.size(); ++a) face.traction[a * columns_ + column] = (1.0 / area) * total;
    }
  }

 private:
  void include(const mesh::Face& face) {
    recovery::KnownFace known;
    for (const int node : face.nodes) {
      known.node.push_back(mesh::localNode(part_.piece, node));
      part_.boundary[known.node.back()] = true;
    }
    const base::Vector3 vector = areaVector(problem_, face.nodes);
    const double size = base::norm(vector);
    if (size == 0.0) return;  // on the axis
    known.normal = (1.0 / size) * vector;
    std::vector<base::Vector3> traction(known.node.size() * steps_, base::Vector3{});
    bool isLoaded = false;
    for (const std::string& interface : interfacesOf(known.node)) {
      const auto tractions = prescribed_.find(interface);
      if (tractions == prescribed_.end()) return;  // held, or in contact
      isLoaded = addTractions(tractions->second, known, traction) || isLoaded;
    }
    if (isLoaded) {
      known.traction.resize(known.node.size() * columns_, base::Vector3{});
      for (std::size_t a = 0; a < known.node.size(); ++a) {
        std::copy_n(traction.begin() + static_cast<std::ptrdiff_t>(a * steps_), steps_,
                    known.traction.begin() + static_cast<std::ptrdiff_t>(a * columns_));
      }
    }
    part_.faces.push_back(std::move(known));
    areas_.push_back(size);
  }

  /// Tractions of the points of an interface at each step: of each of its pieces, by position in the assembly.
  using Tractions = std::map<int, std::vector<std::vector<base::Vector3>>>;

  /// Names of the interfaces that feel all nodes of a face: where parts are cut, the pieces of one may share them.
  std::vector<std::string> interfacesOf(const std::vector<int>& nodes) const {
    std::map<std::string, std::size_t> counts;
    for (const int node : nodes) {
      std::set<std::string> here;
      for (const Touch& touch : touches_[node]) here.insert(problem_.assembly.interfaces[touch.interface].name);
      for (const std::string& interface : here) ++counts[interface];
    }
    std::vector<std::string> result;
    for (const auto& [interface, count] : counts) {
      if (count == nodes.size()) result.push_back(interface);
    }
    return result;
  }

  bool addTractions(const Tractions& tractions, const recovery::KnownFace& face,
                    std::vector<base::Vector3>& traction) const {
    bool isFound = false;
    for (std::size_t a = 0; a < face.node.size(); ++a) {
      for (const Touch& touch : touches_[face.node[a]]) {
        const auto found = tractions.find(touch.interface);
        if (found == tractions.end()) continue;
        const base::Frame& frame = problem_.assembly.interfaces[touch.interface].frame[touch.point];
        if (base::dot(frame[0], face.normal) < sameNormal) continue;
        for (std::size_t s = 0; s < steps_; ++s) {
          base::Vector3& sum = traction[a * steps_ + s];
          sum = sum + found->second[s][touch.point];
        }
        isFound = true;
        break;
      }
    }
    return isFound;
  }

  const Problem& problem_;
  std::size_t steps_, columns_;
  WholePart& part_;
  std::vector<std::vector<Touch>> touches_;
  std::map<std::string, Tractions> prescribed_;  // by name of the interface
  std::vector<double> areas_;                    // of the known faces
};

}  // namespace

std::vector<WholePart> wholeParts(const Problem& problem, std::vector<PartPieces> pieces,
                                  const std::vector<std::vector<std::vector<double>>>& fields,
                                  const std::vector<int>& steps, const std::vector<latin::ResponseGradient>& loads,
                                  const Teuchos::Comm<int>& comm) {
  std::vector<WholePart> parts;
  for (PartPieces& each : pieces) {
    WholePart& part = parts.emplace_back();
    static_cast<PartPieces&>(part) = std::move(each);
    fillDisplacements(problem, fields, comm, part);
    Surface surface(problem, steps, fields.size(), part);
    for (std::size_t j = 0; j < loads.size(); ++j) {
      std::map<int, base::Vector3> weights;
      for (const latin::ResponseGradient::NodeShare& share : loads[j].nodes) {
        if (std::count(part.bodies.begin(), part.bodies.end(), share.body) == 0) continue;
        base::Vector3& sum = weights[mesh::localNode(part.piece, problem.bodies.pieces[share.body].nodes[share.node])];
        sum = sum + share.weight;
      }
      if (!weights.empty()) surface.load(steps.size() + j, weights);
    }
  }
  return parts;
}

}  // namespace harmos::scene
