#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include <harmos/probability/Normal.hpp>
#include <harmos/probability/Truncation.hpp>

namespace harmos::probability {
namespace {

using Function = std::function<double(const std::vector<double>&)>;

std::shared_ptr<const RandomVector> standardNormals(int count) {
  std::vector<Variable> variables(count, {"x", std::make_shared<Normal>(0.0, 1.0)});
  return std::make_shared<RandomVector>(std::move(variables));
}

/// By Gauss points as many as collocation takes.
Expansion expansionOf(const Function& function, int count, int order) {
  const auto variables = standardNormals(count);
  const Quadrature quadrature = tensorQuadrature(*variables, order + 1);
  std::vector<double> values;
  for (const auto& point : quadrature.points) values.push_back(function(point));
  return project(std::make_shared<Basis>(variables, order), quadrature, values);
}

struct Truth {
  double mean, deviation, residual;
};

/// On a grid of equal probabilities.
Truth truthOf(const Function& function, const Expansion& expansion, int count) {
  const int levels = count == 1 ? 5000 : count == 2 ? 100 : 24;
  const Normal normal(0.0, 1.0);
  std::vector<int> at(count, 0);
  double mean = 0.0, square = 0.0, residual = 0.0;
  int total = 0;
  while (true) {
    std::vector<double> point;
    for (const int k : at) point.push_back(normal.germ((k + 0.5) / levels));
    const double value = function(point), difference = value - expansion.evaluate(point);
    mean += value;
    square += value * value;
    residual += difference * difference;
    ++total;
    int g = 0;
    while (g < count && ++at[g] == levels) at[g++] = 0;
    if (g == count) break;
  }
  mean /= total;
  return {mean, std::sqrt(square / total - mean * mean), std::sqrt(residual / total)};
}

/// Kinks that the Gauss points can see, of one, two and three parameters, straight and oblique.
TEST(Truncation, OfKinksIsTheRootMeanSquareErrorWithinAFactor) {
  std::vector<double> ratios, moments;
  for (int count = 1; count <= 3; ++count) {
    for (const double gap : {-1.0, -0.5, 0.0, 0.6, 1.0}) {
      for (int order = 2; order <= (count == 3 ? 4 : 8); ++order) {
        const Function kink = [&](const std::vector<double>& xi) {
          double along = 0.0;
          for (const double each : xi) along += each / std::sqrt(count);
          return std::max(0.0, along - gap);
        };
        const Expansion expansion = expansionOf(kink, count, order);
        const Truth truth = truthOf(kink, expansion, count);
        const double found = kinkedResidual(expansion);
        ratios.push_back(found / truth.residual);
        EXPECT_GT(found, truth.residual / 3.0) << count << " parameters, gap " << gap << ", order " << order;
        // A third of it is the error of the moments, within a factor of three; mostly it is less.
        const double error = std::max(std::abs(expansion.mean() - truth.mean),
                                      std::abs(expansion.standardDeviation() - truth.deviation));
        moments.push_back(error / (truth.residual / 3.0));
        EXPECT_LT(moments.back(), 3.0) << count << " parameters, gap " << gap << ", order " << order;
      }
    }
  }
  const auto median = [](std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
  };
  EXPECT_LT(median(ratios), 3.0);
  EXPECT_GT(median(moments), 1.0 / 3.0);
}

TEST(Truncation, OfASmoothFunctionFollowsItsDecay) {
  const Function smooth = [](const std::vector<double>& xi) { return std::exp(0.2 * xi[0]); };
  for (int order = 2; order <= 6; ++order) {
    const Expansion expansion = expansionOf(smooth, 1, order);
    const double truth = truthOf(smooth, expansion, 1).residual, found = smoothResidual(expansion);
    EXPECT_GT(found, 0.5 * truth);
    EXPECT_LT(found, 3.0 * truth);
    EXPECT_GT(kinkedResidual(expansion), 5.0 * truth);
  }
}

TEST(Truncation, IsUnknownWithoutDegrees) {
  const Function smooth = [](const std::vector<double>& xi) { return xi[0]; };
  EXPECT_TRUE(std::isnan(kinkedResidual(expansionOf(smooth, 1, 0))));
  EXPECT_TRUE(std::isnan(smoothResidual(expansionOf(smooth, 1, 0))));
}

}  // namespace
}  // namespace harmos::probability
