#include <harmos/recovery/DualWeightedResidual.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/recovery/StressRecovery.hpp>

namespace harmos::recovery {
namespace {

/// C^-1 [1/stress] on the components of stress that work in the kinematics.
class Compliance {
 public:
  Compliance(const elasticity::Material& material, elasticity::Kinematics kinematics)
      : components_(elasticity::workingComponents(kinematics)) {
    const elasticity::ElasticityMatrix c = elasticity::reduced(material.elasticity(), kinematics);
    const int size = static_cast<int>(components_.size());
    inverse_.shape(size, size);
    for (int i = 0; i < size; ++i) {
      for (int j = 0; j < size; ++j) inverse_(i, j) = c[components_[i]][components_[j]];
    }
    int info = 0;
    const Teuchos::LAPACK<int, double> lapack;
    lapack.POTRF('U', size, inverse_.values(), inverse_.stride(), &info);
    if (info == 0) lapack.POTRI('U', size, inverse_.values(), inverse_.stride(), &info);
    if (info != 0) throw base::Error("the elasticity of a material is not positive");
    for (int i = 0; i < size; ++i) {
      for (int j = 0; j < i; ++j) inverse_(i, j) = inverse_(j, i);
    }
  }

  /// C^-1 : a of six components each; 0 where none works.
  std::array<double, 6> times(const double* a) const {
    std::array<double, 6> result{};
    for (std::size_t i = 0; i < components_.size(); ++i) {
      for (std::size_t j = 0; j < components_.size(); ++j) {
        result[components_[i]] += inverse_(static_cast<int>(i), static_cast<int>(j)) * a[components_[j]];
      }
    }
    return result;
  }

 private:
  std::vector<std::size_t> components_;
  base::Matrix inverse_;
};

double product(const std::array<double, 6>& strain, const double* stress) {
  return std::inner_product(strain.begin(), strain.end(), stress, 0.0);
}

/// Nodal stresses at the points of an element, sigma* - sigma.
class Recovered {
 public:
  explicit Recovered(const base::Matrix& nodal) : nodal_(nodal), size_(6 * nodal.numCols()) {}

  /// Looks at the nodes of the element of a point: those of one column after the other lie apart.
  void gather(const elasticity::ElementPoint& point) {
    atNodes_.resize(static_cast<std::size_t>(point.nodes) * size_);
    for (int a = 0; a < point.nodes; ++a) {
      double* to = atNodes_.data() + a * size_;
      for (int column = 0; column < nodal_.numCols(); ++column) {
        to = std::copy_n(nodal_[column] + 6 * point.node[a], 6, to);
      }
    }
  }

  /// Six components of every column, at a point of that element.
  const double* difference(const elasticity::ElementPoint& point) {
    difference_.assign(size_, 0.0);
    for (int a = 0; a < point.nodes; ++a) {
      const double* from = atNodes_.data() + a * size_;
      for (int i = 0; i < size_; ++i) difference_[i] += point.value[a] * from[i];
    }
    for (int i = 0; i < size_; ++i) difference_[i] -= point.stress[i];
    return difference_.data();
  }

 private:
  const base::Matrix& nodal_;
  int size_;
  std::vector<double> atNodes_, difference_;
};

}  // namespace

PartResidual dualWeightedResidual(const elasticity::ElasticPart& part, const base::Matrix& displacements,
                                  const std::vector<AdjointField>& adjoints, const std::vector<bool>& boundary,
                                  const std::vector<KnownFace>& faces, const std::vector<bool>& skipped) {
  const int solutions = displacements.numCols() - static_cast<int>(adjoints.size());
  int responses = 0;
  for (const AdjointField& adjoint : adjoints) responses = std::max(responses, adjoint.response + 1);
  const StressRecovery recovery(part, boundary, displacements);
  base::Matrix corrected(recovery.stress());
  correctTractions(faces, skipped, elasticity::componentsOf(part.kinematics), corrected);
  const Compliance compliance(part.material, part.kinematics);

  PartResidual result;
  for (auto* list : {&result.change, &result.absolute, &result.uncorrected, &result.work, &result.absoluteWork}) {
    list->assign(responses, 0.0);
  }
  std::vector<double> ofElement(responses, 0.0), workOfElement(responses, 0.0);
  std::vector<std::array<double, 6>> ofRaw(solutions), ofError(solutions), strain(solutions);
  Recovered uncorrected(recovery.stress()), best(corrected);
  int element = -1;
  const auto close = [&] {
    for (int j = 0; j < responses; ++j) {
      result.change[j] += ofElement[j];
      result.absolute[j] += std::abs(ofElement[j]);
      result.work[j] += workOfElement[j];
      result.absoluteWork[j] += std::abs(workOfElement[j]);
      ofElement[j] = workOfElement[j] = 0.0;
    }
  };
  elasticity::forEachPoint(part, elasticity::PointSet::squares, displacements,
                           [&](const elasticity::ElementPoint& point) {
                             if (point.element != element) {
                               close();
                               element = point.element;
                               uncorrected.gather(point);
                               best.gather(point);
                             }
                             const double *rawError = uncorrected.difference(point), *error = best.difference(point);
                             for (int s = 0; s < solutions; ++s) {
                               ofRaw[s] = compliance.times(rawError + 6 * s);
                               ofError[s] = compliance.times(error + 6 * s);
                               strain[s] = compliance.times(point.stress + 6 * s);
                             }
                             int at = 6 * solutions;
                             for (const auto& [s, j] : adjoints) {
                               ofElement[j] += point.volume * product(ofError[s], error + at);
                               workOfElement[j] += point.volume * product(strain[s], point.stress + at);
                               result.uncorrected[j] += point.volume * product(ofRaw[s], rawError + at);
                               at += 6;
                             }
                             result.errorEnergy += point.volume * product(ofError[0], error);
                             result.energy += point.volume * product(strain[0], point.stress);
                           });
  close();
  return result;
}

}  // namespace harmos::recovery
