#include <harmos/recovery/DualWeightedResidual.hpp>

#include <algorithm>
#include <cmath>

#include <Teuchos_BLAS.hpp>
#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/recovery/StressRecovery.hpp>
#include <harmos/recovery/detail/StressSamples.hpp>

namespace harmos::recovery {
namespace {

/// A root R of the compliance, R^T R = C^-1 [1/stress], on the components of stress that work in the kinematics: with
/// it a : C^-1 : b is the scalar product of R a and R b.
class ComplianceRoot {
 public:
  ComplianceRoot(const elasticity::Material& material, elasticity::Kinematics kinematics, int columns)
      : components_(elasticity::workingComponents(kinematics)), columns_(columns) {
    const elasticity::ElasticityMatrix c = elasticity::reduced(material.elasticity(), kinematics);
    root_.shape(rows(), rows());
    for (int i = 0; i < rows(); ++i) {
      for (int j = 0; j <= i; ++j) root_(i, j) = c[components_[i]][components_[j]];
    }
    // C = L L^T, so that R = L^-1.
    int info = 0;
    const Teuchos::LAPACK<int, double> lapack;
    lapack.POTRF('L', rows(), root_.values(), root_.stride(), &info);
    if (info == 0) lapack.TRTRI('L', 'N', rows(), root_.values(), root_.stride(), &info);
    if (info != 0) throw base::Error("the elasticity of a material is not positive");
  }

  /// Of R.
  int rows() const { return static_cast<int>(components_.size()); }
  /// R a of all columns, six components x columns: rows() x columns.
  void multiply(const double* a, double* result) const {
    std::fill_n(result, rows() * columns_, 0.0);
    for (int i = 0; i < rows(); ++i) {
      double* to = result + static_cast<std::ptrdiff_t>(i) * columns_;
      for (int j = 0; j <= i; ++j) {
        const double factor = root_(i, j);
        if (factor == 0.0) continue;
        const double* from = a + components_[j] * static_cast<std::size_t>(columns_);
        for (int k = 0; k < columns_; ++k) to[k] += factor * from[k];
      }
    }
  }
  /// The same of all nodes, a column each.
  base::Matrix multiply(const base::Matrix& a) const {
    base::Matrix result(rows() * columns_, a.numCols());
    for (int node = 0; node < a.numCols(); ++node) multiply(a[node], result[node]);
    return result;
  }

 private:
  std::vector<std::size_t> components_;
  int columns_;
  base::Matrix root_;  // lower triangle
};

/// Products of fields over one element: int a : C^-1 : b dV of all columns and the solutions, which come first.
class ElementProducts {
 public:
  ElementProducts(int columns, int solutions, int rows)
      : solutions_(solutions), rows_(rows), sum_(columns, solutions) {}

  /// `roots`: R a, points x rows x columns.
  const base::Matrix& find(const elasticity::ElementPoints& at, const double* roots) {
    const int columns = sum_.numRows(), count = at.points * rows_;
    weighted_.resize(static_cast<std::size_t>(count) * static_cast<std::size_t>(solutions_));
    for (int i = 0; i < count; ++i) {
      for (int s = 0; s < solutions_; ++s)
        weighted_[i * solutions_ + s] = at.volume[i / rows_] * roots[i * columns + s];
    }
    Teuchos::BLAS<int, double>().GEMM(Teuchos::NO_TRANS, Teuchos::TRANS, columns, solutions_, count, 1.0, roots,
                                      columns, weighted_.data(), solutions_, 0.0, sum_.values(), sum_.stride());
    return sum_;
  }

 private:
  int solutions_, rows_;
  std::vector<double> weighted_;
  base::Matrix sum_;
};

/// R (sigma* - sigma) at the points of elements: points x rows x columns.
class Difference {
 public:
  Difference(const base::Matrix& nodal) : nodal_(nodal), width_(nodal.numRows()) {}

