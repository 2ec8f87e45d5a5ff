#include <harmos/parametric/MarchBatch.hpp>

#include <harmos/base/Error.hpp>

namespace harmos::parametric {
namespace {

/// To the next column that has to be solved.
void lead(MarchBatch::Member& member) {
  try {
    member.putLaws();
    member.waits = member.iteration->proceed();
  } catch (const base::Error& error) {
    member.waits = false;
    member.error = error.what();
  }
}

}  // namespace

void MarchBatch::run(std::vector<Member>& members, const std::function<bool()>& mustStop) {
  const latin::FixedPoint::AllStepsAtEnd restore(fixedPoint_);
  for (;;) {
    bool isOneThrough = false;
    std::vector<StepSolver::Request> requests;
    for (Member& member : members) {
      if (!member.waits) continue;
      lead(member);
      isOneThrough = isOneThrough || !member.waits;
      if (member.waits) requests.push_back(member.iteration->request());
    }
    if (isOneThrough || requests.empty() || mustStop()) return;
    solver_.solve(requests);
    for (const Member& member : members) {
      if (member.waits) member.iteration->markSolved();
    }
  }
}

}  // namespace harmos::parametric
