#include <harmos/probability/PiecewiseLinear.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <harmos/probability/detail/Require.hpp>
#include <harmos/probability/detail/StandardNormal.hpp>

namespace harmos::probability {

namespace {

// Standard deviations of a normal germ up to which it is interpolated.
constexpr double interpolatedDeviations = 5.0;
// Of surpluses when the width is halved: that of a smooth function, and of a kink on the average.
constexpr double decayByHalving = 0.25;
// Weights of the smallest and the largest forecast of parents that disagree: mostly that means that the germs do not
// interact; a tenth guards against a chance zero.
constexpr double weightOfLeast = 0.9, weightOfMost = 0.1;
// Of the tolerance: refinement goes on to it where what is not seen leaves less.
constexpr double leastShare = 0.25;
// Of a tail that falls like an exponential function: what lies beyond a quarter of it, over the mean of all that does;
// and the mean square over the square of the mean.
constexpr double quarterOfTail = 1.386294361, squareOfTail = 2.0;

/// Halvings from the middle to a node: 0 of the middle, 1 of the ends.
int levelOf(int node) {
  int level = 0;
  for (auto parent = HatLine::parent(node); parent; parent = HatLine::parent(*parent)) ++level;
  return level;
}

}  // namespace

double PiecewiseLinear::omittedProbability() {
  return normalCumulative(-interpolatedDeviations);
}

PiecewiseLinear::PiecewiseLinear(std::shared_ptr<const RandomVector> variables, const Options& options)
    : variables_(std::move(variables)), options_(options), error_(std::numeric_limits<double>::infinity()) {
  constexpr int mostGerms = 3;
  const int dimension = variables_->dimension();
  require(dimension <= mostGerms, "Piecewise-linear interpolation takes one to three random parameters, not " +
                                      std::to_string(dimension) + "; with more use a chaos expansion or samples.");
  require(options_.tolerance > 0.0, "Piecewise-linear interpolation needs a tolerance above 0.");
  require(options_.largestCount > 0, "Piecewise-linear interpolation needs a largest number of points above 0.");
  const double omitted = omittedProbability();
  const auto size = static_cast<std::size_t>(dimension);
  const std::vector<double> from = variables_->germs(std::vector<double>(size, omitted));
  const std::vector<double> to = variables_->germs(std::vector<double>(size, 1.0 - omitted));
  const std::vector<double> below = variables_->germs(std::vector<double>(size, omitted / 4.0));
  const std::vector<double> beyond = variables_->germs(std::vector<double>(size, 1.0 - omitted / 4.0));
  for (std::size_t i = 0; i < size; ++i) {
    const Distribution& distribution = *variables_->variables()[i].distribution;
    const bool isIndependent = variables_->isIndependent();
    lines_.emplace_back(from[i], to[i], [&distribution, isIndependent](double germ) {
      return isIndependent ? distribution.cumulative(distribution.value(germ)) : normalCumulative(germ);
    });
    tails_.push_back({(from[i] - below[i]) / quarterOfTail, (beyond[i] - to[i]) / quarterOfTail});
  }
}

std::vector<double> PiecewiseLinear::germsOf(const Node& node) const {
  std::vector<double> germs;
  for (std::size_t i = 0; i < node.size(); ++i) germs.push_back(lines_[i].germ(node[i]));
  return germs;
}

std::vector<PiecewiseLinear::Node> PiecewiseLinear::firstNodes() const {
  const int levels = lines_.size() == 1 ? 3 : 2;
  std::vector<Node> nodes{{}};
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    std::vector<Node> longer;
    for (const Node& node : nodes) {
      int used = 0;
      for (const int at : node) used += levelOf(at);
      std::vector<int> line{HatLine::middle};
      for (std::size_t k = 0; k < line.size(); ++k) {
        longer.push_back(node);
        longer.back().push_back(line[k]);
        if (used + levelOf(line[k]) == levels) continue;
        const std::vector<int> children = HatLine::children(line[k]);
        line.insert(line.end(), children.begin(), children.end());
      }
    }
    nodes = std::move(longer);
  }
  return nodes;
}

