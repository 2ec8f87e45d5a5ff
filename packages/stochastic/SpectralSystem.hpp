#pragma once

#include <memory>
#include <vector>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/base/Matrix.hpp>
#include <harmos/base/Tpetra.hpp>
#include <harmos/stochastic/Projection.hpp>
#include <harmos/stochastic/Realisations.hpp>

namespace harmos::stochastic {

/// Equations of Galerkin's method for an assembly of elastic bodies and linear interfaces without interface unknowns:
/// A = K_0 (x) I + sum over j of K_j (x) G_j.
///
/// K_0 holds the bodies and what is not random, K_j the interface mass in one component of a random interface (force
/// per unit stiffness), G_j = E[k_j psi_a psi_b]. Unknown (dof, polynomial) has the number dof * terms + polynomial,
/// with the dofs of the bodies one after the other. Held dofs keep their rows, as identities.
///
/// Limits: affine laws with constant stiffness in time, rigid ones on outer boundaries along an axis only, and a
/// consistent interface mass on plane interfaces only. Throws base::Error (input) naming the interface otherwise, and
/// naming the part when this process does not hold its own stiffness matrix.
class SpectralSystem {
 public:
  /// Keeps nothing of its arguments. `laws`: of every point of the projection.
  SpectralSystem(const assembly::Assembly& assembly, const std::shared_ptr<const Projection>& projection,
                 const Realisations& laws);

  /// Of space: 2 or 3.
  int dimension() const { return dimension_; }
  /// Of all bodies, held ones included.
  int dofs() const { return dofs_; }
  /// Number of the first dof of a body's node; the others of the node follow.
  int dofOf(int body, int node) const { return firstDof_[body] + dimension_ * node; }
  /// y = A x for one column of dofs x terms numbers: x displacements [length], y forces [force], held dofs as they are.
  void apply(const double* x, double* y) const;
  /// (dofs x terms) x load steps [force], with the values of held dofs [length].
  const base::Matrix& right() const { return right_; }
  /// K_0 + sum over j of E[k_j] K_j, held dofs as in A: dofs x dofs.
  Teuchos::RCP<base::CrsMatrix> meanMatrix() const;
  /// A: (dofs x terms) x (dofs x terms).
  Teuchos::RCP<base::CrsMatrix> wholeMatrix() const;

 private:
  struct Entry {
    int row;
    int column;
    double value;
  };
  struct Rows {  // a sparse matrix: rows that have entries
    std::vector<int> number;
    std::vector<std::size_t> begin;
    std::vector<int> column;
    std::vector<double> value;
  };
  struct Random {
    Rows matrix;
    base::Matrix galerkin;
  };

  static Rows compressed(std::vector<Entry> entries);
  static Teuchos::RCP<base::CrsMatrix> crsMatrix(std::vector<Entry> entries);
  void addBodies(const assembly::Assembly& assembly, std::vector<Entry>& entries);
  void addLoads(const assembly::Interface& boundary, const std::vector<double>& times);
  void addInterface(const assembly::Interface& interface,
                    const std::vector<std::shared_ptr<const laws::InterfaceLaw>>& laws, const Projection& projection,
                    std::vector<Entry>& entries);
  std::vector<Entry> springs(const assembly::Interface& interface, std::size_t component) const;
  void addOffset(const assembly::Interface& interface, std::size_t component, int column, double traction);
  void hold(const assembly::Interface& interface, std::size_t component, int column, double jump);
  /// y = A x as if no dof were held.
  void applyFree(const double* x, double* y) const;
  double& at(base::Matrix& vectors, int dof, int column) const;

  int dimension_;
  int terms_;
  int steps_;
  int dofs_ = 0;
  std::vector<int> firstDof_;
  std::vector<char> isHeld_;  // per dof
  Rows constant_;
  std::vector<Random> random_;
  base::Matrix held_;  // values of held dofs
  base::Matrix right_;
};

}  // namespace harmos::stochastic
