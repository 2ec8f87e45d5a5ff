// Karhunen-Loeve expansions against closed forms of exponential covariances, and the draws that laws follow.
#include <gtest/gtest.h>

#include <cmath>

#include <harmos/base/Error.hpp>
#include <harmos/laws/RandomField.hpp>

namespace harmos::laws {
namespace {

constexpr double pi = 3.14159265358979323846;

/// A line of length 1 with points at the ends of `cells` equal cells.
RandomField::Surface line(int cells) {
  RandomField::Surface surface;
  for (int i = 0; i <= cells; ++i) {
    surface[{static_cast<double>(i) / cells, 0.0, 0.0}] = (i == 0 || i == cells ? 0.5 : 1.0) / cells;
  }
  return surface;
}

input::Parameters field(const std::string& covariance, double length, const std::vector<double>& draw,
                        const std::string& distribution = "Normal", double share = 0.0) {
  input::Parameters list("rough");
  list.set("Type", std::string("Random")).set("Covariance", covariance).set("Correlation Length", length);
  list.set("Coefficient of Variation", 0.2).set("Distribution", distribution).set("Energy Share", share);
  input::Parameters coefficients("Coefficients");
  for (std::size_t k = 0; k < draw.size(); ++k) coefficients.set("xi" + std::to_string(k + 1), draw[k]);
  list.setList("Coefficients", coefficients);
  return list;
}

/// sqrt(lambda_k) phi_k at a place: what one coefficient alone makes of a Normal field.
double mode(const RandomField& any, const std::string& covariance, double length, int k, int terms, double x) {
  std::vector<double> draw(static_cast<std::size_t>(terms), 0.0);
  draw[static_cast<std::size_t>(k)] = 1.0;
  return (any.with(field(covariance, length, draw))->at(0, {x, 0.0, 0.0}) - 1.0) / 0.2;
}

// The variance of the mean of a field with exp(-d/l) over a line L: 2 (l/L)^2 (L/l - 1 + exp(-L/l)).
TEST(RandomField, HasTheVarianceOfTheMean) {
  constexpr int cells = 200, terms = 60;
  const RandomField::Surface surface = line(cells);
  for (const double l : {0.1, 0.5, 2.0}) {
    const RandomField any(field("Exponential", l, std::vector<double>(terms, 0.0)), surface);
    double variance = 0.0;
    for (int k = 0; k < terms; ++k) {
      double mean = 0.0;
      for (const auto& [place, area] : surface) mean += area * mode(any, "Exponential", l, k, terms, place[0]);
      variance += mean * mean;
    }
    const double expected = 2.0 * l * l * (1.0 / l - 1.0 + std::exp(-1.0 / l));
    EXPECT_NEAR(variance, expected, 1e-3 * expected) << l;
  }
}

// Eigenvalues on a line of length 2 a: 2 l / (1 + (l w)^2), w the roots of 1 = l w tan(w a) and l w = -tan(w a).
TEST(RandomField, HasTheEigenvaluesOfTheExponentialCovariance) {
  constexpr double l = 0.4, a = 0.5;
  constexpr int cells = 400, terms = 6;
  const RandomField::Surface surface = line(cells);
  const RandomField any(field("Exponential", l, std::vector<double>(terms, 0.0)), surface);
  for (int k = 0; k < terms; ++k) {
    // The root lies in (k pi / 2, (k + 1) pi / 2) of w a; the signs of both ends differ.
    double low = 0.5 * pi * k + 1e-9, high = 0.5 * pi * (k + 1) - 1e-9;
    const auto residual = [&](double wa) {
      const double lw = l * wa / a;
      return k % 2 == 0 ? std::cos(wa) - lw * std::sin(wa) : lw * std::cos(wa) + std::sin(wa);
    };
    for (int i = 0; i < 100; ++i) {
      const double middle = 0.5 * (low + high);
      (residual(low) * residual(middle) <= 0.0 ? high : low) = middle;
    }
    const double w = low / a, expected = 2.0 * l / (1.0 + l * w * l * w);
    double eigenvalue = 0.0;
    for (const auto& [place, area] : surface) {
      const double value = mode(any, "Exponential", l, k, terms, place[0]);
      eigenvalue += area * value * value;
    }
    EXPECT_NEAR(eigenvalue, expected, 2e-3 * expected) << k;
  }
}

TEST(RandomField, SaysHowManyTermsHoldTheShare) {
  const RandomField::Surface surface = line(50);
  try {
    const RandomField few(field("Gaussian", 0.3, {0.0, 0.0}, "Normal", 0.99), surface);
    FAIL() << "accepted";
  } catch (const base::Error& error) {
    const std::string message = error.what();
    EXPECT_EQ(error.code(), base::ExitCode::input);
    const auto found = message.find("of the variance; ");
    ASSERT_NE(found, std::string::npos) << message;
    const int needed = std::stoi(message.substr(found + 17));
    EXPECT_GT(needed, 2);
    const auto draw = [](int terms) { return std::vector<double>(static_cast<std::size_t>(terms), 0.0); };
    EXPECT_NO_THROW(RandomField(field("Gaussian", 0.3, draw(needed), "Normal", 0.99), surface));
    EXPECT_THROW(RandomField(field("Gaussian", 0.3, draw(needed - 1), "Normal", 0.99), surface), base::Error);
  }
  EXPECT_THROW(RandomField(field("Gaussian", 0.3, std::vector<double>(60, 0.0)), surface), base::Error);
  EXPECT_THROW(RandomField(field("Gaussian", 0.3, {0.0}), {}), base::Error);
}

// The mean over the germs of exp(s g - s^2 v / 2) is 1, its variance exp(s^2 v) - 1: by Gauss points for two terms.
TEST(RandomField, IsLognormalWithMeanOne) {
  const RandomField::Surface surface = line(20);
  const RandomField any(field("Gaussian", 0.5, {0.0, 0.0}, "Lognormal"), surface);
  // Trapezia over +-8 are exact to round-off.
  constexpr int half = 40;
  constexpr double step = 0.2;
  for (const double x : {0.0, 0.37, 1.0}) {
    double mean = 0.0, square = 0.0;
    for (int i = -half; i <= half; ++i) {
      for (int j = -half; j <= half; ++j) {
        const double a = step * i, b = step * j;
        const double weight = step * step / (2.0 * pi) * std::exp(-0.5 * (a * a + b * b));
        const double value = any.with(field("Gaussian", 0.5, {a, b}, "Lognormal"))->at(0, {x, 0.0, 0.0});
        mean += weight * value;
        square += weight * value * value;
      }
    }
    double held = 0.0;
    for (int k = 0; k < 2; ++k) held += std::pow(mode(any, "Gaussian", 0.5, k, 2, x), 2);
    EXPECT_NEAR(mean, 1.0, 1e-10);
    EXPECT_NEAR(square - 1.0, std::pow(1.04, held) - 1.0, 1e-9);
  }
}

// A surface in space: what all terms hold together is the covariance.
TEST(RandomField, HasTheCovarianceInSpace) {
  RandomField::Surface surface;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 5; ++j) surface[{0.2 * i, 0.3 * j, 0.1 * i * j}] = 1.0 + 0.1 * i;
  }
  constexpr int terms = 30;
  const RandomField any(field("Exponential", 0.7, std::vector<double>(terms, 0.0)), surface);
  const auto at = [&](int k, const base::Vector3& place) {
    std::vector<double> draw(terms, 0.0);
    draw[static_cast<std::size_t>(k)] = 1.0;
    return (any.with(field("Exponential", 0.7, draw))->at(0, place) - 1.0) / 0.2;
  };
  const base::Vector3 a{0.2, 0.3, 0.1}, b{0.8, 0.9, 1.2};
  double covariance = 0.0, variance = 0.0;
  for (int k = 0; k < terms; ++k) {
    covariance += at(k, a) * at(k, b);
    variance += at(k, a) * at(k, a);
  }
  EXPECT_NEAR(covariance, std::exp(-distance(a, b) / 0.7), 1e-4);
  EXPECT_NEAR(variance, 1.0, 1e-4);
}

}  // namespace
}  // namespace harmos::laws
