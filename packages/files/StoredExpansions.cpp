#include <harmos/files/StoredExpansions.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/files/detail/Hdf5Source.hpp>

namespace harmos::files {

std::optional<StoredExpansions> StoredExpansions::read(const std::string& path) {
  const Hdf5Source root = Hdf5Source::open(path);
  const Hdf5Source study = root.group(root.names().front());
  if (!study.has("statistics")) return std::nullopt;
  const Hdf5Source statistics = study.group("statistics");
  if (!statistics.has("basis")) return std::nullopt;
  return StoredExpansions(statistics);
}

StoredExpansions::StoredExpansions(const Hdf5Source& statistics) : parameters_(statistics.texts("variables")) {
  const Hdf5Source basis = statistics.group("basis");
  order_ = basis.integer("order");
  for (const std::string& name : parameters_) {
    const Hdf5Source germ = basis.group(name);
    germs_.push_back(
        {GermMap::read(germ, name), probability::Polynomials::recurrence(germ.group("recurrence_a").values(),
                                                                         germ.group("recurrence_b").values())});
  }
  const auto demand = [](bool fits) {
    if (fits) return;
    throw base::Error("The expansions in the study file are damaged: their sizes do not fit together.",
                      base::ExitCode::input);
  };
  const std::vector<double> degrees = basis.group("degrees").values();
  demand(!germs_.empty() && order_ >= 0 && degrees.size() % germs_.size() == 0);
  for (const Germ& germ : germs_) {
    demand(order_ <= germ.polynomials.largestDegree());
    for (const double a : germ.polynomials.a()) demand(std::isfinite(a));
    for (const double b : germ.polynomials.b()) demand(std::isfinite(b));
  }
  for (const double degree : degrees) demand(degree >= 0.0 && degree <= order_);
  for (std::size_t i = 0; i < degrees.size(); i += germs_.size()) {
    auto& index = indices_.emplace_back();
    for (std::size_t g = 0; g < germs_.size(); ++g) index.push_back(static_cast<int>(degrees[i + g]));
  }
  const Hdf5Source responses = statistics.group("responses");
  for (const std::string& name : responses.texts("order")) {
    const Hdf5Source response = responses.group(name);
    if (!response.has("coefficients")) continue;
    responses_.push_back(name);
    coefficients_.push_back(response.group("coefficients").values());
    demand(coefficients_.back().size() == indices_.size());
    deviations_.push_back(response.number("prediction_error"));
  }
}

std::vector<double> StoredExpansions::germs(const std::vector<double>& point) const {
  std::vector<double> germs;
  for (std::size_t g = 0; g < germs_.size(); ++g) germs.push_back(germs_[g].map.germ(point[g]));
  return germs;
}

std::vector<double> StoredExpansions::evaluate(const std::vector<double>& point) const {
  const std::vector<double> at = germs(point);
  std::vector<std::vector<double>> polynomials;
  for (std::size_t g = 0; g < at.size(); ++g) polynomials.push_back(germs_[g].polynomials.evaluate(at[g], order_));
  std::vector<double> values(coefficients_.size(), 0.0);
  for (std::size_t a = 0; a < indices_.size(); ++a) {
    double product = 1.0;
    for (std::size_t g = 0; g < at.size(); ++g) product *= polynomials[g][indices_[a][g]];
    for (std::size_t r = 0; r < values.size(); ++r) values[r] += coefficients_[r][a] * product;
  }
  return values;
}

bool StoredExpansions::isInside(const std::vector<double>& point) const {
  const std::vector<double> at = germs(point);
  for (std::size_t g = 0; g < at.size(); ++g) {
    const std::vector<double> points = germs_[g].polynomials.gauss(order_ + 1).points;
    const auto [least, most] = std::minmax_element(points.begin(), points.end());
    if (at[g] < *least || at[g] > *most) return false;
  }
  return true;
}

}  // namespace harmos::files
