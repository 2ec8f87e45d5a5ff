#include <harmos/laws/RandomField.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

#include <harmos/base/Error.hpp>
#include <harmos/laws/detail/KarhunenLoeve.hpp>

namespace harmos::laws {

namespace {

constexpr double usualShare = 0.9;

std::string percent(double share) {
  std::ostringstream text;
  text.precision(3);
  text << 100.0 * share << " %";
  return text.str();
}

}  // namespace

struct RandomField::Modes {
  KarhunenLoeve expansion;
  std::map<base::Vector3, std::vector<double>> known;  // at the points of the surface
};

input::ParameterSpec RandomField::form() {
  input::ParameterSpec spec("Random");
  spec.summary(
          "A random field of mean 1 over all interfaces and boundaries whose laws follow it, by its Karhunen-Loeve "
          "expansion; a study gives its Coefficients a standard normal Distribution (Mean 0, Standard Deviation 1).")
      .equation(
          "1 + V g, or exp(s g - s^2 v / 2), s^2 = ln(1 + V^2); g = sum of sqrt(lambda_k) phi_k(x) xi_k, v = var g")
      .source("Ghanem, Spanos (1991), section 2.3");
  spec.text("Covariance")
      .required()
      .oneOf({"Exponential", "Gaussian"})
      .doc("Of g at the distance d: exp(-d / l), rough, or exp(-(d / l)^2), smooth; l is the Correlation Length.");
  spec.number("Correlation Length").unit("length").required().above(0.0).doc("l.");
  spec.number("Coefficient of Variation").unit("-").required().atLeast(0.0).doc("V, standard deviation over mean.");
  spec.text("Distribution")
      .defaultValue("Lognormal")
      .oneOf({"Lognormal", "Normal"})
      .doc("Of its values; a Normal one takes values of either sign.");
  spec.number("Energy Share")
      .unit("-")
      .defaultValue(usualShare)
      .atLeast(0.0)
      .below(1.0)
      .doc(
          "Least share of the variance of g over the surface that the terms must hold; with fewer the scene is "
          "refused, "
          "saying how many hold it.");
  spec.namedNumbers("Coefficients")
      .summary(
          "xi_k, one number per term, the term with the most variance first; the names are yours. All 0: the median, "
          "or "
          "the mean of a Normal field.");
  return spec;
}

RandomField::RandomField(const input::Parameters& list, const Surface& surface) {
  const auto refuse = [](const std::string& where, const std::string& what, const std::string& repair) {
    throw base::Error(where + ": " + what + "\n  " + repair, base::ExitCode::input);
  };
  std::vector<base::Vector3> places;
  std::vector<double> weights;
  for (const auto& [place, area] : surface) {
    if (area <= 0.0) continue;
    places.push_back(place);
    weights.push_back(area);
  }
  if (places.empty()) refuse(list.where(), "the interfaces that follow it have no area.", "Give them faces.");
  const auto covariance = list.text("Covariance") == "Gaussian" ? Covariance::gaussian : Covariance::exponential;
  read(list);
  const int terms = static_cast<int>(coefficients_.size());
  auto modes = std::make_shared<Modes>(
      Modes{KarhunenLoeve(places, weights, covariance, list.number("Correlation Length"), terms), {}});
  const double wanted = list.number("Energy Share");
  const KarhunenLoeve& expansion = modes->expansion;
  if (terms > expansion.terms()) {
    refuse(list.where("Coefficients"),
           std::to_string(terms) + " terms are given, but the field has " + std::to_string(expansion.terms()) + ".",
           "Remove the last ones, or refine the mesh.");
  }
  if (expansion.share(terms) < wanted) {
    int needed = terms;
    while (needed < expansion.terms() && expansion.share(needed) < wanted) ++needed;
    refuse(list.where("Coefficients"),
           std::to_string(terms) + " terms hold " + percent(expansion.share(terms)) + " of the variance; " +
               std::to_string(needed) + " hold " + percent(expansion.share(needed)) + ".",
           "Give so many, or a lower \"Energy Share\" than " + percent(wanted) + ".");
  }
  for (std::size_t p = 0; p < places.size(); ++p) modes->known[places[p]] = expansion.atPoint(static_cast<int>(p));
  for (const auto& [place, area] : surface) {
    if (area <= 0.0) modes->known[place] = expansion.at(place);
  }
  modes_ = std::move(modes);
}

void RandomField::read(const input::Parameters& list) {
  coefficients_.clear();
  if (list.hasList("Coefficients")) {
    for (const auto& entry : list.list("Coefficients").entries())
      coefficients_.push_back(std::get<double>(entry.value));
  }
  variation_ = list.number("Coefficient of Variation");
  isLognormal_ = list.text("Distribution") == "Lognormal";
}

std::shared_ptr<const SpatialField> RandomField::with(const input::Parameters& list) const {
  auto other = std::make_shared<RandomField>(*this);
  other->read(list);
  return other;
}

double RandomField::at(int /*step*/, const base::Vector3& place) const {
  const auto found = modes_->known.find(place);
  const std::vector<double> modes = found == modes_->known.end() ? modes_->expansion.at(place) : found->second;
  double value = 0.0, variance = 0.0;
  for (std::size_t k = 0; k < coefficients_.size(); ++k) {
    value += modes[k] * coefficients_[k];
    variance += modes[k] * modes[k];
  }
  if (!isLognormal_) return 1.0 + variation_ * value;
  const double s2 = std::log1p(variation_ * variation_);
  return std::exp(std::sqrt(s2) * value - 0.5 * s2 * variance);
}

}  // namespace harmos::laws
