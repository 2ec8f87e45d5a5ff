#include <harmos/elasticity/Stiffness.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/base/UsableNumbers.hpp>
#include <harmos/elasticity/detail/Axis.hpp>
#include <harmos/elasticity/detail/ElementLoop.hpp>
#include <harmos/elasticity/detail/StrainOperator.hpp>
#include <harmos/substructure/CrsMatrix.hpp>

namespace harmos::elasticity {
namespace {

/// For every node its neighbours and itself, ascending, in compressed rows.
struct NodeGraph {
  std::vector<std::size_t> pointers;
  std::vector<int> neighbours;

  NodeGraph(const std::vector<ElementGroup>& groups, std::size_t nodes) : pointers(nodes + 1, 0) {
    struct Touch {
      const ElementGroup* group;
      int element;
    };
    std::vector<std::size_t> start(nodes + 1, 0);
    for (const ElementGroup& group : groups) {
      for (const int node : group.nodes) ++start[node + 1];
    }
    for (std::size_t node = 0; node < nodes; ++node) start[node + 1] += start[node];
    std::vector<Touch> touches(start[nodes]);
    std::vector<std::size_t> next(start.begin(), start.end() - 1);
    for (const ElementGroup& group : groups) {
      const int perElement = group.nodesPerElement();
      for (std::size_t k = 0; k < group.nodes.size(); ++k) {
        touches[next[group.nodes[k]]++] = {&group, static_cast<int>(k) / perElement};
      }
    }
    std::vector<int> lastSeenBy(nodes, -1);
    for (std::size_t node = 0; node < nodes; ++node) {
      const std::size_t begin = neighbours.size();
      for (std::size_t k = start[node]; k < start[node + 1]; ++k) {
        const ElementGroup& group = *touches[k].group;
        const int* nodesOfElement = group.nodesOf(touches[k].element);
        const int perElement = group.nodesPerElement();
        for (int a = 0; a < perElement; ++a) {
          const int neighbour = nodesOfElement[a];
          int& seenBy = lastSeenBy[neighbour];
          if (seenBy == static_cast<int>(node)) continue;
          seenBy = static_cast<int>(node);
          neighbours.push_back(neighbour);
        }
      }
      std::sort(neighbours.begin() + static_cast<std::ptrdiff_t>(begin), neighbours.end());
      pointers[node + 1] = neighbours.size();
    }
  }

  int degree(int node) const { return static_cast<int>(pointers[node + 1] - pointers[node]); }
  int positionOf(int neighbour, int node) const {
    const int* begin = neighbours.data() + pointers[node];
    return static_cast<int>(std::lower_bound(begin, begin + degree(node), neighbour) - begin);
  }
};

/// Turns the integrals of an element into its stiffness: both are linear in each other, so C enters once per element.
///
/// With D displacement components and G gradients g per function, and the strains E_k g_k u of StrainOperator,
/// K_ab = sum_kl E_k^t C E_l int g_ak g_bl dV. With B-bar the strain gains I/3 (mean - local) volume change
/// sum_k T_k g_k u, T_k = I:E_k, and with D_ab = int g_a g_b^t dV - G_a G_b^t/V, G_a = int g_a dV, P_k = E_k^t C:I the
/// block gains -(P D_ab T^t + T D_ab P^t)/3 + (I:C:I) T D_ab T^t/9.
template <int D, int G>
class ElementStiffness {
 public:
  ElementStiffness(const ElasticityMatrix& c, Formulation formulation, const StrainOperator& strain, double thickness)
      : bBar_(formulation == Formulation::bBar) {
    for (const StrainOperator::Term& first : strain.terms) {
      const int i = first.component, k = first.gradient;
      const std::size_t m = first.strain;
      for (const StrainOperator::Term& second : strain.terms) {
        c_[i][second.component][k][second.gradient] += first.sign * second.sign * thickness * c[m][second.strain];
      }
      pressure_[i][k] += first.sign * thickness * (c[m][0] + c[m][1] + c[m][2]);
      if (m < 3) volume_[i][k] += 1.0;
    }
    for (std::size_t m = 0; m < 3; ++m) bulk_ += thickness * (c[m][0] + c[m][1] + c[m][2]);
  }

