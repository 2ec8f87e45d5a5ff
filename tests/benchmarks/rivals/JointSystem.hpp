#pragma once

#include <string>
#include <vector>

#include <harmos/base/Matrix.hpp>

#include "../Study.hpp"
#include "SparseMatrix.hpp"

namespace harmos::benchmarks {

/// A whole joint as one system of equations, K x = sum of a_k f_k + contact forces, for methods that are not LATIN.
///
/// Unknowns x: displacements of the nodes with the contacts closed and bonded, the two nodes of a pair being one, then
/// the jumps w of the contact pairs in their frames, (n, t1, t2) each [length]. Node 2 of a pair moves by u1 + Q^T w.
/// Contact forces act on the jumps only, (p, -q): p >= 0 the pressure times the area of a pair, q the friction along
/// its slip [force]. a_k(step) are amplitudes, f_k the forces of a unit of each: preloads, prescribed displacements and
/// tractions. Matrices, pairs and areas are those of Harmos' assembly.
class JointSystem {
 public:
  /// `study` must outlive it. Throws base::Error (input), naming the entry, for what is not a joint of this kind: other
  /// laws than Coulomb Friction without a gap, Preload Jump, Prescribed Displacement and Prescribed Traction; meshes
  /// that do not match; nodes in several interfaces with two sides, or in one whose second side is held; body forces.
  explicit JointSystem(const Study& study);

  /// K, with the jumps as its last rows.
  const SparseMatrix& matrix() const { return matrix_; }
  int pairs() const { return static_cast<int>(friction_.size()); }
  int jumps() const { return 3 * pairs(); }
  int unknowns() const { return matrix_.rows(); }
  /// The first unknown that is a jump.
  int firstJump() const { return unknowns() - jumps(); }
  /// f_k: unknowns x cases.
  const base::Matrix& forces() const { return forces_; }

  /// Linear responses of the scene: value = readers^T x + offsets^T a. Others are left out.
  const std::vector<std::string>& responses() const { return responses_; }
  const base::Matrix& readers() const { return readers_; }  ///< unknowns x responses
  const base::Matrix& offsets() const { return offsets_; }  ///< cases x responses

  /// a_k of a scene that differs from the study's in numbers only: cases x load steps. Throws base::Error when it asks
  /// for a case that was 0 at all steps of the study's.
  base::Matrix amplitudes(const scene::Scene& scene) const;
  /// Friction coefficient of every pair at a load step of such a scene.
  std::vector<double> frictions(const scene::Scene& scene, int step) const;

 private:
  struct Share {
    int index;
    double weight;
  };
  /// An entry of a law in the scene that moves or loads the joint.
  struct Case {
    const char* list;  // Interfaces or Boundaries
    std::string name;
    std::string entry;
    base::Matrix offset;  // of the bodies' degrees of freedom [length per unit]
    base::Matrix load;    // on them [force per unit]
  };

  void join(const assembly::Interface& interface, const input::Parameters& law);
  void bound(const assembly::Interface& interface, const input::Parameters& law);
  Case& addCase(const char* list, const std::string& name, const std::string& entry);
  void number();
  void makeMatrix();
  void makeForces();
  void makeReaders();
  /// K u of the bodies that are not joined.
  base::Matrix product(const base::Matrix& u) const;
  /// Forces on the bodies' degrees of freedom as forces on the unknowns.
  void reduce(const double* from, double* to) const;
  int dof(int body, int node) const { return firstDof_[body] + 3 * node; }

  const Study& study_;
  std::vector<int> firstDof_;               // of every body, and behind the last
  std::vector<int> master_;                 // per dof of bodies: that of the node's partner, or itself
  std::vector<char> isHeld_;                // per dof of bodies
  std::vector<std::vector<Share>> shares_;  // per dof of bodies: the unknowns it is made of
  std::vector<std::pair<int, const assembly::Interface*>> friction_;  // per pair: first dof of its node 2; interface
  std::vector<base::Frame> frame_;                                    // per pair
  std::vector<SparseMatrix> stiffness_;                               // per body
  std::vector<Case> cases_;
  SparseMatrix matrix_;
  base::Matrix forces_, readers_, offsets_;
  std::vector<std::string> responses_;
};

}  // namespace harmos::benchmarks
