#include <harmos/latin/Derivatives.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/base/Error.hpp>
#include <harmos/base/SoleThread.hpp>
#include <harmos/latin/detail/PairDerivatives.hpp>
#include <harmos/laws/AffineComponent.hpp>

namespace harmos::latin {
namespace {

// Tangents are differences with about seven digits; each round gains as many.
constexpr int rounds = 4;
constexpr int mostDirections = 400;
// What is left of a direction beside those of the same block: each is known to 1e-7 where little of it was outside of
// the space, and less than a thousand times that is round-off.
constexpr double leastIndependent = 1e-4;
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
      tangent_(fixedPoint, lines_) {
  if (fixedPoint.assembly().path) {
    throw base::Error("there are no derivatives where the size of loads is to be found", base::ExitCode::input);
  }
}

Derivatives::~Derivatives() = default;

void Derivatives::put(const ModelParameter& parameter, double value) {
  parameter.set(value);
  fixedPoint_.updateLaws();
}

void Derivatives::demandSameOperators(const ModelParameter& parameter) const {
  const assembly::Assembly& assembly = fixedPoint_.assembly();
  std::vector<std::shared_ptr<const laws::InterfaceLaw>> more;
  parameter.set(parameter.value + parameter.step);
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

std::unique_ptr<PairDerivatives> Derivatives::perturb(const std::vector<ModelParameter>& parameters) {
  const assembly::Assembly& assembly = fixedPoint_.assembly();
  std::vector<PairDerivatives::Laws> laws;
  dbeta_.clear();
  for (const ModelParameter& parameter : parameters) {
    demandSameOperators(parameter);
    PairDerivatives::Laws both{parameter.step};
    dbeta_.emplace_back(alpha_.numRows(), alpha_.numCols());
    base::Matrix& change = dbeta_.back();
    put(parameter, parameter.value + parameter.step);
    for (const assembly::Interface& interface : assembly.interfaces) both.more.push_back(interface.law);
    fixedPoint_.solveLinear(alpha_, change);
    put(parameter, parameter.value - parameter.step);
    for (const assembly::Interface& interface : assembly.interfaces) both.less.push_back(interface.law);
    fixedPoint_.solveLinear(alpha_, scratch_);
    put(parameter, parameter.value);
    for (int t = 0; t < change.numCols(); ++t) {
      for (int row = 0; row < change.numRows(); ++row) {
        change[t][row] = (change[t][row] - scratch_[t][row]) / (2.0 * parameter.step);
      }
    }
    laws.push_back(std::move(both));
  }
  return std::make_unique<PairDerivatives>(assembly, lines_, std::move(laws));
}

bool Derivatives::extend(const std::vector<std::vector<double>>& residuals) {
  const StateMetric& metric = fixedPoint_.metric();
  const int rows = alpha_.numRows();
  std::vector<std::vector<double>> block;
  for (std::vector<double> v : residuals) {
    if (!tangent_.space().makeIndependent(v.data())) continue;
    for (int pass = 0; pass < 2; ++pass) {
      for (const std::vector<double>& u : block) {
        const double share = dot(metric, u.data(), v.data());
        for (int row = 0; row < rows; ++row) v[row] -= share * u[row];
      }
    }
    const double length = norm(metric, v.data());
    if (length < leastIndependent || !tangent_.space().makeIndependent(v.data())) continue;
    block.push_back(std::move(v));
  }
  if (block.empty()) {
    std::vector<double> next(rows);
    if (!tangent_.continueKrylov(next)) return false;
    block.push_back(std::move(next));
  }
  // A single one of several columns would be solved in single precision.
  const int count = static_cast<int>(block.size()), columns = std::max(count, 2);
  base::Matrix v(rows, columns), y(rows, columns);
  for (int i = 0; i < count; ++i) std::copy(block[i].begin(), block[i].end(), v[i]);
  std::vector<int> selected(columns);
  for (int i = 0; i < columns; ++i) selected[i] = i;
  fixedPoint_.select(selected);
  fixedPoint_.solveLinear(v, y);
  for (int i = 0; i < count; ++i) tangent_.add(v[i], y[i], true);
  return true;
}

void Derivatives::solve(const base::Matrix& right, base::Matrix& dalpha, base::Matrix& dbeta) {
  const StateMetric& metric = fixedPoint_.metric();
  const int rows = right.numRows(), columns = right.numCols();
  std::vector<CorrectionSpace::LeastSquares> fits(columns);
  const auto left = [&] {
    std::vector<std::vector<double>> residuals;
    for (int j = 0; j < columns; ++j) {
      const double size = norm(metric, right[j]);
      if (size == 0.0) continue;
      fits[j] = tangent_.space().solve(right[j]);
      double length = 0.0;  // of the solution: the v are orthonormal
      for (const double c : fits[j].c) length = std::hypot(length, c);
      // What the residual can hide is counted against the solution as well.
      const double hidden = fits[j].left / tangent_.space().smallestSingularValue();
      if (fits[j].left <= tolerance_ * size && hidden <= std::sqrt(tolerance_) * length) continue;
      std::vector<double> residual(right[j], right[j] + rows);
      if (!fits[j].c.empty()) tangent_.subtract(fits[j].c, residual);
      residuals.push_back(std::move(residual));
    }
    return residuals;
  };
  for (auto residuals = left(); !residuals.empty(); residuals = left()) {
    if (tangent_.space().size() >= mostDirections || !extend(residuals)) break;
  }
  for (int j = 0; j < columns; ++j) {
    if (!fits[j].c.empty()) tangent_.space().move(fits[j].c, 1.0, dalpha[j], dbeta[j]);
  }
}

void Derivatives::march(PairDerivatives& pairs, std::vector<Result>& results) {
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
    tangent_.differentiate(t, local);
    pairs.meet(t, local);
    local.accept();
    dalpha.putScalar(0.0);
    for (int j = 0; j < columns; ++j) std::copy_n(dbeta_[j][t], rows, dbeta[j]);
    std::vector<double> size(columns, 0.0);
    for (int round = 0;; ++round) {
      pairs.apply(dbeta, traction);
      for (int j = 0; j < columns; ++j) {
        for (int row = 0; row < rows; ++row) {
          residual[j][row] = 2.0 * traction[j][row] - dbeta[j][row] - dalpha[j][row];
        }
      }
      fixedPoint_.linearStage().unfelt().remove(residual);
      bool isDone = true;
      for (int j = 0; j < columns; ++j) {
        const double left = norm(metric, residual[j]);
        if (round == 0) size[j] = left;
        const double relative = size[j] > 0.0 ? left / size[j] : 0.0;
        isDone = isDone && relative <= tolerance_;
        if (isDone || round == rounds) results[j].residual = std::max(results[j].residual, relative);
      }
      if (isDone || round == rounds) break;
      solve(residual, dalpha, dbeta);
    }
    pairs.accept();
    for (int j = 0; j < columns; ++j) std::copy_n(dalpha[j], rows, results[j].dalpha[t]);
  }
}

void Derivatives::evaluate(const ModelParameter& parameter, Result& result) {
  base::Matrix shifted(alpha_.numRows(), alpha_.numCols());
  std::vector<std::vector<double>> more;
  for (const double sign : {1.0, -1.0}) {
    for (int t = 0; t < alpha_.numCols(); ++t) {
      for (int row = 0; row < alpha_.numRows(); ++row) {
        shifted[t][row] = alpha_[t][row] + sign * parameter.step * result.dalpha[t][row];
      }
    }
    put(parameter, parameter.value + sign * parameter.step);
    const Iterate& iterate = fixedPoint_.apply(shifted, scratch_);
    for (std::size_t j = 0; j < responses_.size(); ++j) {
      const std::vector<double> values = responses_[j]->evaluate(iterate);
      if (sign > 0.0) {
        more.push_back(values);
        continue;
      }
      result.responses.emplace_back();
      for (std::size_t t = 0; t < values.size(); ++t) {
        result.responses.back().push_back((more[j][t] - values[t]) / (2.0 * parameter.step));
      }
    }
  }
  put(parameter, parameter.value);
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
  for (Result& result : results) result.dalpha.shape(rows, steps);
  for (base::Matrix* field : {&alpha_, &beta_, &scratch_}) field->shape(rows, steps);
  alpha_.assign(state);
  const Restore restore{fixedPoint_, parameters};
  beta_.assign(fixedPoint_.apply(alpha_, scratch_).beta());
  const auto pairs = perturb(parameters);
  march(*pairs, results);
  fixedPoint_.updateLaws();
  fixedPoint_.selectAll();
  for (std::size_t j = 0; j < parameters.size(); ++j) evaluate(parameters[j], results[j]);
  return results;
}

}  // namespace harmos::latin
