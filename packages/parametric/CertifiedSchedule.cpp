#include <harmos/parametric/CertifiedSchedule.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/results/StatusName.hpp>

namespace harmos::parametric {

bool CertifiedSchedule::solveFromNearest(const design::Configuration& configuration,
                                         results::ConfigurationResult& result) {
  const int nearest = solver_.states().nearest(configuration.values, 1).front();
  try {
    const latin::FixedPoint& fixedPoint = solver_.fixedPoint();
    base::Matrix start(fixedPoint.layout().rows(), fixedPoint.assembly().steps()), unused(start);
    solver_.states().copy(nearest, start, unused);
    result.starts.push_back(solver_.states().id(nearest));
    if (!solver_.certify(&start, result)) return false;
    if (results::isCertified(result.status)) solver_.rememberCertified(configuration, result);
  } catch (const base::Error&) {
    // A cold start tells whether it was the start.
  }
  return true;
}

bool CertifiedSchedule::solve(const design::Configuration& configuration, results::ConfigurationResult& result) {
  const bool hasNeighbour = solver_.states().count() > 0;
  const double distance = solver_.states().distance(configuration.values);
  const bool isWarm = hasNeighbour && record_.favoursWarm(distance);
  if (isWarm && !solveFromNearest(configuration, result)) return false;
  const int before = result.linearStages;
  if (!results::isCertified(result.status)) {
    if (!solver_.certifyAnew(configuration, result)) return false;
    if (results::isCertified(result.status)) record_.addCold(result.linearStages - before);
  }
  if (isWarm) record_.addWarm(distance, result.linearStages);
  const bool isOpen = result.status == results::Status::notConverged || result.status == results::Status::failed;
  if (isWarm || !hasNeighbour || !isOpen) return true;
  // Dearer or not, it may be the only way.
  const results::ConfigurationResult cold = result;
  if (!solveFromNearest(configuration, result)) return false;
  if (results::isCertified(result.status)) return true;
  const int stages = result.linearStages;
  result = cold;
  result.linearStages = stages;
  return true;
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
