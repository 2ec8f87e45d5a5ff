#include <harmos/latin/detail/OtherSolutions.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <utility>

#include <harmos/latin/March.hpp>

namespace harmos::latin {
namespace {

// Of the accuracy: the residual that is gone to, so that what differs is no error.
constexpr double shareOfAccuracy = 0.01;
// Linear stages of a way, if the known solution took fewer.
constexpr int leastStages = 100;

}  // namespace

OtherSolutions::OtherSolutions(FixedPoint& fixedPoint, int memory, double accuracy, std::function<bool()> mustStop)
    : fixedPoint_(fixedPoint), memory_(memory), accuracy_(accuracy), mustStop_(std::move(mustStop)) {}

void OtherSolutions::extend(Indeterminacy& found, const base::Matrix& alpha,
                            const std::vector<std::shared_ptr<const Response>>& responses, const LatinResult& known) {
  for (base::Matrix& way : found.ways) {
    end_ = fixedPoint_.linearStage().stages() + std::max(leastStages, known.linearStages);
    way += alpha;
    const auto values = from(way, responses);
    for (std::size_t i = 0; values && i < values->size(); ++i) {
      const ResponseResult& response = known.responses[i];
      found.responses[i].extend(response.values, (*values)[i], accuracy_ * response.size);
    }
    way = base::Matrix();
  }
}

std::optional<std::vector<std::vector<double>>> OtherSolutions::from(
    const base::Matrix& start, const std::vector<std::shared_ptr<const Response>>& responses) {
  try {
    base::Matrix alpha(start);
    March march(fixedPoint_, memory_, accuracy_, 0);
    march.setStop([this] { return mustStop_() || fixedPoint_.linearStage().stages() >= end_; });
    const March::End end = march.run(alpha, shareOfAccuracy * accuracy_, March::Guess::state);
    if (end != March::End::reached || !march.isNearEnough()) return std::nullopt;
    base::Matrix image(alpha.numRows(), alpha.numCols());
    const Iterate& there = fixedPoint_.apply(alpha, image);
    fixedPoint_.shareTractions(alpha, image, accuracy_);
    std::vector<std::vector<double>> values;
    for (const auto& response : responses) {
      values.push_back(response->evaluate(there));
      const auto isNumber = [](double value) { return std::isfinite(value); };
      if (!std::all_of(values.back().begin(), values.back().end(), isNumber)) return std::nullopt;
    }
    return values;
  } catch (const std::bad_alloc&) {
    throw;  // of one rank alone
  } catch (const std::exception&) {
    return std::nullopt;  // what a law cannot answer there costs the solution that is known nothing
  }
}

}  // namespace harmos::latin
