#include <harmos/setup/FailurePolicy.hpp>

namespace harmos::setup {

FailurePolicy::FailurePolicy(const base::Parameters& study) {
  if (!study.hasList("Failure Policy")) return;
  const base::Parameters& list = study.list("Failure Policy");
  if (list.type() == "Retry") {
    attempts = list.integer("Count");
  } else if (list.type() == "Record") {
    kind = Kind::record;
  } else if (list.type() == "Abort") {
    kind = Kind::abort;
  } else if (list.type() == "Recover") {
    kind = Kind::recover;
  } else {
    kind = Kind::continuation;
    steps = list.integer("Steps");
  }
}

bool mayBeHelped(const study::ConfigurationResult& result) {
  return result.status == study::Status::failed || result.status == study::Status::notConverged;
}

}  // namespace harmos::setup
