#include "CalculixDeck.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <ostream>
#include <set>

#include <harmos/base/Error.hpp>
#include <harmos/mesh/Elements.hpp>
#include <harmos/mesh/FaceIntegrals.hpp>

namespace harmos::benchmarks {
namespace {

using input::Parameters;

/// How CalculiX calls an element: its type, the node of Exodus in each place, its face 1, 2, ... by side of Exodus.
struct Element {
  const char* name;
  std::vector<int> node;
  std::vector<int> face;
};

std::vector<int> inOrder(int count) {
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

/// Reduced integration of hexahedra of second degree, as CalculiX' manual advises; nothing for other elements.
std::optional<Element> calculixElement(mesh::ElementType type) {
  switch (type) {
    case mesh::ElementType::hex8:
      return Element{"C3D8", inOrder(8), {3, 4, 5, 6, 1, 2}};
    case mesh::ElementType::hex20: {
      std::vector<int> node = inOrder(20);
      std::rotate(node.begin() + 12, node.begin() + 16, node.end());  // the edges above come before the upright ones
      return Element{"C3D20R", node, {3, 4, 5, 6, 1, 2}};
    }
    case mesh::ElementType::tet4:
      return Element{"C3D4", inOrder(4), {2, 3, 4, 1}};
    case mesh::ElementType::tet10:
      return Element{"C3D10", inOrder(10), {2, 3, 4, 1}};
    default:
      return std::nullopt;
  }
}

constexpr std::array<const char*, 3> axes{"X", "Y", "Z"};

[[noreturn]] void refuse(const std::string& where, const std::string& what) {
  throw base::Error(where + ": " + what + " cannot be written as a CalculiX deck.", base::ExitCode::input);
}

class Writer {
 public:
  Writer(std::ostream& out, const scene::Scene& scene, const scene::Problem& problem)
      : out_(out), scene_(scene), problem_(problem), elements_(problem.mesh) {
    out_.precision(13);  // CalculiX reads 20 characters of a number
  }

  void write(const ContactPenalty& contact) {
    mesh();
    materials();
    for (const Parameters& interface : scene_.input.lists("Interfaces")) {
      const Parameters& law = interface.list("Law");
      if (law.type() == "Coulomb Friction") {
        contactPair(interface, law, contact);
      } else if (law.type() == "Preload Jump") {
        preload(interface, law);
      } else {
        refuse(interface.where(), "the law " + law.type());
      }
    }
    for (const Parameters& boundary : scene_.input.lists("Boundaries")) nodeSet(boundary.name());
    for (const Parameters& response : scene_.input.lists("Responses")) {
      if (response.type() == "Mean Displacement") mean(response);
    }
    steps();
  }

 private:
  struct Reference {
    int node;
    const Parameters* law;
  };

  void mesh() {
    out_ << "*NODE, NSET=ALL\n";
    for (std::size_t i = 0; i < problem_.mesh.nodes.size(); ++i) {
      const base::Vector3& x = problem_.mesh.nodes[i];
      out_ << i + 1 << ", " << x[0] << ", " << x[1] << ", " << x[2] << "\n";
    }
    int element = 0;
    for (const mesh::ElementBlock& block : problem_.mesh.blocks) {
      const auto type = calculixElement(block.type);
      if (!type) refuse("block " + block.name, mesh::exodusName(block.type));
      out_ << "*ELEMENT, TYPE=" << type->name << ", ELSET=" << block.name << "\n";
      for (int e = 0; e < block.elements(); ++e) {
        out_ << ++element;
        for (std::size_t n = 0; n < type->node.size(); ++n) {
          // At most 16 entries fit on a line.
          out_ << (n == 15 ? ",\n" : ", ")
               << block.connectivity[type->node.size() * static_cast<std::size_t>(e) + type->node[n]] + 1;
        }
        out_ << "\n";
      }
    }
  }

  void materials() {
    for (const Parameters& material : scene_.input.lists("Materials")) {
      if (material.type() != "Isotropic") refuse(material.where(), "the material type " + material.type());
      out_ << "*MATERIAL, NAME=" << material.name() << "\n*ELASTIC\n"
           << material.number("Young's Modulus") << ", " << material.number("Poisson's Ratio") << "\n";
    }
    for (const Parameters& part : scene_.input.lists("Parts")) {
      if (part.has("Pieces") && part.integer("Pieces") != 1) refuse(part.where(), "a part cut into pieces");
      const std::vector<std::string> own{part.name()};
      for (const std::string& block : part.has("Blocks") ? part.texts("Blocks") : own)
        out_ << "*SOLID SECTION, ELSET=" << block << ", MATERIAL=" << part.text("Material") << "\n";
    }
  }

  const mesh::SideSet& sideSet(const std::string& name) const {
    const auto& sets = problem_.mesh.sideSets;
    return *std::find_if(sets.begin(), sets.end(), [&](const mesh::SideSet& set) { return set.name == name; });
  }

  int faceOf(const mesh::SideSet& set, std::size_t i) const {
    return calculixElement(elements_.type(set.element[i]))->face[set.side[i]];
  }

  void surface(const std::string& name) {
    if (!written_.insert(name).second) return;
    const mesh::SideSet& set = sideSet(name);
    out_ << "*SURFACE, NAME=" << name << ", TYPE=ELEMENT\n";
    for (std::size_t i = 0; i < set.element.size(); ++i) out_ << set.element[i] + 1 << ", S" << faceOf(set, i) << "\n";
  }

  void contactPair(const Parameters& interface, const Parameters& law, const ContactPenalty& contact) {
    if (!interface.has("Side 1")) refuse(interface.where(), "an interface without side sets");
    surface(interface.text("Side 1"));
    surface(interface.text("Side 2"));
    out_ << "*SURFACE INTERACTION, NAME=" << interface.name() << "\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n"
         << contact.penalty << "\n*FRICTION\n"
         << law.number("Friction Coefficient") << ", " << contact.stick
         << "\n*CONTACT PAIR, INTERACTION=" << interface.name() << ", TYPE=SURFACE TO SURFACE\n"
         << interface.text("Side 1") << ", " << interface.text("Side 2") << "\n";
  }

  const mesh::InterfaceSurface& interfaceSurface(const std::string& name) const {
    const auto& all = problem_.surfaces;
    return *std::find_if(all.begin(), all.end(), [&](const mesh::InterfaceSurface& one) { return one.name == name; });
  }

  int meshNode(int part, int node) const { return problem_.bodies.pieces[part].nodes[node] + 1; }

  void preload(const Parameters& interface, const Parameters& law) {
    const int reference = static_cast<int>(problem_.mesh.nodes.size() + references_.size()) + 1;
    references_.push_back({reference, &law});
    out_ << "*NODE, NSET=" << interface.name() << "\n" << reference << ", 0, 0, 0\n*EQUATION\n";
    const mesh::InterfaceSurface& surface = interfaceSurface(interface.name());
    for (int p = 0; p < surface.pairs(); ++p) {
      for (std::size_t c = 0; c < 3; ++c) {
        const double n = surface.frame[p][0][c];
        const bool isTangential = std::abs(n) < 1e-12;
        out_ << (isTangential ? 2 : 3) << "\n"
             << meshNode(surface.piece2, surface.trace2.node(p)) << ", " << c + 1 << ", 1, "
             << meshNode(surface.piece1, surface.trace1.node(p)) << ", " << c + 1 << ", -1";
        if (!isTangential) out_ << ", " << reference << ", 1, " << n;
        out_ << "\n";
      }
    }
  }

  void nodeSet(const std::string& name) {
    const mesh::InterfaceSurface& surface = interfaceSurface(name);
    out_ << "*NSET, NSET=" << name << "\n";
    for (int p = 0; p < surface.pairs(); ++p) out_ << meshNode(surface.piece1, surface.trace1.node(p)) << "\n";
  }

  void mean(const Parameters& response) {
    std::set<int> nodes;
    std::vector<std::pair<int, double>> weights;
    double area = 0.0;
    const mesh::SideSet& set = sideSet(response.text("Side Set"));
    for (std::size_t i = 0; i < set.element.size(); ++i) {
      const std::vector<int> corners = elements_.side(set.element[i], set.side[i]);
      const mesh::FaceIntegrals face = mesh::integrateFace(3, mesh::pointsOf(problem_.mesh, corners), 1.0);
      for (std::size_t c = 0; c < corners.size(); ++c) {
        weights.emplace_back(corners[c] + 1, face.weight[c].share);
        nodes.insert(corners[c] + 1);
        area += face.weight[c].share;
      }
    }
    out_ << "** MEAN " << response.name();
    for (const double component : response.numbers("Direction")) out_ << " " << component;
    out_ << "\n";
    for (const auto& [node, weight] : weights) out_ << "** WEIGHT " << node << " " << weight / area << "\n";
    out_ << "*NSET, NSET=mean_" << response.name() << "\n";
    for (const int node : nodes) out_ << node << "\n";
    printed_.push_back("mean_" + response.name());
  }

  void steps() {
    int last = -1;  // increment at the end of the step
    for (const Parameters& step : scene_.input.lists("Steps")) {
      const double duration = step.number("Duration");
      const int increments = step.integer("Increments");
      last += increments;
      const double size = duration / increments;
      out_ << "** " << step.name() << "\n*STEP, INC=1000, NLGEOM=NO\n*STATIC\n"
           << size << ", " << duration << ", " << 1e-4 * size << ", " << size << "\n";
      for (const Reference& reference : references_)
        out_ << "*BOUNDARY\n" << reference.node << ", 1, 1, " << reference.law->schedule("Jump")[last] << "\n";
      for (const Parameters& boundary : scene_.input.lists("Boundaries")) load(boundary, last);
      for (const std::string& set : printed_) out_ << "*NODE PRINT, NSET=" << set << "\nU\n";
      for (const Parameters& interface : scene_.input.lists("Interfaces")) {
        if (interface.list("Law").type() == "Preload Jump")
          out_ << "*NODE PRINT, NSET=" << interface.name() << "\nRF\n";
      }
      out_ << "*END STEP\n";
    }
  }

  void load(const Parameters& boundary, int increment) {
    const Parameters& law = boundary.list("Law");
    if (law.type() == "Prescribed Displacement") {
      for (std::size_t c = 0; c < 3; ++c) {
        if (!law.has(axes[c])) continue;
        out_ << "*BOUNDARY\n"
             << boundary.name() << ", " << c + 1 << ", " << c + 1 << ", " << law.schedule(axes[c])[increment] << "\n";
      }
      return;
    }
    if (law.type() != "Prescribed Traction") refuse(boundary.where(), "the law " + law.type());
    const mesh::SideSet& set = sideSet(boundary.text("Side Set"));
    base::Vector3 traction{};
    for (std::size_t c = 0; c < 3; ++c) traction[c] = law.schedule(axes[c])[increment];
    out_ << "*DLOAD\n";
    for (std::size_t i = 0; i < set.element.size(); ++i) {
      const auto corners = mesh::pointsOf(problem_.mesh, elements_.side(set.element[i], set.side[i]));
      base::Vector3 normal{};
      for (const mesh::NodalWeight& weight : mesh::integrateFace(3, corners, 1.0).weight) normal = normal + weight.flux;
      const double length = std::hypot(normal[0], normal[1], normal[2]);
      double pull = 0.0;
      for (std::size_t c = 0; c < 3; ++c) pull += traction[c] * normal[c] / length;
      for (std::size_t c = 0; c < 3; ++c) {
        if (std::abs(traction[c] - pull * normal[c] / length) > 1e-9 * std::abs(pull))
          refuse(boundary.where(), "a traction that is not normal to its faces");
      }
      out_ << set.element[i] + 1 << ", P" << faceOf(set, i) << ", " << -pull << "\n";
    }
  }

  std::ostream& out_;
  const scene::Scene& scene_;
  const scene::Problem& problem_;
  mesh::Elements elements_;
  std::vector<Reference> references_;  // of the preloads
  std::vector<std::string> printed_;   // node sets
  std::set<std::string> written_;      // surfaces
};

}  // namespace

void writeCalculixDeck(std::ostream& out, const scene::Scene& scene, const scene::Problem& problem,
                       const ContactPenalty& contact) {
  Writer(out, scene, problem).write(contact);
}

}  // namespace harmos::benchmarks