  /// Upper triangle of the node blocks, a <= b, in rows of D x functions; diagonal blocks are whole and symmetric.
  /// Incompatible modes are eliminated: no force acts on them.
  void compute(const ElementIntegrals& integrals, const ElementBasis& basis, double* stiffness) const {
    const int functions = basis.functions(), dofs = D * functions, entries = G * functions;
    for (int a = 0; a < functions; ++a) {
      for (int b = a; b < functions; ++b) {
        double m[G][G], block[D][D];
        for (int k = 0; k < G; ++k) {
          for (int l = 0; l < G; ++l) m[k][l] = integrals.product.data()[(G * a + k) * entries + G * b + l];
        }
        for (int i = 0; i < D; ++i) {
          for (int j = 0; j < D; ++j) {
            double sum = 0.0;
            for (int k = 0; k < G; ++k) {
              for (int l = 0; l < G; ++l) sum += c_[i][j][k][l] * m[k][l];
            }
            block[i][j] = sum;
          }
        }
        if (bBar_) addMeanDilatation(integrals, a, b, m, block);
        for (int i = 0; i < D; ++i) {
          for (int j = 0; j < D; ++j) {
            stiffness[(D * a + i) * dofs + D * b + j] = a == b && j < i ? block[j][i] : block[i][j];
          }
        }
      }
    }
    for (int last = dofs - 1; last >= D * basis.reference.nodes; --last) eliminate(last, dofs, stiffness);
  }

 private:
  /// Eliminates the last dof that is left, whose force is 0.
  static void eliminate(int last, int stride, double* stiffness) {
    for (int i = 0; i < last; ++i) {
      const double factor = stiffness[i * stride + last] / stiffness[last * stride + last];
      for (int j = i / D * D; j < last; ++j) {
        // The lower triangle of a diagonal block is that of the upper one, to the last bit.
        stiffness[i * stride + j] =
            j < i ? stiffness[j * stride + i] : stiffness[i * stride + j] - factor * stiffness[j * stride + last];
      }
    }
  }

  void addMeanDilatation(const ElementIntegrals& integrals, int a, int b, double (&m)[G][G],
                         double (&block)[D][D]) const {
    const double* ga = integrals.gradient.data() + G * a;
    const double* gb = integrals.gradient.data() + G * b;
    for (int k = 0; k < G; ++k) {
      for (int l = 0; l < G; ++l) m[k][l] -= ga[k] * gb[l] / integrals.volume;
    }
    double left[D][G] = {}, right[G][D] = {};  // T D_ab, D_ab T^t
    for (int i = 0; i < D; ++i) {
      for (int k = 0; k < G; ++k) {
        for (int l = 0; l < G; ++l) {
          left[i][k] += volume_[i][l] * m[l][k];
          right[k][i] += m[k][l] * volume_[i][l];
        }
      }
    }
    for (int i = 0; i < D; ++i) {
      for (int j = 0; j < D; ++j) {
        double sum = 0.0, both = 0.0;
        for (int k = 0; k < G; ++k) {
          sum += pressure_[i][k] * right[k][j] + left[i][k] * pressure_[j][k];
          both += volume_[i][k] * right[k][j];
        }
        block[i][j] += bulk_ / 9.0 * both - sum / 3.0;
      }
    }
  }

