#include <harmos/study/FailurePolicy.hpp>

namespace harmos::study {

FailurePolicy::FailurePolicy(const input::Parameters& study) {
  if (!study.hasList("Failure Policy")) return;
  const input::Parameters& list = study.list("Failure Policy");
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

bool mayBeHelped(const results::ConfigurationResult& result) {
  return result.status == results::Status::failed || result.status == results::Status::notConverged;
}

}  // namespace harmos::study
