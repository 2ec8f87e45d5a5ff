#include <harmos/latin/March.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/latin/detail/SafeRelaxation.hpp>

namespace harmos::latin {
namespace {

constexpr int maximumLandings = 20;
// When so many have not removed a relative imbalance of this size, a body may be flying: the acceleration is left out,
// so that the bodies that it flies among come to rest and the watch sees what is lacking.
constexpr int iterationsBeforeListening = 36;
constexpr double flying = 0.1;

}  // namespace

void extrapolate(const base::Matrix& alpha, int step, const std::vector<double>& times, double* state) {
  const auto t = static_cast<std::size_t>(step);
  const double ratio = step < 2 ? 0.0 : (times[t] - times[t - 1]) / (times[t - 1] - times[t - 2]);
  for (int row = 0; row < alpha.numRows(); ++row) {
    const double last = step > 0 ? alpha[step - 1][row] : 0.0;
    state[row] = step < 2 ? last : last + ratio * (last - alpha[step - 2][row]);
  }
}

March::March(FixedPoint& fixedPoint, int memory, double accuracy)
    : fixedPoint_(fixedPoint),
      accuracy_(accuracy),
      accelerations_(static_cast<std::size_t>(fixedPoint.assembly().steps()),
                     AndersonAcceleration(fixedPoint.metric(), memory, fixedPoint.assembly().isAffine())) {}

March::End March::iterate(int step, base::Matrix& state, double tolerance) {
  const StateMetric& metric = fixedPoint_.metric();
  AndersonAcceleration& acceleration = accelerations_[step];
  acceleration.resume();
  EquilibriumWatch watch(accuracy_);
  base::Matrix image(state.numRows(), 1);
  int iteration = 0, sinceLanding = 0, landings = 0;
  bool isListening = false;
  End end = End::reached;
  const Iterate* iterate = nullptr;
  while (sinceLanding < maximumIterations && landings < maximumLandings) {
    iterate = &fixedPoint_.apply(state, image);
    ++iteration;
    ++sinceLanding;
    const double size = metric.distance(image, state);
    const double force = std::max(largestForce_, metric.norm(iterate->hattedTraction()));
    if (size <= std::max(tolerance * force, noise * metric.norm(image))) {
      largestForce_ = force;
      break;
    }
    if (mustStop_ && mustStop_()) {
      end = End::stopped;
      break;
    }
    const EquilibriumWatch::Finding finding = watch.look(fixedPoint_, iterate, state, image);
    if (finding == EquilibriumWatch::Finding::landing) {
      acceleration.restart();
      sinceLanding = 0;
      ++landings;
      isListening = false;
      continue;
    }
    if (finding == EquilibriumWatch::Finding::noEquilibrium) {
      imbalance_ = watch.imbalance();
      imbalance_.step = step;
      end = End::noEquilibrium;
      break;
    }
    if (sinceLanding == iterationsBeforeListening) isListening = largestImbalance(*iterate).relative > flying;
    if (!isListening) {
      acceleration.advance(state, image);
      continue;
    }
    for (int row = 0; row < state.numRows(); ++row) state(row, 0) = relaxSafely(state(row, 0), image(row, 0));
  }
  state.assign(image);
  if (observer_) observer_(step, iteration, *iterate);
  return end;
}

March::End March::run(base::Matrix& alpha, double tolerance, Guess guess) {
  const int rows = alpha.numRows();
  base::Matrix state(rows, 1);  // no view of alpha: copies of a view share its values
  End end = End::reached;
  // All load steps are selected again at the end, also when a law throws.
  const struct Restore {
    FixedPoint& fixedPoint;
    ~Restore() {
      fixedPoint.startUnloaded();
      fixedPoint.selectAll();
    }
  } restore{fixedPoint_};
  fixedPoint_.startUnloaded();
  for (int t = 0; t < alpha.numCols(); ++t) {
    if (end == End::reached) {
      if (guess == Guess::extrapolation) {
        extrapolate(alpha, t, fixedPoint_.assembly().times, state[0]);
      } else {
        std::copy_n(alpha[t], rows, state[0]);
      }
      fixedPoint_.select({t});
      end = iterate(t, state, tolerance);
      fixedPoint_.startFromHere();
    }
    std::copy_n(state[0], rows, alpha[t]);
  }
  return end;
}

}  // namespace harmos::latin
