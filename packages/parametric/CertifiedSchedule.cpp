#include <harmos/parametric/CertifiedSchedule.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/results/StatusName.hpp>

namespace harmos::parametric {

bool CertifiedSchedule::solve(const design::Configuration& configuration, results::ConfigurationResult& result) {
  const std::vector<int> nearest = solver_.states().nearest(configuration.values, 1);
  if (!nearest.empty()) {
    try {
      if (solver_.lacksEquilibrium(configuration, result)) return true;
      const latin::FixedPoint& fixedPoint = solver_.fixedPoint();
      base::Matrix start(fixedPoint.layout().rows(), fixedPoint.assembly().steps()), unused(start);
      solver_.states().copy(nearest[0], start, unused);
      result.starts.push_back(solver_.states().id(nearest[0]));
      if (!solver_.certify(&start, result)) return false;
      if (results::isCertified(result.status)) {
        solver_.rememberCertified(configuration, result);
        return true;
      }
    } catch (const base::Error&) {
      // The cold start below tells whether it was the start.
    }
  }
  return solver_.certifyAnew(configuration, result);
}

void CertifiedSchedule::run(const std::vector<design::Configuration>& open, results::ResultSink& sink) {
  for (const design::Configuration& configuration : open) {
    const double begin = cpuSeconds();
    results::ConfigurationResult result;
    if (solver_.install(configuration, result) && !solve(configuration, result)) return;
    result.cpuSeconds = cpuSeconds() - begin;
    sink.record(result);
  }
}

}  // namespace harmos::parametric
