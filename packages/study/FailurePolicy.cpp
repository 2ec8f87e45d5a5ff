#include <harmos/study/FailurePolicy.hpp>

namespace harmos::study {

FailurePolicy readFailurePolicy(const input::Parameters& study) {
  FailurePolicy policy;
  if (!study.hasList("Failure Policy")) return policy;
  const input::Parameters& list = study.list("Failure Policy");
  if (list.type() == "Retry") {
    policy.attempts = list.integer("Count");
  } else if (list.type() == "Record") {
    policy.kind = FailurePolicy::Kind::record;
  } else if (list.type() == "Abort") {
    policy.kind = FailurePolicy::Kind::abort;
  } else if (list.type() == "Recover") {
    policy.kind = FailurePolicy::Kind::recover;
    policy.values = list.numbers("Values");
  } else {
    policy.kind = FailurePolicy::Kind::continuation;
    policy.steps = list.integer("Steps");
  }
  return policy;
}

bool mayBeHelped(const results::ConfigurationResult& result) {
  return result.status == results::Status::failed || result.status == results::Status::notConverged;
}

}  // namespace harmos::study
