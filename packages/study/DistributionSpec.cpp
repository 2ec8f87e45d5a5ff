#include <harmos/study/detail/DistributionSpec.hpp>

#include <cmath>
#include <filesystem>
#include <optional>

#include <harmos/probability/Beta.hpp>
#include <harmos/probability/Lognormal.hpp>
#include <harmos/probability/Normal.hpp>
#include <harmos/probability/Sample.hpp>
#include <harmos/probability/TruncatedNormal.hpp>
#include <harmos/probability/Uniform.hpp>
#include <harmos/study/PointsFile.hpp>

namespace harmos::study {

namespace {

using input::Parameters;

// Beyond these a beta distribution is all but one value, or two, and neither its polynomials nor its quantiles are
// found.
constexpr double leastShape = 1e-6, mostShape = 1e8;

void addSpread(input::ParameterSpec& spec, const char* ofWhat) {
  const std::string what = ofWhat;
  spec.number("Mean").required().doc("Mean of " + what + ".");
  spec.number("Standard Deviation").optional().atLeast(0.0).doc("Of " + what + "; or give a Coefficient of Variation.");
  spec.number("Coefficient of Variation")
      .unit("-")
      .optional()
      .atLeast(0.0)
      .doc("Standard deviation of " + what + " over its mean, instead of a Standard Deviation.");
}

/// The standard deviation; nothing when it is given not at all or twice, which is then reported.
std::optional<double> readSpread(const Parameters& list, input::ErrorList& errors) {
  const bool isAbsolute = list.has("Standard Deviation"), isRelative = list.has("Coefficient of Variation");
  if (isAbsolute == isRelative) {
    errors.add(list.where(), std::string("its standard deviation is given ") + (isAbsolute ? "twice." : "not at all."),
               "Give either a Standard Deviation or a Coefficient of Variation.");
    return std::nullopt;
  }
  if (isAbsolute) return list.number("Standard Deviation");
  if (list.number("Mean") == 0.0) {
    errors.add(list.where("Coefficient of Variation"), "a mean of 0 has no coefficient of variation.",
               "Give a Standard Deviation.");
    return std::nullopt;
  }
  return list.number("Coefficient of Variation") * std::abs(list.number("Mean"));
}

std::shared_ptr<const probability::Distribution> readUniform(const Parameters& list, input::ErrorList& errors) {
  const bool hasBounds = list.has("Lower") && list.has("Upper");
  if (hasBounds == list.has("Mean")) {
    errors.add(list.where(), "a uniform distribution wants Lower and Upper, or a Mean and its spread.",
               "Give one of them.");
    return nullptr;
  }
  if (hasBounds) return std::make_shared<probability::Uniform>(list.number("Lower"), list.number("Upper"));
  const auto deviation = readSpread(list, errors);
  if (!deviation) return nullptr;
  const double halfWidth = std::sqrt(3.0) * *deviation;
  return std::make_shared<probability::Uniform>(list.number("Mean") - halfWidth, list.number("Mean") + halfWidth);
}

std::shared_ptr<const probability::Distribution> readSample(const Parameters& list, const std::string& parameter,
                                                            const std::string& directory, input::ErrorList& errors) {
  if (list.has("File") == list.has("Values")) {
    errors.add(list.where(), "a sample wants either a File or Values.", "Give one of them.");
    return nullptr;
  }
  if (list.has("Values")) return std::make_shared<probability::Sample>(list.numbers("Values"));
  std::vector<double> values;
  for (const auto& row : readPoints(sampleFileOf(list, directory), {parameter})) values.push_back(row.front());
  return std::make_shared<probability::Sample>(std::move(values));
}

}  // namespace

std::string sampleFileOf(const Parameters& list, const std::string& directory) {
  if (list.type() != "Sample" || !list.has("File")) return "";
  return (std::filesystem::path(directory) / list.text("File")).lexically_normal().string();
}

std::vector<input::ParameterSpec> distributionForms() {
  input::ParameterSpec normal("Normal"), lognormal("Lognormal"), truncated("Truncated Normal"), uniform("Uniform"),
      beta("Beta"), sample("Sample");
  addSpread(normal.summary("Gaussian. Takes values of either sign: a stiffness had better be Lognormal."),
            "the parameter");
  addSpread(lognormal.summary("Positive; its logarithm is Gaussian. Recommended for stiffness, friction, preload."),
            "the parameter itself, not of its logarithm");
  addSpread(truncated.summary("A Gaussian that is known to lie between bounds."),
            "the Gaussian before its tails are cut off");
  truncated.number("Lower").optional().doc("Least value; absent: none.");
  truncated.number("Upper").optional().doc("Largest value; absent: none.");
  uniform.summary("All values between two bounds, given by these or by mean and spread.");
  uniform.number("Lower").optional().doc("Least value.");
  uniform.number("Upper").optional().doc("Largest value.");
  uniform.number("Mean").optional().doc("Instead of bounds: they are the mean -+ sqrt(3) standard deviations.");
  uniform.number("Standard Deviation").optional().above(0.0).doc("With a Mean.");
  uniform.number("Coefficient of Variation").unit("-").optional().above(0.0).doc("With a Mean.");
  beta.summary("Density (x - Lower)^(Alpha - 1) (Upper - x)^(Beta - 1), but for a factor.");
  beta.number("Lower").required().doc("Least value.");
  beta.number("Upper").required().doc("Largest value.");
  beta.number("Alpha")
      .unit("-")
      .required()
      .atLeast(leastShape)
      .atMost(mostShape)
      .doc("Shape at the lower end; 1: finite there.");
  beta.number("Beta")
      .unit("-")
      .required()
      .atLeast(leastShape)
      .atMost(mostShape)
      .doc("Shape at the upper end; 1: finite there.");
  sample.summary("Observed values, each as likely as the others.");
  sample.text("File").optional().doc("CSV with a column headed by the name of the parameter, relative to the study.");
  sample.numbers("Values").optional().doc("The values themselves.");
  return {normal, lognormal, truncated, uniform, beta, sample};
}

std::shared_ptr<const probability::Distribution> readDistribution(const Parameters& list, const std::string& parameter,
                                                                  const std::string& directory,
                                                                  input::ErrorList& errors) {
  std::shared_ptr<const probability::Distribution> distribution;
  errors.collect(list.where(), [&] {
    const std::string& type = list.type();
    if (type == "Uniform") {
      distribution = readUniform(list, errors);
    } else if (type == "Beta") {
      distribution = std::make_shared<probability::Beta>(list.number("Lower"), list.number("Upper"),
                                                         list.number("Alpha"), list.number("Beta"));
    } else if (type == "Sample") {
      distribution = readSample(list, parameter, directory, errors);
    } else if (const auto deviation = readSpread(list, errors)) {
      const double mean = list.number("Mean");
      if (type == "Normal") distribution = std::make_shared<probability::Normal>(mean, *deviation);
      if (type == "Lognormal") distribution = std::make_shared<probability::Lognormal>(mean, *deviation);
      if (type == "Truncated Normal") {
        const auto bound = [&](const char* name) -> std::optional<double> {
          return list.has(name) ? std::optional<double>(list.number(name)) : std::nullopt;
        };
        distribution = std::make_shared<probability::TruncatedNormal>(mean, *deviation, bound("Lower"), bound("Upper"));
      }
    }
  });
  return distribution;
}

}  // namespace harmos::study
