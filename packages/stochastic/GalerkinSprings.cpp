#include <harmos/stochastic/GalerkinSprings.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/chaos/GalerkinMatrix.hpp>

namespace harmos::stochastic {
namespace {

// Stiffnesses that differ by less are one and the same, probed with round-off.
constexpr double same = 1e-12;
// A line that the probe meets with more than all but this share of its stiffness meets a rigid law.
constexpr double rigid = 1e-12;
// Smallest eigenvalue of a positive definite matrix, relative to the largest.
constexpr double positive = 1e-12;

bool isConstant(const std::vector<double>& values) {
  const double first = values[0];
  return std::all_of(values.begin(), values.end(), [first](double value) {
    return value == first || std::abs(value - first) <= same * std::abs(first);
  });
}

}  // namespace

GalerkinSprings::Probe GalerkinSprings::probe(const interface::Interface& interface,
                                              const std::vector<std::shared_ptr<const laws::InterfaceLaw>>& laws,
                                              int step, double compliance) const {
  Probe result;
  const auto tractionOf = [&](const laws::InterfaceLaw& law, const laws::LocalLine& line) {
    laws::LocalState state;
    law.solve(step, {1, &line, interface.gap.data(), nullptr, nullptr, &state});
    return state.traction;
  };
  for (const auto& law : laws) {
    laws::LocalLine line;
    line.compliance = compliance;
    const laws::Vector3 atRest = tractionOf(*law, line);
    for (std::size_t c = 0; c < 3; ++c) {
      line.freeJump = {};
      line.freeJump[c] = 1.0;
      const double slope = tractionOf(*law, line)[c] - atRest[c];
      const double rest = 1.0 - slope * compliance;
      result.stiffness[c].push_back(std::abs(rest) <= rigid ? std::numeric_limits<double>::infinity() : slope / rest);
      result.offset = std::max(result.offset, std::abs(atRest[c]));
    }
  }
  return result;
}

GalerkinSprings::Decomposition GalerkinSprings::decompose(const std::string& name, std::vector<double> stiffness,
                                                          const Projection& projection) const {
  const int terms = projection.terms();
  Decomposition result;
  result.values.assign(static_cast<std::size_t>(terms), stiffness[0]);
  result.vectors.shape(terms, terms);
  if (isConstant(stiffness)) {
    for (int a = 0; a < terms; ++a) result.vectors(a, a) = 1.0;
    result.stiffness = std::move(stiffness);
    return result;
  }
  if (std::any_of(stiffness.begin(), stiffness.end(), [](double k) { return std::isinf(k); })) {
    throw base::Error("interface \"" + name + "\": its stiffness is infinite in some realisations and not in others",
                      base::ExitCode::input);
  }
  result.vectors = chaos::galerkinMatrix(*projection.basis(), projection.quadrature(), stiffness);
  std::vector<double> work(static_cast<std::size_t>(4 * terms));
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

GalerkinSprings::GalerkinSprings(const interface::Interface& interface,
                                 const std::vector<std::shared_ptr<const laws::InterfaceLaw>>& laws,
                                 const Projection& projection, int steps, double compliance) {
  for (const auto& law : laws) {
    if (law->isAffine()) continue;
    throw base::Error("interface \"" + interface.name + "\": the law \"" + law->name() +
                          "\" is not affine, and the Galerkin local stage treats affine laws only; choose the "
                          "pseudo-spectral local stage",
                      base::ExitCode::input);
  }
  const bool isShared = std::all_of(laws.begin(), laws.end(), [&](const auto& law) { return law == laws[0]; });
  if (isShared) return;
  double offset = 0.0;
  for (int step = 0; step < steps; ++step) {
    Probe found = probe(interface, laws, step, compliance);
    offset = std::max(offset, found.offset);
    for (auto& stiffness : found.stiffness) {
      isRandom_ = isRandom_ || !isConstant(stiffness);
      const auto known = std::find_if(decompositions_.begin(), decompositions_.end(),
                                      [&](const Decomposition& one) { return one.stiffness == stiffness; });
      which_.push_back(static_cast<std::size_t>(known - decompositions_.begin()));
      if (known == decompositions_.end()) {
        decompositions_.push_back(decompose(interface.name, std::move(stiffness), projection));
      }
    }
  }
  if (isRandom_ && offset > 0.0) {
    throw base::Error("interface \"" + interface.name + "\": the law \"" + laws[0]->name() +
                          "\" has a random stiffness and a traction without a jump, which the Galerkin local stage "
                          "does not treat; choose the pseudo-spectral local stage",
                      base::ExitCode::input);
  }
}

void GalerkinSprings::solve(int step, const std::vector<laws::LocalLine>& lines, const base::Matrix& freeJumps,
                            base::Matrix& tractions) const {
  const int pairs = static_cast<int>(lines.size());
  const int terms = freeJumps.numCols();
  tractions.shapeUninitialized(freeJumps.numRows(), terms);
  base::Matrix jumps(pairs, terms), rotated(pairs, terms);
  for (int c = 0; c < 3; ++c) {
    const Decomposition& spring = decompositions_[which_[static_cast<std::size_t>(3 * step + c)]];
    for (int a = 0; a < terms; ++a) {
      for (int p = 0; p < pairs; ++p) jumps(p, a) = freeJumps(3 * p + c, a);
    }
    rotated.multiply(Teuchos::NO_TRANS, Teuchos::NO_TRANS, 1.0, jumps, spring.vectors, 0.0);
    for (int j = 0; j < terms; ++j) {
      // Finite also for a rigid component and for one that carries nothing.
      const double softness = 1.0 / spring.values[static_cast<std::size_t>(j)];
      for (int p = 0; p < pairs; ++p) rotated(p, j) /= softness + lines[static_cast<std::size_t>(p)].compliance;
    }
    jumps.multiply(Teuchos::NO_TRANS, Teuchos::TRANS, 1.0, rotated, spring.vectors, 0.0);
    for (int a = 0; a < terms; ++a) {
      for (int p = 0; p < pairs; ++p) tractions(3 * p + c, a) = jumps(p, a);
    }
  }
}

}  // namespace harmos::stochastic