std::vector<double> PiecewiseLinear::expectedSurpluses(const Node& node) const {
  std::vector<double> least, most;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto parent = HatLine::parent(node[i]);
    if (!parent) continue;
    Node other = node;
    other[i] = *parent;
    const auto known = numbers_.find(other);
    if (known == numbers_.end()) continue;
    // From the constant to the ends nothing is halved.
    const double decay = *parent == HatLine::middle ? 1.0 : decayByHalving;
    std::vector<double> surpluses = points_[known->second].surpluses;
    for (double& surplus : surpluses) surplus *= decay;
    if (least.empty()) least = most = surpluses;
    for (std::size_t r = 0; r < surpluses.size(); ++r) {
      if (std::abs(surpluses[r]) < std::abs(least[r])) least[r] = surpluses[r];
      if (std::abs(surpluses[r]) > std::abs(most[r])) most[r] = surpluses[r];
    }
  }
  for (std::size_t r = 0; r < least.size(); ++r) least[r] = weightOfLeast * least[r] + weightOfMost * most[r];
  return least;
}

std::set<PiecewiseLinear::Node> PiecewiseLinear::candidates() const {
  std::set<Node> nodes;
  for (const Point& point : points_) {
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      for (const int child : HatLine::children(point.node[i])) {
        Node node = point.node;
        node[i] = child;
        if (numbers_.count(node) == 0) nodes.insert(std::move(node));
      }
    }
  }
  return nodes;
}

std::vector<PiecewiseLinear::Moments> PiecewiseLinear::allMoments() const {
  std::vector<Moments> moments;
  for (int r = 0; r < static_cast<int>(points_.front().surpluses.size()); ++r)
    moments.push_back({mean(r), standardDeviation(r)});
  return moments;
}

std::vector<double> PiecewiseLinear::errorsOfTails() const {
  const double omitted = omittedProbability();
  const std::vector<Moments> moments = allMoments();
  std::vector<double> errors(moments.size(), 0.0);
  std::vector<double> middle;
  for (const HatLine& line : lines_) middle.push_back(line.germ(HatLine::middle));
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    for (const bool isUpper : {false, true}) {
      const int end = isUpper ? HatLine::last : 0, inside = isUpper ? end - 1 : 1;
      const double excess = isUpper ? tails_[i].upper : tails_[i].lower;
      std::vector<double> germs = middle;
      germs[i] = lines_[i].germ(end);
      const std::vector<double> atEnd = evaluate(germs);
      germs[i] = lines_[i].germ(inside);
      const std::vector<double> before = evaluate(germs);
      const double length = std::abs(lines_[i].germ(end) - lines_[i].germ(inside));
      for (std::size_t r = 0; r < errors.size(); ++r) {
        const auto [average, deviation] = moments[r];
        if (!(deviation > 0.0)) continue;
        const double distance = (atEnd[r] - average) / deviation;
        const double further = (atEnd[r] - before[r]) / length * excess / deviation;
        const double ofVariance = 2.0 * distance * further + squareOfTail * further * further;
        errors[r] += omitted * std::max(std::abs(further), 0.5 * std::abs(ofVariance));
      }
    }
  }
  return errors;
}

std::vector<double> PiecewiseLinear::errorsOfCells() const {
  const std::vector<Moments> moments = allMoments();
  std::vector<double> errors(moments.size(), 0.0);
  for (const Point& point : points_) {
    const bool isFinest =
        std::any_of(point.node.begin(), point.node.end(), [](int node) { return HatLine::children(node).empty(); });
    if (!isFinest) continue;
    std::vector<std::vector<double>> around{evaluate(germsOf(point.node))};
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const auto [left, right] = HatLine::support(point.node[i]);
      for (const int side : {left, right}) {
        Node other = point.node;
        other[i] = side;
        around.push_back(evaluate(germsOf(other)));
      }
    }
    for (std::size_t r = 0; r < errors.size(); ++r) {
      const auto [average, deviation] = moments[r];
      if (!(deviation > 0.0)) continue;
      double distance = 1.0;
      for (const std::vector<double>& values : around)
        distance = std::max(distance, std::abs(values[r] - average) / deviation);
      errors[r] += std::abs(point.surpluses[r]) * point.mean / deviation * distance;
    }
  }
  return errors;
}

