#include <harmos/stochastic/GalerkinSprings.hpp>

#include <algorithm>
#include <cmath>

#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/probability/GalerkinMatrix.hpp>
#include <harmos/stochastic/AffineComponents.hpp>

namespace harmos::stochastic {
namespace {

// Smallest eigenvalue of a positive definite matrix, relative to the largest.
constexpr double positive = 1e-12;

}  // namespace

GalerkinSprings::Decomposition GalerkinSprings::decompose(const std::string& name, std::vector<double> stiffness,
                                                          const Projection& projection) {
  const int terms = projection.terms();
  Decomposition result;
  result.values.assign(terms, stiffness[0]);
  result.vectors.shape(terms, terms);
  if (areSame(stiffness)) {
    for (int a = 0; a < terms; ++a) result.vectors(a, a) = 1.0;
    result.stiffness = std::move(stiffness);
    return result;
  }
  if (std::any_of(stiffness.begin(), stiffness.end(), [](double k) { return std::isinf(k); })) {
    throw base::Error("interface \"" + name + "\": its stiffness is infinite in some realisations and not in others",
                      base::ExitCode::input);
  }
  result.vectors = probability::galerkinMatrix(*projection.basis(), projection.quadrature(), stiffness);
  std::vector<double> work(4 * terms);
  int info = 0;
  Teuchos::LAPACK<int, double>().SYEV('V', 'U', terms, result.vectors.values(), result.vectors.stride(),
                                      result.values.data(), work.data(), static_cast<int>(work.size()), &info);
  if (info != 0 || !(result.values.front() > positive * result.values.back())) {
    throw base::Error(
        "interface \"" + name +
            "\": the Galerkin matrix of its random stiffness is not positive definite, because the "
            "stiffness is negative with too large a probability; choose a law of probability for positive "
            "numbers (lognormal), a smaller coefficient of variation or a lower order",
        base::ExitCode::input);
  }
  result.stiffness = std::move(stiffness);
  return result;
}

GalerkinSprings::GalerkinSprings(const assembly::Interface& interface,
                                 const std::vector<std::shared_ptr<const laws::InterfaceLaw>>& laws,
                                 const Projection& projection, int steps, double compliance) {
  for (const auto& law : laws) affineComponents(*law, 0, compliance, interface.name);
  const bool isShared = std::all_of(laws.begin(), laws.end(), [&](const auto& law) { return law == laws[0]; });
  if (isShared) return;
  const auto points = laws.size();
  const auto terms = static_cast<std::size_t>(projection.terms());
  for (int step = 0; step < steps; ++step) {
    std::vector<double> stiffness[3], offset[3];
    for (const auto& law : laws) {
      const auto found = affineComponents(*law, step, compliance, interface.name);
      for (std::size_t c = 0; c < 3; ++c) {
        stiffness[c].push_back(found[c].stiffness);
        offset[c].push_back(found[c].offset);
      }
    }
    for (std::size_t c = 0; c < 3; ++c) {
      isRandom_ = isRandom_ || !areSame(stiffness[c]);
      const auto known = std::find_if(decompositions_.begin(), decompositions_.end(),
                                      [&](const Decomposition& one) { return one.stiffness == stiffness[c]; });
      const auto at = static_cast<std::size_t>(known - decompositions_.begin());
      if (known == decompositions_.end()) {
        decompositions_.push_back(decompose(interface.name, std::move(stiffness[c]), projection));
      }
      Component component{at, std::vector<double>(terms, 0.0)};
      for (std::size_t j = 0; j < terms; ++j) {
        for (std::size_t a = 0; a < terms; ++a) {
          double coefficient = 0.0;
          for (std::size_t q = 0; q < points; ++q) {
            coefficient += projection.projector()(static_cast<int>(a), static_cast<int>(q)) * offset[c][q];
          }
          component.offset[j] += decompositions_[at].vectors(static_cast<int>(a), static_cast<int>(j)) * coefficient;
        }
      }
      components_.push_back(std::move(component));
    }
  }
}

void GalerkinSprings::solve(int step, const std::vector<laws::LocalLine>& lines, const base::Matrix& freeJumps,
                            base::Matrix& tractions) const {
  const int pairs = static_cast<int>(lines.size());
  const int terms = freeJumps.numCols();
  tractions.shapeUninitialized(freeJumps.numRows(), terms);
  base::Matrix jumps(pairs, terms), rotated(pairs, terms);
  for (int c = 0; c < 3; ++c) {
    const Component& component = components_[3 * static_cast<std::size_t>(step) + static_cast<std::size_t>(c)];
    const Decomposition& spring = decompositions_[component.decomposition];
    for (int a = 0; a < terms; ++a) {
      for (int p = 0; p < pairs; ++p) jumps(p, a) = freeJumps(3 * p + c, a);
    }
    rotated.multiply(Teuchos::NO_TRANS, Teuchos::NO_TRANS, 1.0, jumps, spring.vectors, 0.0);
    for (int j = 0; j < terms; ++j) {
      const double lambda = spring.values[j];
      const double offset = component.offset[j];
      for (int p = 0; p < pairs; ++p) {
        const double compliance = lines[p].compliance;
        double& value = rotated(p, j);
        value = std::isinf(lambda) ? (value - offset) / compliance
                                   : (lambda * value + offset) / (1.0 + lambda * compliance);
      }
    }
    jumps.multiply(Teuchos::NO_TRANS, Teuchos::TRANS, 1.0, rotated, spring.vectors, 0.0);
    for (int a = 0; a < terms; ++a) {
      for (int p = 0; p < pairs; ++p) tractions(3 * p + c, a) = jumps(p, a);
    }
  }
}

}  // namespace harmos::stochastic
