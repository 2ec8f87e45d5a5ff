#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include <harmos/base/Error.hpp>
#include <harmos/probability/Beta.hpp>
#include <harmos/probability/Lognormal.hpp>
#include <harmos/probability/Normal.hpp>
#include <harmos/probability/PiecewiseLinear.hpp>
#include <harmos/probability/Quadrature.hpp>
#include <harmos/probability/Sample.hpp>
#include <harmos/probability/Uniform.hpp>
#include <harmos/probability/detail/StandardNormal.hpp>

namespace harmos::probability {
namespace {

using Function = std::function<double(const std::vector<double>&)>;

std::shared_ptr<const RandomVector> vectorOf(const std::vector<std::shared_ptr<const Distribution>>& distributions) {
  std::vector<Variable> variables;
  for (const auto& distribution : distributions) variables.push_back({"x", distribution});
  return std::make_shared<RandomVector>(std::move(variables));
}

/// Of the parameters, not of the germs.
PiecewiseLinear solved(const std::shared_ptr<const RandomVector>& variables, const PiecewiseLinear::Options& options,
                       const std::vector<Function>& functions) {
  PiecewiseLinear model(variables, options);
  for (auto points = model.next(); !points.empty(); points = model.next()) {
    std::vector<std::vector<double>> values;
    for (const auto& germs : points) {
      values.emplace_back();
      for (const auto& function : functions) values.back().push_back(function(variables->values(germs)));
    }
    model.tell(values);
  }
  return model;
}

/// Mean and standard deviation by a fine midpoint sum over equal probabilities.
std::pair<double, double> exactMoments(const Distribution& distribution, const Function& function) {
  constexpr int strata = 100000;
  double mean = 0.0, square = 0.0;
  for (int i = 0; i < strata; ++i) {
    const double value = function({distribution.value(distribution.germ((i + 0.5) / strata))});
    mean += value / strata;
    square += value * value / strata;
  }
  return {mean, std::sqrt(square - mean * mean)};
}

PiecewiseLinear::Options optionsOf(double tolerance, int largestCount = 1000) {
  PiecewiseLinear::Options options;
  options.tolerance = tolerance;
  options.largestCount = largestCount;
  return options;
}

struct KinkedCase {
  std::shared_ptr<const Distribution> distribution;
  Function function;
  int count;
};

std::vector<KinkedCase> kinkedCases() {
  const auto normal = std::make_shared<Normal>(0.0, 1.0);
  return {
      {normal, [](const auto& x) { return std::max(0.0, x[0] - 0.3); }, 17},
      {normal, [](const auto& x) { return std::min(x[0], 0.77) + 0.1 * x[0]; }, 17},
      {std::make_shared<Uniform>(0.0, 1.0), [](const auto& x) { return std::min(x[0], 0.37); }, 17},
      {std::make_shared<Beta>(0.0, 1.0, 2.0, 3.0), [](const auto& x) { return std::min(x[0], 0.37); }, 25},
      {normal, [](const auto& x) { return std::min(x[0] + 0.05 * x[0] * x[0], 0.77); }, 33},
      {std::make_shared<Uniform>(0.0, 1.0), [](const auto& x) { return std::min(std::sqrt(x[0] + 0.1), 0.77); }, 33},
      {std::make_shared<Lognormal>(1.0, 0.3), [](const auto& x) { return std::min(1.0 / x[0], 1.2); }, 48}};
}

TEST(PiecewiseLinear, FollowsAKinkWithFewSolutions) {
  for (const auto& [distribution, function, count] : kinkedCases()) {
    const auto [mean, deviation] = exactMoments(*distribution, function);
    const auto model = solved(vectorOf({distribution}), optionsOf(1e-9, count), {function});
    EXPECT_EQ(model.count(), count);
    EXPECT_NEAR(model.mean(0), mean, 3e-4 * deviation) << distribution->name() << " " << count;
    EXPECT_NEAR(model.standardDeviation(0), deviation, 3e-4 * deviation) << distribution->name() << " " << count;
  }
}

TEST(PiecewiseLinear, EndsWhenItsEstimateReachesTheToleranceAndTheErrorDoesToo) {
  for (const auto& [distribution, function, count] : kinkedCases()) {
    const auto [mean, deviation] = exactMoments(*distribution, function);
    for (const double tolerance : {3e-3, 1e-3, 1e-4}) {
      const auto model = solved(vectorOf({distribution}), optionsOf(tolerance), {function});
      EXPECT_TRUE(model.isReached());
      EXPECT_LE(model.errorIndicator(), tolerance);
      EXPECT_NEAR(model.mean(0), mean, tolerance * deviation) << distribution->name() << " " << tolerance;
      EXPECT_NEAR(model.standardDeviation(0), deviation, tolerance * deviation)
          << distribution->name() << " " << tolerance;
    }
  }
}

/// The rest has less probability than lies between two of the finest nodes, but tells mean and standard deviation.
TEST(PiecewiseLinear, SaysThatItCannotSeeCloseEnough) {
  const auto uniform = std::make_shared<Uniform>(0.1499, 0.9);
  const auto model =
      solved(vectorOf({uniform}), optionsOf(1e-4), {[](const auto& x) { return std::max(0.0, 0.15 - x[0]); }});
  const double width = 0.9 - 0.1499, mean = 1e-4 * 1e-4 / 2.0 / width;
  const double deviation = std::sqrt(1e-4 * 1e-4 * 1e-4 / 3.0 / width - mean * mean);
  EXPECT_FALSE(model.isReached());
  EXPECT_NEAR(model.mean(0), mean, model.errorIndicator() * model.standardDeviation(0));
  EXPECT_NEAR(model.standardDeviation(0), deviation, model.errorIndicator() * model.standardDeviation(0));
}

/// Contact at 3.75 standard deviations: beyond 5 of them lies nearly a hundredth of the standard deviation.
TEST(PiecewiseLinear, CountsWhatItsRangeLeavesOut) {
  const auto normal = std::make_shared<Normal>(0.0, 1.0);
  const auto model =
      solved(vectorOf({normal}), optionsOf(1e-4), {[](const auto& x) { return std::max(0.0, x[0] - 3.75); }});
  // Of max(0, x - a): the mean is p(a) - a Q(a), the mean square (1 + a^2) Q(a) - a p(a).
  constexpr double a = 3.75, density = 0.3989422804014327 * 8.838263069350498e-04;
  const double tail = normalCumulative(-a), mean = density - a * tail, square = (1.0 + a * a) * tail - a * density;
  const double deviation = std::sqrt(square - mean * mean), found = model.standardDeviation(0);
  EXPECT_GT(std::abs(found - deviation), 5e-3 * deviation);
  EXPECT_LT(std::abs(found - deviation), 1.1 * model.errorIndicator() * found);  // a tail is no exponential function
  EXPECT_FALSE(model.isReached());
}

TEST(PiecewiseLinear, TakesTheValuesOfASample) {
  for (const std::vector<double>& values :
       {std::vector<double>{0.1, 0.2}, std::vector<double>{0.03, 0.05, 0.05, 0.09, 0.15}}) {
    const Sample sample(values);
    const auto model = solved(vectorOf({std::make_shared<Sample>(sample)}), optionsOf(1e-5),
                              {[](const auto& x) { return 3.0 - x[0]; }, [](const auto& x) { return x[0] * x[0]; }});
    const auto [square, squareDeviation] = exactMoments(sample, [](const auto& x) { return x[0] * x[0]; });
    EXPECT_TRUE(model.isReached());
    EXPECT_NEAR(model.mean(0), 3.0 - sample.mean(), 1e-9);
    EXPECT_NEAR(model.standardDeviation(0), sample.standardDeviation(), 1e-9);
    EXPECT_NEAR(model.mean(1), square, 1e-5 * squareDeviation);
    EXPECT_NEAR(model.standardDeviation(1), squareDeviation, 1e-5 * squareDeviation);
  }
}

TEST(PiecewiseLinear, IsExactForMultilinearResponses) {
  const auto variables = vectorOf({std::make_shared<Normal>(1.0, 0.1), std::make_shared<Uniform>(0.0, 2.0)});
  const auto model = solved(variables, optionsOf(1e-3), {[](const auto& x) { return 2.0 + x[0] * x[1]; }});
  EXPECT_LT(model.count(), 30);
  EXPECT_LT(model.errorIndicator(), 1e-3);
  EXPECT_NEAR(model.mean(0), 3.0, 1e-6);
  EXPECT_NEAR(model.standardDeviation(0), std::sqrt(1.01 * 4.0 / 3.0 - 1.0), 1e-5);
  EXPECT_NEAR(model.evaluate({1.7, 0.3})[0], 2.0 + 1.17 * 1.3, 1e-12);
}

/// Kinks along one germ each have closed forms; an oblique one is that of the sum, itself normal.
TEST(PiecewiseLinear, FollowsKinksInTwoGerms) {
  const auto normal = std::make_shared<Normal>(0.0, 1.0);
  const auto variables = vectorOf({normal, normal});
  const auto [first, firstDeviation] =
      exactMoments(*normal, [](const auto& x) { return std::max(0.0, x[0] - 0.3) + 0.2 * x[0] * x[0]; });
  const auto [second, secondDeviation] = exactMoments(*normal, [](const auto& x) { return std::min(0.5, x[0]); });
  const auto additive =
      solved(variables, optionsOf(1e-3),
             {[](const auto& x) { return std::max(0.0, x[0] - 0.3) + 0.2 * x[0] * x[0] + std::min(0.5, x[1]); }});
  const double deviation = std::hypot(firstDeviation, secondDeviation);
  EXPECT_LT(additive.count(), 200);
  EXPECT_NEAR(additive.mean(0), first + second, 1e-3 * deviation);
  EXPECT_NEAR(additive.standardDeviation(0), deviation, 1e-3 * deviation);

  const Normal sum(0.0, std::sqrt(2.0));
  const auto [mean, obliqueDeviation] = exactMoments(sum, [](const auto& x) { return std::max(0.0, x[0] - 0.5); });
  const auto oblique =
      solved(variables, optionsOf(1e-2), {[](const auto& x) { return std::max(0.0, x[0] + x[1] - 0.5); }});
  EXPECT_TRUE(oblique.isReached());
  EXPECT_LT(oblique.count(), 300);
  EXPECT_NEAR(oblique.mean(0), mean, 1e-2 * obliqueDeviation);
  EXPECT_NEAR(oblique.standardDeviation(0), obliqueDeviation, 1e-2 * obliqueDeviation);
}

/// All along the axes through the middle this response is zero.
TEST(PiecewiseLinear, FindsWhatHappensOnlyInTheCorners) {
  const auto normal = std::make_shared<Normal>(0.0, 1.0);
  const auto model = solved(vectorOf({normal, normal}), optionsOf(1e-2),
                            {[](const auto& x) { return std::max(0.0, x[0] * x[1] - 1.0); }});
  double mean = 0.0, square = 0.0;
  constexpr int cells = 1000;
  std::vector<double> x, weights;
  for (int i = 0; i < cells; ++i) {
    x.push_back(-7.0 + 14.0 * (i + 0.5) / cells);
    weights.push_back(normalCumulative(x.back() + 7.0 / cells) - normalCumulative(x.back() - 7.0 / cells));
  }
  for (std::size_t i = 0; i < cells; ++i) {
    for (std::size_t j = 0; j < cells; ++j) {
      const double value = std::max(0.0, x[i] * x[j] - 1.0), weight = weights[i] * weights[j];
      mean += weight * value;
      square += weight * value * value;
    }
  }
  const double deviation = std::sqrt(square - mean * mean);
  EXPECT_TRUE(model.isReached());
  EXPECT_NEAR(model.mean(0), mean, 1e-2 * deviation);
  EXPECT_NEAR(model.standardDeviation(0), deviation, 1e-2 * deviation);
}

TEST(PiecewiseLinear, ThreeGermsOfWhichTwoAreCorrelated) {
  base::Matrix correlation(3, 3);
  for (int i = 0; i < 3; ++i) correlation(i, i) = 1.0;
  correlation(0, 1) = correlation(1, 0) = 0.6;
  const auto normal = std::make_shared<Normal>(0.0, 1.0);
  const auto variables = std::make_shared<RandomVector>(
      std::vector<Variable>{{"a", normal}, {"b", normal}, {"c", std::make_shared<Uniform>(0.0, 1.0)}}, correlation);
  const auto model =
      solved(variables, optionsOf(3e-3), {[](const auto& x) { return x[0] + x[1] + std::max(x[2], 0.4); }});
  EXPECT_TRUE(model.isReached());
  const double mean = 0.4 * 0.4 + 0.5 * (1.0 - 0.16), square = 0.4 * 0.16 + (1.0 - 0.064) / 3.0;
  const double deviation = std::sqrt(3.2 + square - mean * mean);
  EXPECT_NEAR(model.mean(0), mean, 3e-3 * deviation);
  EXPECT_NEAR(model.standardDeviation(0), deviation, 3e-3 * deviation);
}

TEST(PiecewiseLinear, IsDrivenByTheResponseAskedFor) {
  const auto variables = vectorOf({std::make_shared<Normal>(0.0, 1.0)});
  const std::vector<Function> functions{[](const auto& x) { return x[0]; },
                                        [](const auto& x) { return std::max(0.0, x[0] - 0.3); },
                                        [](const auto&) { return 7.0; }};
  PiecewiseLinear::Options options = optionsOf(1e-3);
  options.response = 0;
  EXPECT_EQ(solved(variables, options, functions).count(), 9);
  options.response.reset();
  const auto all = solved(variables, options, functions);
  EXPECT_GT(all.count(), 12);
  EXPECT_NEAR(all.standardDeviation(0), 1.0, 1e-5);
  EXPECT_NEAR(all.mean(2), 7.0, 1e-12);
  EXPECT_EQ(all.standardDeviation(2), 0.0);
  EXPECT_NEAR(all.evaluate({0.3})[2], 7.0, 1e-12);
}

TEST(PiecewiseLinear, InterpolatesAndCountsResponsesAsConstantOutOfRange) {
  const auto variables = vectorOf({std::make_shared<Normal>(0.0, 1.0)});
  PiecewiseLinear model(variables, optionsOf(1e-3));
  const auto points = model.next();
  std::vector<std::vector<double>> values;
  for (const auto& point : points) values.push_back({std::sin(3.0 * point[0])});
  model.tell(values);
  for (std::size_t s = 0; s < points.size(); ++s) EXPECT_NEAR(model.evaluate(points[s])[0], values[s][0], 1e-13);
  EXPECT_DOUBLE_EQ(model.evaluate({9.0})[0], model.evaluate({5.0})[0]);
}

TEST(PiecewiseLinear, RefusesWhatItCannotDo) {
  const auto normal = std::make_shared<Normal>(0.0, 1.0);
  EXPECT_THROW(PiecewiseLinear(vectorOf({normal, normal, normal, normal}), optionsOf(1e-3)), base::Error);
  EXPECT_THROW(PiecewiseLinear(vectorOf({normal}), optionsOf(0.0)), base::Error);
  EXPECT_THROW(PiecewiseLinear(vectorOf({normal}), optionsOf(1e-3, 0)), base::Error);
  PiecewiseLinear model(vectorOf({normal}), optionsOf(1e-3));
  EXPECT_THROW(model.evaluate({0.0}), base::Error);
  EXPECT_THROW(model.tell({}), base::Error);
  const auto count = model.next().size();
  EXPECT_THROW(model.tell(std::vector<std::vector<double>>(count, {std::nan("")})), base::Error);
  EXPECT_THROW(model.tell({{1.0}}), base::Error);
}

TEST(HatLine, ExpectationsAreThoseOfTheLaw) {
  const Normal normal(0.0, 1.0);
  const HatLine line(-5.0, 5.0, [&normal](double x) { return normal.cumulative(x); });
  const Quadrature fine = [] {
    Quadrature points;
    constexpr int count = 40000;
    for (int i = 0; i < count; ++i) {
      const double x = -5.0 + 10.0 * (i + 0.5) / count, half = 5.0 / count;
      points.points.push_back({x});
      points.weights.push_back(normalCumulative(x + half) - normalCumulative(x - half));
    }
    return points;
  }();
  for (const int node : {HatLine::middle, 0, HatLine::last, 1024, 1536, 3000}) {
    EXPECT_EQ(line.value(node, line.germ(node)), 1.0);
    for (const int other : {HatLine::middle, 0, 3072, 1280}) {
      double sum = 0.0;
      for (std::size_t q = 0; q < fine.weights.size(); ++q) {
        const double x = fine.points[q][0];
        sum += fine.weights[q] * line.value(node, x) * line.value(other, x);
      }
      EXPECT_NEAR(line.product(node, other), sum, 1e-5) << node << " " << other;
    }
  }
}

TEST(HatLine, EveryNodeButTheMiddleIsAChildOfItsParent) {
  for (int node = 0; node <= HatLine::last; ++node) {
    const auto parent = HatLine::parent(node);
    ASSERT_EQ(parent.has_value(), node != HatLine::middle);
    if (!parent) continue;
    const auto children = HatLine::children(*parent);
    EXPECT_NE(std::find(children.begin(), children.end(), node), children.end()) << node;
  }
}

TEST(PiecewiseLinear, TellsWhatItIsAndWhereItIsUncertain) {
  const auto variables = vectorOf({std::make_shared<Normal>(0.0, 1.0), std::make_shared<Uniform>(-1.0, 1.0)});
  const Function kink = [](const std::vector<double>& x) { return std::max(0.0, x[0] + 0.3 * x[1] - 0.2); };
  const PiecewiseLinear model = solved(variables, optionsOf(1e-9, 150), {kink, [](const auto&) { return 7.0; }});
  const HatSum function = model.function(), doubt = model.doubt();
  const HatSum again(
      [&] {
        std::vector<HatLine> lines;
        for (const HatLine& line : function.lines()) lines.emplace_back(line.germs());
        return lines;
      }(),
      function.terms());
  double onTheKink = 0.0, elsewhere = 0.0;
  for (const double x : {-3.0, -0.7, 0.1, 0.2, 0.33, 1.9}) {
    const std::vector<double> germs{x, 0.1};
    EXPECT_EQ(function.evaluate(germs), model.evaluate(germs));
    EXPECT_EQ(again.evaluate(germs), model.evaluate(germs));
    EXPECT_EQ(doubt.evaluate(germs)[1], 0.0);
    (std::abs(x - 0.2) < 0.15 ? onTheKink : elsewhere) += doubt.evaluate(germs)[0];
  }
  EXPECT_GT(onTheKink, 3.0 * elsewhere);

  // Left out, a point is predicted by the others with the error that its surplus is.
  const auto leftOut = model.leftOut();
  EXPECT_GT(leftOut.size(), 30U);
  int doubted = 0;
  for (const auto& one : leftOut) {
    EXPECT_GE(one.errors[0], 0.0);
    EXPECT_EQ(one.errors[1], 0.0);
    if (one.doubts[0] > 0.0) ++doubted;
  }
  EXPECT_GT(doubted, 10);
  EXPECT_THROW(HatLine(std::vector<double>{0.0, 1.0}), base::Error);
  EXPECT_THROW(HatSum(function.lines(), {{{0}, {1.0}}}), base::Error);
}

}  // namespace
}  // namespace harmos::probability