PiecewiseLinear::Outlook PiecewiseLinear::outlook() const {
  Outlook outlook;
  for (const Node& node : candidates()) outlook.shares[node] = 0.0;
  struct Candidate {
    double* share;
    double probability;
    std::vector<double> values, surpluses;
  };
  std::vector<Candidate> candidates;
  for (auto& [node, share] : outlook.shares) {
    double probability = 1.0;
    for (std::size_t i = 0; i < lines_.size(); ++i) probability *= lines_[i].mean(node[i]);
    candidates.push_back({&share, probability, evaluate(germsOf(node)), expectedSurpluses(node)});
  }
  for (std::size_t r = 0; r < points_.front().surpluses.size(); ++r) {
    const int response = static_cast<int>(r);
    const bool isDriving = options_.response.value_or(response) == response;
    outlook.errors.push_back(0.0);
    const double average = mean(response), deviation = standardDeviation(response);
    if (!(deviation > 0.0)) continue;
    double ofMean = 0.0, ofDeviation = 0.0, sum = 0.0;
    for (const Candidate& candidate : candidates) {
      const double effect = candidate.surpluses[r] * candidate.probability / deviation;
      const double distance = (candidate.values[r] - average) / deviation;
      const double share = std::abs(effect) * std::max(1.0, std::abs(distance));
      ofMean += effect;
      ofDeviation += effect * distance;
      sum += share;
      if (isDriving) *candidate.share = std::max(*candidate.share, share);
    }
    // What the candidates leave adds a third, a quarter of it and so on. Along a kink that is oblique to the germs
    // signs alternate and part of the sum cancels, but not reliably.
    outlook.errors.back() = std::max(std::abs(ofMean), std::abs(ofDeviation)) + sum;
  }
  return outlook;
}

std::vector<std::vector<double>> PiecewiseLinear::next() {
  asked_.clear();
  if (points_.empty()) {
    asked_ = firstNodes();
  } else {
    const Outlook ahead = outlook();
    // Near a kink a surplus may be small by chance: one batch of points does not gain more than a factor.
    constexpr double mostGain = 3.0;
    const std::vector<double> before = errors_;
    const std::vector<double> ofTails = errorsOfTails(), ofCells = errorsOfCells();
    errors_ = ahead.errors;
    unseen_.assign(errors_.size(), 0.0);
    error_ = 0.0;
    bool isOver = true;
    for (std::size_t r = 0; r < errors_.size(); ++r) {
      if (!before.empty() && errors_[r] > 0.0) errors_[r] = std::max(errors_[r], before[r] / mostGain);
      unseen_[r] = ofTails[r] + ofCells[r];
      const int response = static_cast<int>(r);
      if (options_.response.value_or(response) != response) continue;
      error_ = std::max(error_, errorIndicator(response));
      // More points do not help against what is not seen.
      const double rest = std::max(options_.tolerance - unseen_[r], leastShare * options_.tolerance);
      isOver = isOver && errors_[r] <= rest;
    }
    if (isOver) return {};
    std::vector<std::pair<double, Node>> order;
    double total = 0.0;
    for (const auto& [node, share] : ahead.shares) {
      order.emplace_back(-share, node);
      total += share;
    }
    std::sort(order.begin(), order.end());
    constexpr double shareTaken = 0.6;
    double taken = 0.0;
    for (const auto& [share, node] : order) {
      if (taken >= shareTaken * total) break;
      taken -= share;
      ask(node);
    }
  }
  const auto room = static_cast<std::size_t>(std::max(0, options_.largestCount - count()));
  if (asked_.size() > room) asked_.resize(room);
  std::vector<std::vector<double>> germs;
  for (const Node& node : asked_) germs.push_back(germsOf(node));
  return germs;
}

void PiecewiseLinear::ask(const Node& node) {
  if (numbers_.count(node) > 0 || std::find(asked_.begin(), asked_.end(), node) != asked_.end()) return;
  for (std::size_t j = 0; j < node.size(); ++j) {
    const auto parent = HatLine::parent(node[j]);
    if (!parent) continue;
    Node other = node;
    other[j] = *parent;
    ask(other);
  }
  asked_.push_back(node);
}