  double c_[D][D][G][G] = {};
  double pressure_[D][G] = {};
  double volume_[D][G] = {};
  double bulk_ = 0.0;
  bool bBar_;
};

void checkFormulation(const mesh::Mesh& mesh, const mesh::Piece& piece, const std::vector<ElementGroup>& groups,
                      Formulation formulation, Kinematics kinematics) {
  if (formulation == Formulation::incompatibleModes &&
      std::none_of(groups.begin(), groups.end(),
                   [](const ElementGroup& group) { return hasIncompatibleModes(group.block->type); })) {
    throw base::Error("The formulation Incompatible Modes is asked for " + nameOf(mesh, piece, groups[0], 0) + ", a " +
                          mesh::exodusName(groups[0].block->type) +
                          ", but only HEX8 and QUAD4 elements have such modes. Use Full Integration.",
                      base::ExitCode::input);
  }
  if (formulation == Formulation::incompatibleModes && isAxisymmetric(kinematics)) {
    throw base::Error(
        "Part \"" + piece.part +
            "\" asks for the formulation Incompatible Modes in axisymmetry, where such modes would change "
            "the stress around the hoop. Use Full Integration, or quadratic elements.",
        base::ExitCode::input);
  }
  if (formulation != Formulation::bBar) return;
  if (kinematics == Kinematics::planeStress) {
    throw base::Error("Part \"" + piece.part +
                          "\" asks for the formulation B-Bar in plane stress, where nothing locks as "
                          "Poisson's ratio approaches 0.5. Use Full Integration.",
                      base::ExitCode::input);
  }
  for (const ElementGroup& group : groups) {
    const mesh::ElementType type = group.block->type;
    if (mesh::isQuadratic(type)) {
      throw base::Error(
          "The formulation B-Bar is asked for " + nameOf(mesh, piece, group, 0) + ", a " + mesh::exodusName(type) +
              ", but it is made for linear elements. Use HEX8 or QUAD4 elements, or Full Integration with "
              "Poisson's ratio below about 0.49.",
          base::ExitCode::input);
    }
    if (type != mesh::ElementType::tri3 && type != mesh::ElementType::tet4) continue;
    throw base::Error(
        "The formulation B-Bar is asked for " + nameOf(mesh, piece, group, 0) + ", a " + mesh::exodusName(type) +
            ", whose volume change is constant already: it would lock all the same. Use HEX8 or QUAD4 elements, "
            "or Full Integration with Poisson's ratio below about 0.45.",
        base::ExitCode::input);
  }
}

template <int D, int G>
Teuchos::RCP<base::CrsMatrix> assemble(const mesh::Mesh& mesh, const mesh::Piece& piece,
                                       const std::vector<ElementGroup>& groups, Formulation formulation,
                                       Kinematics kinematics, const ElementStiffness<D, G>& element) {
  const std::size_t nodes = piece.nodes.size();
  const NodeGraph graph(groups, nodes);
  std::vector<std::size_t> pointers(1, 0);
  pointers.reserve(D * nodes + 1);
  for (std::size_t node = 0; node < nodes; ++node) {
    for (int i = 0; i < D; ++i)
      pointers.push_back(pointers.back() + D * static_cast<std::size_t>(graph.degree(static_cast<int>(node))));
  }
  substructure::CrsRows matrix(pointers);
  int* column = matrix.columns();
  for (std::size_t node = 0; node < nodes; ++node) {
    for (int i = 0; i < D; ++i) {
      for (std::size_t k = graph.pointers[node]; k < graph.pointers[node + 1]; ++k) {
        for (int j = 0; j < D; ++j) *column++ = D * graph.neighbours[k] + j;
      }
    }
  }
  double* const values = matrix.values();
  std::fill_n(values, matrix.entries(), 0.0);
  const std::vector<bool> isFixed = nodesOnAxis(mesh, piece, kinematics);
  double stiffness[ElementIntegrals::maximumDofs * ElementIntegrals::maximumDofs];
  forEachElement(
      mesh, piece, groups, formulation, kinematics, true,
      [&](const ElementGroup& group, int number, const ElementBasis& basis, const ElementIntegrals& integrals) {
        const int perElement = group.nodesPerElement(), dofs = D * basis.functions();
        const int* local = group.nodesOf(number);
        element.compute(integrals, basis, stiffness);
        for (int a = 0; a < perElement; ++a) {
          const int stride = D * graph.degree(local[a]);
          double* rows = values + pointers[D * static_cast<std::size_t>(local[a])];
          for (int b = 0; b < perElement; ++b) {
            double* block = rows + D * graph.positionOf(local[b], local[a]);
            for (int i = 0; i < D; ++i) {
              for (int j = 0; j < D; ++j) {
                // A displacement that is 0 couples with nothing.
                const bool isDiagonal = a == b && i == j;
                if (!isDiagonal && ((isFixed[local[a]] && !isFreeOnAxis(i)) || (isFixed[local[b]] && !isFreeOnAxis(j))))
                  continue;
                block[i * stride + j] +=
                    a <= b ? stiffness[(D * a + i) * dofs + D * b + j] : stiffness[(D * b + j) * dofs + D * a + i];
              }
            }
          }
        }
      });
  return substructure::makeCrsMatrix(std::move(matrix));
}

Teuchos::RCP<base::CrsMatrix> demandUsable(const Teuchos::RCP<base::CrsMatrix>& stiffness, const std::string& part) {
  const substructure::CrsView entries = substructure::viewOf(*stiffness, part);
  const double* const end = entries.values + entries.rowPointers[entries.rows];
  const double* const found = std::find_if_not(entries.values, end, base::isUsable);
  if (found == end) return stiffness;
  throw base::Error("Part \"" + part + "\": its stiffness matrix has an entry " + base::toText(*found) +
                        "; entries must be finite and not beyond " + base::toText(base::largestNumber) +
                        ". Give the moduli of its material, or the coordinates of its nodes, in other units.",
                    base::ExitCode::input);
}

}  // namespace

Teuchos::RCP<base::CrsMatrix> assembleStiffness(const mesh::Mesh& mesh, const mesh::Piece& piece,
                                                const Material& material, Formulation formulation,
                                                Kinematics kinematics, double thickness) {
  const std::vector<ElementGroup> groups = groupsOf(mesh, piece, kinematics);
  checkFormulation(mesh, piece, groups, formulation, kinematics);
  const ElasticityMatrix c = reduced(material.elasticity(), kinematics);
  const StrainOperator strain(kinematics);
  const auto assembled = [&](const auto& element) {
    return demandUsable(assemble(mesh, piece, groups, formulation, kinematics, element), piece.part);
  };
  if (kinematics == Kinematics::threeDimensional) return assembled(ElementStiffness<3, 3>(c, formulation, strain, 1.0));
  if (kinematics == Kinematics::axisymmetricWithTorsion)
    return assembled(ElementStiffness<3, 3>(c, formulation, strain, 1.0));
  if (isAxisymmetric(kinematics)) return assembled(ElementStiffness<2, 3>(c, formulation, strain, 1.0));
  return assembled(ElementStiffness<2, 2>(c, formulation, strain, thickness));
}

}  // namespace harmos::elasticity