  /// `roots`: R sigma there.
  const double* find(const elasticity::ElementPoints& at, const std::vector<double>& roots) {
    atNodes_.resize(static_cast<std::size_t>(at.nodes) * static_cast<std::size_t>(width_));
    for (int a = 0; a < at.nodes; ++a) std::copy_n(nodal_[at.node[a]], width_, atNodes_.data() + a * width_);
    difference_ = roots;
    Teuchos::BLAS<int, double>().GEMM(Teuchos::NO_TRANS, Teuchos::NO_TRANS, width_, at.points, at.nodes, 1.0,
                                      atNodes_.data(), width_, at.value, at.nodes, -1.0, difference_.data(), width_);
    return difference_.data();
  }

 private:
  const base::Matrix& nodal_;
  int width_;
  std::vector<double> atNodes_, difference_;
};

}  // namespace

PartResidual dualWeightedResidual(const elasticity::ElasticPart& part, const base::Matrix& displacements,
                                  const std::vector<AdjointField>& adjoints, const std::vector<bool>& boundary,
                                  const std::vector<KnownFace>& faces, const std::vector<bool>& skipped) {
  const int columns = displacements.numCols(), solutions = columns - static_cast<int>(adjoints.size());
  int responses = 0;
  for (const AdjointField& adjoint : adjoints) responses = std::max(responses, adjoint.response + 1);
  const ComplianceRoot root(part.material, part.kinematics, columns);
  const StressSamples samples(part, displacements);
  base::Matrix nodal = StressRecovery(part, boundary, samples).stress();
  const base::Matrix uncorrected = root.multiply(nodal);
  const std::vector<bool> isCorrected =
      correctTractions(faces, skipped, elasticity::componentsOf(part.kinematics), nodal);
  const base::Matrix corrected = root.multiply(nodal);

  PartResidual result;
  for (auto* list : {&result.change, &result.absolute, &result.uncorrected, &result.work, &result.absoluteWork}) {
    list->assign(responses, 0.0);
  }
  ElementProducts products(columns, solutions, root.rows());
  Difference raw(uncorrected), best(corrected);
  std::vector<double> roots, ofElement(responses);
  // Adds up the adjoints of each response, and hands on what the element brings to it.
  const auto add = [&](const base::Matrix& product, auto&& to) {
    std::fill(ofElement.begin(), ofElement.end(), 0.0);
    for (std::size_t i = 0; i < adjoints.size(); ++i) {
      ofElement[adjoints[i].response] += product(solutions + static_cast<int>(i), adjoints[i].solution);
    }
    for (int j = 0; j < responses; ++j) to(j, ofElement[j]);
  };
  elasticity::visitElements(
      part, elasticity::PointSet::squares, displacements, [&](const elasticity::ElementPoints& at) {
        // The same points, or any.
        const bool isSampled = at.isConstant || samples.of(at.element) == at.points;
        const double* stress = isSampled ? samples.at(samples.first[at.element]) : at.stress();
        const std::size_t width = static_cast<std::size_t>(root.rows()) * static_cast<std::size_t>(columns);
        roots.resize(width * at.points);
        for (int p = 0; p < at.points; ++p) {
          root.multiply(at.isConstant ? stress : stress + samples.width * p, roots.data() + width * p);
        }
        const base::Matrix& ofStress = products.find(at, roots.data());
        result.energy += ofStress(0, 0);
        add(ofStress, [&](int j, double work) {
          result.work[j] += work;
          result.absoluteWork[j] += std::abs(work);
        });
        const base::Matrix& ofError = products.find(at, best.find(at, roots));
        result.errorEnergy += ofError(0, 0);
        add(ofError, [&](int j, double change) {
          result.change[j] += change;
          result.absolute[j] += std::abs(change);
        });
        const bool isSame = std::none_of(at.node, at.node + at.nodes, [&](int node) { return isCorrected[node]; });
        add(isSame ? ofError : products.find(at, raw.find(at, roots)),
            [&](int j, double change) { result.uncorrected[j] += change; });
      });
  return result;
}

}  // namespace harmos::recovery
