#include <harmos/elasticity/detail/Orthotropic.hpp>

#include <cmath>
#include <string>

#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/elasticity/detail/MaterialEntries.hpp>

namespace harmos::elasticity {
namespace {

using Matrix3 = std::array<std::array<double, 3>, 3>;

constexpr const char* pairs[3] = {"12", "23", "13"};
constexpr std::size_t first[3] = {0, 1, 0};
constexpr std::size_t second[3] = {1, 2, 2};

[[noreturn]] void fail(const std::string& reason) {
  throw base::Error("Orthotropic material: " + reason, base::ExitCode::input);
}

/// Rows are the unit vectors of the material axes.
base::Frame frameOf(base::Vector3 axis1, base::Vector3 axis2) {
  const double length1 = norm(axis1), length2 = norm(axis2);
  if (!(length1 > 0.0 && length2 > 0.0)) fail("Axis 1 and Axis 2 must not be zero.");
  double dot = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    axis1[i] /= length1;
    axis2[i] /= length2;
    dot += axis1[i] * axis2[i];
  }
  for (std::size_t i = 0; i < 3; ++i) axis2[i] -= dot * axis1[i];
  const double rest = norm(axis2);
  if (!(rest > 1e-6)) fail("Axis 1 and Axis 2 are parallel; give two directions that are not.");
  for (double& component : axis2) component /= rest;
  return {axis1, axis2, cross(axis1, axis2)};
}

// Below, the stiffness has too few digits.
constexpr double leastRelative = 1e-7;

/// Normal stresses from normal strains: the inverse of the compliance, which must be positive definite.
Matrix3 normalStiffness(const Orthotropic::Constants& c) {
  const std::array<double, 3>& e = c.youngsModulus;
  Matrix3 s{};
  for (std::size_t i = 0; i < 3; ++i) s[i][i] = 1.0 / e[i];
  for (std::size_t p = 0; p < 3; ++p) {
    const double nu = c.poissonsRatio[p], limit = std::sqrt(e[first[p]] / e[second[p]]);
    if (!(std::abs(nu) < limit)) {
      fail(std::string("Poisson's Ratio ") + pairs[p] + " = " + std::to_string(nu) +
           " gives negative energy: it must lie between -" + std::to_string(limit) + " and " + std::to_string(limit) +
           ", the square root of the ratio of the Young's moduli.");
    }
    s[first[p]][second[p]] = s[second[p]][first[p]] = -nu / e[first[p]];
  }
  Matrix3 inverse{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t a = (j + 1) % 3, b = (j + 2) % 3, d = (i + 1) % 3, f = (i + 2) % 3;
      inverse[i][j] = s[a][d] * s[b][f] - s[a][f] * s[b][d];
    }
  }
  const double determinant = s[0][0] * inverse[0][0] + s[0][1] * inverse[1][0] + s[0][2] * inverse[2][0];
  const double relative = determinant * e[0] * e[1] * e[2];
  if (!(relative > leastRelative)) {
    fail(
        "the three Poisson's ratios together leave no energy, or next to none: 1 - nu12 nu21 - nu23 nu32 - nu13 nu31 - "
        "2 nu21 nu32 "
        "nu13 = " +
        base::toText(relative) + " must be above " + base::toText(leastRelative) +
        " (nu_ji = nu_ij E_j / E_i). Reduce them.");
  }
  for (auto& row : inverse) {
    for (double& entry : row) entry /= determinant;
  }
  return inverse;
}

/// C = T C' T^t, with stress = T stress' from material axes to the global ones.
ElasticityMatrix rotated(const ElasticityMatrix& c, const base::Frame& axes) {
  constexpr std::size_t row[6] = {0, 1, 2, 0, 1, 2};
  constexpr std::size_t column[6] = {0, 1, 2, 1, 2, 0};
  ElasticityMatrix t{}, tc{}, result{};
  for (std::size_t m = 0; m < 6; ++m) {
    const std::size_t i = row[m], j = column[m];
    for (std::size_t n = 0; n < 6; ++n) {
      const std::size_t p = row[n], q = column[n];
      t[m][n] = axes[p][i] * axes[q][j] + (p == q ? 0.0 : axes[q][i] * axes[p][j]);
    }
  }
  for (std::size_t m = 0; m < 6; ++m) {
    for (std::size_t n = 0; n < 6; ++n) {
      for (std::size_t k = 0; k < 6; ++k) tc[m][n] += t[m][k] * c[k][n];
    }
  }
  for (std::size_t m = 0; m < 6; ++m) {
    for (std::size_t n = m; n < 6; ++n) {
      for (std::size_t k = 0; k < 6; ++k) result[m][n] += tc[m][k] * t[n][k];
      result[n][m] = result[m][n];
    }
  }
  return result;
}

