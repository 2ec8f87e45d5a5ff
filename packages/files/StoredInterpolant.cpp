#include <harmos/files/StoredInterpolant.hpp>

#include <cmath>
#include <limits>

#include <harmos/base/Error.hpp>
#include <harmos/files/detail/Hdf5Source.hpp>

namespace harmos::files {

namespace {

void demand(bool fits) {
  if (fits) return;
  throw base::Error("The interpolation in the study file is damaged: its sizes do not fit together.",
                    base::ExitCode::input);
}

probability::HatSum readHats(const Hdf5Source& group, const std::vector<probability::HatLine>& lines,
                             std::size_t responses) {
  const std::vector<double> nodes = group.group("nodes").values(), factors = group.group("factors").values();
  demand(!lines.empty() && nodes.size() % lines.size() == 0);
  for (const double node : nodes) demand(node >= 0.0 && node < std::numeric_limits<int>::max());
  for (const double factor : factors) demand(std::isfinite(factor));
  std::vector<probability::HatSum::Term> terms(nodes.size() / lines.size());
  for (std::size_t p = 0; p < terms.size(); ++p) {
    for (std::size_t i = 0; i < lines.size(); ++i)
      terms[p].node.push_back(static_cast<int>(nodes[p * lines.size() + i]));
    for (std::size_t r = 0; r < responses && p * responses + r < factors.size(); ++r) {
      terms[p].factors.push_back(factors[p * responses + r]);
    }
  }
  return {lines, std::move(terms)};
}

}  // namespace

std::optional<StoredInterpolant> StoredInterpolant::read(const std::string& path) {
  const Hdf5Source root = Hdf5Source::open(path);
  const Hdf5Source study = root.group(root.names().front());
  if (!study.has("statistics")) return std::nullopt;
  const Hdf5Source statistics = study.group("statistics");
  if (!statistics.has("interpolant")) return std::nullopt;
  return StoredInterpolant(statistics);
}

StoredInterpolant::StoredInterpolant(const Hdf5Source& statistics)
    : parameters_(statistics.texts("variables")), responses_(statistics.group("responses").texts("order")) {
  const Hdf5Source group = statistics.group("interpolant");
  const Hdf5Source germs = group.group("germs");
  std::vector<probability::HatLine> lines;
  for (const std::string& name : parameters_) {
    maps_.push_back(GermMap::read(germs.group(name), name));
    lines.emplace_back(germs.group(name).group("positions").values());
  }
  interpolant_ = results::Interpolant{readHats(group.group("values"), lines, responses_.size()),
                                      readHats(group.group("doubt"), lines, responses_.size()),
                                      group.group("calibrations").values(), group.group("floors").values()};
  demand(interpolant_->calibrations.size() == responses_.size() && interpolant_->floors.size() == responses_.size());
}

StoredInterpolant::Prediction StoredInterpolant::evaluate(const std::vector<double>& point) const {
  Prediction prediction;
  std::vector<double> germs;
  for (std::size_t i = 0; i < maps_.size(); ++i) {
    germs.push_back(maps_[i].germ(point[i]));
    const std::vector<double>& positions = interpolant_->values.lines()[i].germs();
    prediction.isInside = prediction.isInside && germs[i] >= positions.front() && germs[i] <= positions.back();
  }
  prediction.values = interpolant_->values.evaluate(germs);
  const std::vector<double> doubts = interpolant_->doubt.evaluate(germs);
  for (std::size_t r = 0; r < prediction.values.size(); ++r) {
    const double doubt = doubts.empty() ? 0.0 : doubts[r];
    prediction.deviations.push_back(interpolant_->calibrations[r] * doubt + interpolant_->floors[r]);
  }
  return prediction;
}

}  // namespace harmos::files
