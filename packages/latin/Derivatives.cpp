#include <harmos/latin/Derivatives.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <harmos/base/Error.hpp>
#include <harmos/base/SoleThread.hpp>
#include <harmos/latin/NaturalSizes.hpp>
#include <harmos/latin/detail/DerivativeKinks.hpp>
#include <harmos/latin/detail/PairDerivatives.hpp>
#include <harmos/latin/detail/ParameterDifference.hpp>
#include <harmos/laws/AffineComponent.hpp>

namespace harmos::latin {
namespace {

// Tangents are differences with about seven digits; each round gains as many.
constexpr int rounds = 4;
// Of a residual, what a round leaves at most unless round-off, or a kink, is all that is left.
constexpr double gained = 0.5;
constexpr int mostDirections = 400;
// Of those of earlier load steps: beyond, keeping apart from them takes longer than solving for others.
constexpr int mostFromEarlierSteps = 60;
// What is left of a direction beside those of the same block: each is known to 1e-7 where little of it was outside of
// the space, and less than a thousand times that is round-off.
constexpr double leastIndependent = 1e-4;
// Of a residual: beyond it what was found is no derivative.
constexpr double noDerivative = 1e-3;
// Of the step: how far responses that bend are asked once more; kinks are as bent there.
constexpr double shortened = 0.1;
// Of a state, over the step: a derivative as small as this is measured by it, since less is round-off.
constexpr double negligible = 1e-8;
// Of a state: how far it is moved by a parameter whose value is 0, from the first distance on, which grows so often and
// so much where nothing moves.
constexpr double movedShare = 1e-5;
constexpr double firstStep = 1e-6;
constexpr int growths = 3;
constexpr double growth = 1e4;
constexpr double unmoved = 1e-12;
// Of the stiffness of springs in operators.
constexpr double sameStiffness = 1e-12;

double dot(const StateMetric& metric, const double* a, const double* b) {
  std::vector<double> sum{0.0};
  for (std::size_t row = 0; row < metric.scale().size(); ++row) {
    sum[0] += metric.scale()[row] * metric.scale()[row] * a[row] * b[row];
  }
  metric.sum(sum);
  return sum[0];
}

double norm(const StateMetric& metric, const double* a) {
  return std::sqrt(dot(metric, a, a));
}

/// Parameters have their values and load steps their loads again at the end, also after an error.
struct Restore {
  FixedPoint& fixedPoint;
  const std::vector<ModelParameter>& parameters;
  ~Restore() {
    for (const ModelParameter& parameter : parameters) parameter.set(parameter.value);
    fixedPoint.updateLaws();
    fixedPoint.selectAll();
    fixedPoint.startUnloaded();
  }
};

}  // namespace

Derivatives::Derivatives(FixedPoint& fixedPoint, const std::vector<std::shared_ptr<const Response>>& responses,
                         double tolerance)
    : fixedPoint_(fixedPoint),
      responses_(responses),
      tolerance_(tolerance),
      lines_(fixedPoint.assembly(), fixedPoint.searchDirection(), fixedPoint.layout()),
      tangent_(std::in_place, fixedPoint, lines_) {
  if (fixedPoint.assembly().path) {
    throw base::Error("there are no derivatives where the size of loads is to be found", base::ExitCode::input);
  }
}

Derivatives::~Derivatives() = default;

void Derivatives::put(const ModelParameter& parameter, double value) {
  parameter.set(value);
  fixedPoint_.updateLaws();
}

void Derivatives::demandSameOperators(const ModelParameter& parameter, double offset) const {
  const assembly::Assembly& assembly = fixedPoint_.assembly();
  std::vector<std::shared_ptr<const laws::InterfaceLaw>> more;
  parameter.set(parameter.value + offset);
  for (const assembly::Interface& interface : assembly.interfaces) more.push_back(interface.law);
  parameter.set(parameter.value);
  for (std::size_t i = 0; i < more.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    if (!fixedPoint_.eliminated().contains(static_cast<int>(i)) || more[i] == interface.law) continue;
    const double compliance = 1.0 / fixedPoint_.searchDirection().of(static_cast<int>(i))[0];
    for (int t = 0; t < assembly.steps(); ++t) {
      const auto here = laws::affineComponents(*interface.law, t, compliance);
      const auto there = laws::affineComponents(*more[i], t, compliance);
      for (std::size_t c = 0; c < here.size(); ++c) {
        const double k = here[c].stiffness, moved = there[c].stiffness;
        if (k == moved || std::abs(k - moved) <= sameStiffness * std::abs(k)) continue;
        throw base::Error("parameter \"" + parameter.name + "\" changes the stiffness of boundary \"" + interface.name +
                              "\", which stands in the operators. Give the solver the option Elimination::rigid.",
                          base::ExitCode::input);
      }
    }
  }
}

double Derivatives::stepOf(const ModelParameter& parameter) {
  if (parameter.step > 0.0) return parameter.step;
  const StateMetric& metric = fixedPoint_.metric();
  base::Matrix image(alpha_.numRows(), alpha_.numCols());
  fixedPoint_.apply(alpha_, image);
  double size = 0.0;
  for (int t = 0; t < image.numCols(); ++t) size = std::max(size, norm(metric, image[t]));
  double step = firstStep;
  for (int growing = 0; growing < growths; ++growing) {
    try {
      put(parameter, parameter.value + (parameter.side == ModelParameter::Side::below ? -step : step));
    } catch (const base::Error&) {
      return firstStep;  // it has left the values that are admissible, on every rank
    }
    fixedPoint_.apply(alpha_, scratch_);
    put(parameter, parameter.value);
    double change = 0.0;
    for (int t = 0; t < image.numCols(); ++t) {
      for (int row = 0; row < image.numRows(); ++row) scratch_[t][row] -= image[t][row];
      change = std::max(change, norm(metric, scratch_[t]));
    }
    if (size > 0.0 && change > unmoved * size) return step * movedShare * size / change;
    step *= growth;
  }
  return firstStep;
}

std::unique_ptr<PairDerivatives> Derivatives::perturb(const std::vector<ModelParameter>& parameters) {
  const assembly::Assembly& assembly = fixedPoint_.assembly();
  std::vector<PairDerivatives::Laws> laws;
  dbeta_.clear();
  steps_.clear();
  for (const ModelParameter& parameter : parameters) {
    const double step = stepOf(parameter);
    demandSameOperators(parameter, parameter.side == ModelParameter::Side::below ? -step : step);
    steps_.push_back(step);
    laws.emplace_back();
    dbeta_.emplace_back(alpha_.numRows(), alpha_.numCols());
    base::Matrix& change = dbeta_.back();
    for (const DifferencePoint& point : differenceOf(parameter.side, step)) {
      if (point.weight == 0.0) continue;
      put(parameter, parameter.value + point.offset);
      PairDerivatives::Laws::At at{point, {}};
      for (const assembly::Interface& interface : assembly.interfaces) at.laws.push_back(interface.law);
      laws.back().at.push_back(std::move(at));
      fixedPoint_.solveLinear(alpha_, scratch_);
      for (int t = 0; t < change.numCols(); ++t) {
        for (int row = 0; row < change.numRows(); ++row) change[t][row] += point.weight * scratch_[t][row];
      }
    }
    put(parameter, parameter.value);
  }
  return std::make_unique<PairDerivatives>(assembly, lines_, std::move(laws));
}

bool Derivatives::extend(const std::vector<std::vector<double>>& residuals) {
  const StateMetric& metric = fixedPoint_.metric();
  const int rows = alpha_.numRows();
  std::vector<std::vector<double>> block;
  for (std::vector<double> v : residuals) {
    if (!tangent_->space().makeIndependent(v.data())) continue;
    for (int pass = 0; pass < 2; ++pass) {
      for (const std::vector<double>& u : block) {
        const double share = dot(metric, u.data(), v.data());
        for (int row = 0; row < rows; ++row) v[row] -= share * u[row];
      }
    }
    const double length = norm(metric, v.data());
    if (length < leastIndependent || !tangent_->space().makeIndependent(v.data())) continue;
    block.push_back(std::move(v));
  }
  if (block.empty()) {
    std::vector<double> next(rows);
    if (!tangent_->continueKrylov(next)) return false;
    block.push_back(std::move(next));
  }
  const int count = static_cast<int>(block.size());
  base::Matrix v(rows, count), y(rows, count);
  for (int i = 0; i < count; ++i) std::copy(block[i].begin(), block[i].end(), v[i]);
  std::vector<int> selected(count);
  std::iota(selected.begin(), selected.end(), 0);
  fixedPoint_.select(selected);
  fixedPoint_.solveLinear(v, y);
  for (int i = 0; i < count; ++i) tangent_->add(v[i], y[i], true);
  directions_ += count;
  return true;
}

std::vector<bool> Derivatives::solve(const base::Matrix& right, const std::vector<double>& size, base::Matrix& dalpha,
                                     base::Matrix& dbeta) {
  const int rows = right.numRows(), columns = right.numCols();
  std::vector<CorrectionSpace::LeastSquares> fits(columns);
  const auto left = [&] {
    std::vector<std::vector<double>> residuals;
    for (int j = 0; j < columns; ++j) {
      if (size[j] == 0.0) continue;
      fits[j] = tangent_->space().solve(right[j]);
      // Of the solution with what comes; the v are orthonormal.
      double length = norm(fixedPoint_.metric(), dalpha[j]);
      for (const double c : fits[j].c) length = std::hypot(length, c);
      // What the residual can hide is counted against the solution as well.
      const double hidden = fits[j].left / tangent_->space().smallestSingularValue();
      if (fits[j].left <= tolerance_ * size[j] && hidden <= std::sqrt(tolerance_) * length) continue;
      std::vector<double> residual(right[j], right[j] + rows);
      if (!fits[j].c.empty()) tangent_->subtract(fits[j].c, residual);
      residuals.push_back(std::move(residual));
    }
    return residuals;
  };
  for (auto residuals = left(); !residuals.empty(); residuals = left()) {
    if (tangent_->space().size() >= mostDirections || !extend(residuals)) break;
  }
  std::vector<bool> isSolved;
  for (int j = 0; j < columns; ++j) {
    if (!fits[j].c.empty()) tangent_->space().move(fits[j].c, 1.0, dalpha[j], dbeta[j]);
    isSolved.push_back(fits[j].left <= noDerivative * size[j]);
  }
  return isSolved;
}

void Derivatives::march(PairDerivatives& pairs, const std::vector<ModelParameter>& parameters,
                        std::vector<Result>& results) {
  const assembly::Assembly& assembly = fixedPoint_.assembly();
  const StateMetric& metric = fixedPoint_.metric();
  const int rows = alpha_.numRows(), columns = static_cast<int>(results.size());
  // Without loads the linear stage is linear: y of v needs no difference.
  const int cases = std::max({2, columns, assembly.steps()});
  std::vector<base::Matrix> none(assembly.bodies.size());
  for (std::size_t b = 0; b < none.size(); ++b) {
    if (!fixedPoint_.layout().owns(static_cast<int>(b))) continue;
    none[b].shape(assembly.dimension * static_cast<int>(assembly.bodies[b].nodes.size()), cases);
  }
  fixedPoint_.setLoads(none, none);
  PointwiseLocalStage& local = fixedPoint_.pointwiseStage();
  local.startUnloaded();
  local.begin();
  base::Matrix dalpha(rows, columns), dbeta(rows, columns), traction(rows, columns), residual(rows, columns);
  for (int t = 0; t < assembly.steps(); ++t) {
    fixedPoint_.selectAll();
    local.solveColumn(t, beta_, scratch_);
    if (tangent_->space().size() > mostFromEarlierSteps) tangent_.emplace(fixedPoint_, lines_);
    tangent_->differentiate(t, local);
    pairs.meet(t, local);
    local.accept();
    dalpha.putScalar(0.0);
    for (int j = 0; j < columns; ++j) std::copy_n(dbeta_[j][t], rows, dbeta[j]);
    std::vector<double> size(columns, 0.0), before(columns, 0.0), lefts(columns, 0.0);
    std::vector<bool> isSolved(columns, true);
    for (int round = 0;; ++round) {
      pairs.apply(dbeta, traction);
      for (int j = 0; j < columns; ++j) {
        for (int row = 0; row < rows; ++row) {
          residual[j][row] = 2.0 * traction[j][row] - dbeta[j][row] - dalpha[j][row];
        }
      }
      fixedPoint_.linearStage().unfelt().remove(residual);
      bool isDone = true, isGaining = false;
      for (int j = 0; j < columns; ++j) {
        const double left = norm(metric, residual[j]);
        if (round == 0) size[j] = std::max(left, negligible * norm(metric, alpha_[t]) / steps_[j]);
        const double relative = size[j] > 0.0 ? left / size[j] : 0.0;
        isDone = isDone && relative <= tolerance_;
        isGaining = isGaining || (relative > tolerance_ && left <= gained * before[j]);
        before[j] = left;
        lefts[j] = relative;
      }
      if (isDone || (round > 0 && !isGaining) || round == rounds) break;
      isSolved = solve(residual, size, dalpha, dbeta);
    }
    for (int j = 0; j < columns; ++j) {
      Result& result = results[j];
      const double worst = t == 0 ? 0.0 : result.residuals.back();
      result.residuals.push_back(std::max(worst, lefts[j]));
      if (lefts[j] <= noDerivative || worst > noDerivative) continue;
      const bool isSpent = tangent_->space().size() >= mostDirections;
      const NoDerivative why = isSolved[j] ? NoDerivative::kink
                               : isSpent   ? NoDerivative::directions
                                           : NoDerivative::unbalanced;
      result.missing.push_back(missingFrom(t, parameters[j], interfaceOf(residual[j], fixedPoint_), why));
    }
    pairs.accept();
    for (int j = 0; j < columns; ++j) std::copy_n(dalpha[j], rows, results[j].dalpha[t]);
  }
}

Derivatives::Along Derivatives::along(const ModelParameter& parameter, const std::vector<DifferencePoint>& difference,
                                      const base::Matrix& dalpha) {
  base::Matrix shifted(alpha_.numRows(), alpha_.numCols());
  Along result{std::vector<std::vector<std::vector<double>>>(responses_.size()), {}};
  for (const DifferencePoint& point : difference) {
    for (int t = 0; t < alpha_.numCols(); ++t) {
      for (int row = 0; row < alpha_.numRows(); ++row) {
        shifted[t][row] = alpha_[t][row] + point.offset * dalpha[t][row];
      }
    }
    put(parameter, parameter.value + point.offset);
    const Iterate& iterate = fixedPoint_.apply(shifted, scratch_);
    const NaturalSizes sizes(iterate);
    result.sizes.clear();
    for (std::size_t j = 0; j < responses_.size(); ++j) {
      result.values[j].push_back(responses_[j]->evaluate(iterate));
      double size = sizes.floor(*responses_[j]);
      for (const double value : result.values[j].back()) size = std::max(size, std::abs(value));
      result.sizes.push_back(size);
    }
  }
  put(parameter, parameter.value);
  return result;
}

void Derivatives::evaluate(const ModelParameter& parameter, double step, Result& result) {
  const auto difference = differenceOf(parameter.side, step);
  const Along all = along(parameter, difference, result.dalpha);
  std::vector<std::vector<int>> bends(responses_.size());
  bool isBent = false;
  for (std::size_t j = 0; j < responses_.size(); ++j) {
    result.responses.emplace_back();
    for (int t = 0; t < alpha_.numCols(); ++t) {
      result.responses[j].push_back(result.residuals[t] > noDerivative ? std::numeric_limits<double>::quiet_NaN()
                                                                       : slopeOf(difference, all.values[j], t));
    }
    if (!responses_[j]->isLinear()) bends[j] = bendsOf(all.values[j], all.sizes[j]);
    isBent = isBent || !bends[j].empty();
  }
  if (!isBent) return;
  const auto shorter = differenceOf(parameter.side, shortened * step);
  const Along near = along(parameter, shorter, result.dalpha);
  for (std::size_t j = 0; j < responses_.size(); ++j) {
    for (const int t : bends[j]) {
      double& derivative = result.responses[j][t];
      if (std::isnan(derivative)) continue;
      derivative = slopeOf(shorter, near.values[j], t);
      if (!isKink(all.values[j], near.values[j], shortened, t)) continue;
      derivative = std::numeric_limits<double>::quiet_NaN();
      result.missing.push_back(missingOf(responses_[j]->name(), t, parameter));
    }
  }
}

base::Matrix Derivatives::stateOf(const Iterate& solution) {
  const base::Matrix &traction = solution.hattedTraction(), &beta = solution.beta();
  base::Matrix state(beta.numRows(), beta.numCols());
  for (int t = 0; t < beta.numCols(); ++t) {
    for (int row = 0; row < beta.numRows(); ++row) state[t][row] = 2.0 * traction[t][row] - beta[t][row];
  }
  return state;
}

std::vector<Derivatives::Result> Derivatives::compute(const base::Matrix& state,
                                                      const std::vector<ModelParameter>& parameters) {
  const base::SoleThread inside(fixedPoint_.layout().comm().getSize());
  const int rows = fixedPoint_.layout().rows(), steps = fixedPoint_.assembly().steps();
  std::vector<Result> results(parameters.size());
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    results[j].parameter = parameters[j].name;
    results[j].dalpha.shape(rows, steps);
  }
  for (base::Matrix* field : {&alpha_, &beta_, &scratch_}) field->shape(rows, steps);
  alpha_.assign(state);
  directions_ = 0;
  const Restore restore{fixedPoint_, parameters};
  beta_.assign(fixedPoint_.apply(alpha_, scratch_).beta());
  const auto pairs = perturb(parameters);
  march(*pairs, parameters, results);
  fixedPoint_.updateLaws();
  fixedPoint_.selectAll();
  for (std::size_t j = 0; j < parameters.size(); ++j) evaluate(parameters[j], steps_[j], results[j]);
  return results;
}

}  // namespace harmos::latin