void PiecewiseLinear::tell(const std::vector<std::vector<double>>& values) {
  if (values.empty() || values.size() != asked_.size())
    throw base::Error("piecewise-linear interpolation needs values at each of the points that it asked for");
  const std::size_t responses = points_.empty() ? values.front().size() : points_.front().surpluses.size();
  if (options_.response && (*options_.response < 0 || *options_.response >= static_cast<int>(responses)))
    throw base::Error("the response that drives piecewise-linear interpolation does not exist");
  for (const auto& value : values) {
    if (value.size() != responses ||
        !std::all_of(value.begin(), value.end(), [](double v) { return std::isfinite(v); }))
      throw base::Error("piecewise-linear interpolation needs a finite value of every response at each point");
  }
  // Coarse functions first: those that are not zero at a point come before it.
  std::vector<std::size_t> order(asked_.size());
  std::vector<int> levels;
  for (std::size_t k = 0; k < order.size(); ++k) {
    order[k] = k;
    levels.push_back(0);
    for (const int at : asked_[k]) levels.back() += levelOf(at);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return levels[a] < levels[b]; });
  for (const std::size_t k : order) add(asked_[k], values[k]);
  asked_.clear();
}

void PiecewiseLinear::add(const Node& node, const std::vector<double>& values) {
  Point point{node, values, 1.0, {}};
  if (!points_.empty()) {
    const std::vector<double> known = evaluate(germsOf(node));
    for (std::size_t r = 0; r < values.size(); ++r) point.surpluses[r] -= known[r];
  }
  for (std::size_t i = 0; i < node.size(); ++i) point.mean *= lines_[i].mean(node[i]);
  numbers_[node] = points_.size();
  points_.push_back(std::move(point));
  Point& added = points_.back();
  for (const Point& other : points_) {
    double product = 1.0;
    for (std::size_t i = 0; i < node.size() && product != 0.0; ++i)
      product *= lines_[i].product(node[i], other.node[i]);
    added.covariances.push_back(product - added.mean * other.mean);
  }
}

std::vector<double> PiecewiseLinear::evaluate(const std::vector<double>& germs) const {
  if (points_.empty()) throw base::Error("piecewise-linear interpolation has been told no values yet");
  std::vector<double> values(points_.front().surpluses.size(), 0.0);
  for (const Point& point : points_) {
    const double function = hatAt(lines_, point.node, germs);
    if (function == 0.0) continue;
    for (std::size_t r = 0; r < values.size(); ++r) values[r] += function * point.surpluses[r];
  }
  return values;
}

HatSum PiecewiseLinear::function() const {
  if (points_.empty()) throw base::Error("piecewise-linear interpolation has been told no values yet");
  std::vector<HatSum::Term> terms;
  for (const Point& point : points_) terms.push_back({point.node, point.surpluses});
  return {lines_, std::move(terms)};
}

HatSum PiecewiseLinear::doubt() const {
  std::vector<HatSum::Term> terms;
  for (const Node& node : candidates()) {
    std::vector<double> sizes = expectedSurpluses(node);
    for (double& size : sizes) size = std::abs(size);
    terms.push_back({node, std::move(sizes)});
  }
  return {lines_, std::move(terms)};
}

std::vector<PiecewiseLinear::LeftOut> PiecewiseLinear::leftOut() const {
  std::vector<LeftOut> result;
  for (const Point& point : points_) {
    bool isRefined = false;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      for (const int child : HatLine::children(point.node[i])) {
        Node node = point.node;
        node[i] = child;
        isRefined = isRefined || numbers_.count(node) > 0;
      }
    }
    std::vector<double> doubts = expectedSurpluses(point.node);
    if (isRefined || doubts.empty()) continue;
    LeftOut one{point.surpluses, std::move(doubts)};
    for (double& error : one.errors) error = std::abs(error);
    for (double& doubt : one.doubts) doubt = std::abs(doubt);
    result.push_back(std::move(one));
  }
  return result;
}

double PiecewiseLinear::mean(int response) const {
  double sum = 0.0;
  for (const Point& point : points_) sum += point.surpluses[response] * point.mean;
  return sum;
}

double PiecewiseLinear::standardDeviation(int response) const {
  const auto r = static_cast<std::size_t>(response);
  double variance = 0.0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    double sum = 0.0;
    for (std::size_t j = 0; j < i; ++j) sum += points_[i].covariances[j] * points_[j].surpluses[r];
    variance += points_[i].surpluses[r] * (2.0 * sum + points_[i].covariances[i] * points_[i].surpluses[r]);
  }
  return std::sqrt(std::max(variance, 0.0));
}

}  // namespace harmos::probability