Orthotropic::Constants constantsOf(const input::Parameters& parameters) {
  Orthotropic::Constants c;
  for (std::size_t i = 0; i < 3; ++i) {
    c.youngsModulus[i] = parameters.number("Young's Modulus " + std::to_string(i + 1));
    c.poissonsRatio[i] = parameters.number(std::string("Poisson's Ratio ") + pairs[i]);
    c.shearModulus[i] = parameters.number(std::string("Shear Modulus ") + pairs[i]);
  }
  const auto axis = [&parameters](const char* name, base::Vector3& into) {
    if (!parameters.has(name)) return;
    const std::vector<double>& given = parameters.numbers(name);
    if (given.size() != 3) {
      throw base::Error(
          parameters.where(name) + ": three components are needed, " + std::to_string(given.size()) + " are given.",
          base::ExitCode::input);
    }
    std::copy(given.begin(), given.end(), into.begin());
  };
  axis("Axis 1", c.axis1);
  axis("Axis 2", c.axis2);
  return c;
}

/// Three strains along the material axes, in the global ones.
std::optional<Strain> expansionOf(const input::Parameters& parameters, const Orthotropic::Constants& constants) {
  const base::Frame axes = frameOf(constants.axis1, constants.axis2);
  constexpr std::size_t row[6] = {0, 1, 2, 0, 1, 2};
  constexpr std::size_t column[6] = {0, 1, 2, 1, 2, 0};
  std::optional<Strain> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto alpha = optionalNumber(parameters, "Thermal Expansion " + std::to_string(i + 1));
    if (!alpha) continue;
    if (!result) result = Strain{};
    for (std::size_t m = 0; m < 6; ++m) {
      // Shear strains are doubled.
      (*result)[m] += (m < 3 ? 1.0 : 2.0) * *alpha * axes[i][row[m]] * axes[i][column[m]];
    }
  }
  return result;
}

}  // namespace

void Orthotropic::describe(input::ParameterSpec& spec) {
  spec.summary("Orthotropic linear elasticity: nine constants in the material axes 1, 2, 3.")
      .source("Jones, Mechanics of Composite Materials (1999), section 2.3");
  for (const char* axis : {"1", "2", "3"}) {
    spec.number(std::string("Young's Modulus ") + axis)
        .unit("stress")
        .required()
        .above(0.0)
        .doc(std::string("E_") + axis + ".");
  }
  for (const char* pair : pairs) {
    spec.number(std::string("Poisson's Ratio ") + pair)
        .unit("-")
        .required()
        .doc(std::string("nu_") + pair + ": contraction along " + pair[1] + " over extension along " + pair[0] +
             " under tension along " + pair[0] + "; nu_ij / E_i = nu_ji / E_j.");
  }
  for (const char* pair : pairs) {
    spec.number(std::string("Shear Modulus ") + pair)
        .unit("stress")
        .required()
        .above(0.0)
        .doc(std::string("G_") + pair + ".");
  }
  spec.numbers("Axis 1").unit("-").optional().doc("Direction of material axis 1, any length; default (1, 0, 0).");
  spec.numbers("Axis 2").unit("-").optional().doc(
      "Direction of material axis 2, any length, made orthogonal to axis 1; default (0, 1, 0).");
  describeDensity(spec);
  for (const std::string axis : {"1", "2", "3"}) {
    describeExpansion(spec, "Thermal Expansion " + axis,
                      "alpha_" + axis + ", strain along axis " + axis +
                          " per change of temperature, for Temperatures; " +
                          "where one is given, those that are not are 0.");
  }
}

Orthotropic::Orthotropic(const Constants& constants) : elasticity_{} {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(constants.youngsModulus[i] > 0.0 && constants.shearModulus[i] > 0.0)) {
      fail("all Young's and shear moduli must be above 0.");
    }
  }
  const Matrix3 normal = normalStiffness(constants);
  ElasticityMatrix c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) c[i][j] = normal[i][j];
    c[i + 3][i + 3] = constants.shearModulus[i];
  }
  elasticity_ = rotated(c, frameOf(constants.axis1, constants.axis2));
}

Orthotropic::Orthotropic(const input::Parameters& parameters) try : Orthotropic(constantsOf(parameters)) {
  density_ = optionalNumber(parameters, "Density");
  expansion_ = expansionOf(parameters, constantsOf(parameters));
} catch (const base::Error& error) {
  const std::string message = error.what();
  throw base::Error(
      message.find(parameters.where()) == std::string::npos ? parameters.where() + ": " + message : message,
      error.code());
}

}  // namespace harmos::elasticity
