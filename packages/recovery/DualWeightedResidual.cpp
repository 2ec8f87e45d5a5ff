#include <harmos/recovery/DualWeightedResidual.hpp>

#include <algorithm>
#include <array>
#include <cmath>

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

  /// a : C^-1 : b of six components each.
  double product(const double* a, const double* b) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < components_.size(); ++i) {
      for (std::size_t j = 0; j < components_.size(); ++j) {
        sum += a[components_[i]] * inverse_(static_cast<int>(i), static_cast<int>(j)) * b[components_[j]];
      }
    }
    return sum;
  }

 private:
  std::vector<std::size_t> components_;
  base::Matrix inverse_;
};

/// sigma* - sigma at a point, six components of every column.
void difference(const elasticity::ElementPoint& point, const base::Matrix& nodal, std::vector<double>& result) {
  for (int column = 0; column < nodal.numCols(); ++column) {
    for (int m = 0; m < 6; ++m) {
      double recovered = 0.0;
      for (int a = 0; a < point.nodes; ++a) recovered += point.value[a] * nodal[column][6 * point.node[a] + m];
      result[6 * column + m] = recovered - point.stress[6 * column + m];
    }
  }
}

}  // namespace

PartResidual dualWeightedResidual(const elasticity::ElasticPart& part, const base::Matrix& displacements,
                                  const std::vector<bool>& boundary, const std::vector<KnownFace>& faces,
                                  const std::vector<bool>& skipped) {
  const int columns = displacements.numCols(), responses = columns - 1;
  const StressRecovery recovery(part, boundary, displacements);
  base::Matrix corrected(recovery.stress());
  correctTractions(faces, skipped, elasticity::componentsOf(part.kinematics), corrected);
  const Compliance compliance(part.material, part.kinematics);

  PartResidual result;
  for (auto* list : {&result.change, &result.absolute, &result.uncorrected, &result.work, &result.absoluteWork}) {
    list->assign(responses, 0.0);
  }
  std::vector<double> ofElement(responses, 0.0), workOfElement(responses, 0.0), raw(6 * columns), best(6 * columns);
  int element = 0;
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
                             if (point.element != element) close();
                             element = point.element;
                             difference(point, recovery.stress(), raw);
                             difference(point, corrected, best);
                             for (int j = 0; j < responses; ++j) {
                               const int at = 6 * (j + 1);
                               ofElement[j] += point.volume * compliance.product(best.data(), best.data() + at);
                               workOfElement[j] += point.volume * compliance.product(point.stress, point.stress + at);
                               result.uncorrected[j] += point.volume * compliance.product(raw.data(), raw.data() + at);
                             }
                             result.errorEnergy += point.volume * compliance.product(best.data(), best.data());
                             result.energy += point.volume * compliance.product(point.stress, point.stress);
                           });
  close();
  return result;
}

}  // namespace harmos::recovery
