#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <harmos/probability/HatSum.hpp>
#include <harmos/probability/RandomVector.hpp>

namespace harmos::probability {

/// Responses as piecewise-linear functions of one to three germs, on a sparse grid that refines itself where it matters
/// for mean and standard deviation. Made for responses with kinks, which polynomials cannot follow.
///
/// Ask and tell: while `next` gives points, solve there and `tell` the values.
/// Each germ ranges over all but the 3e-7 least probable of its values on either side (5 standard deviations of a
/// normal one); beyond, responses count as constant. What that leaves out of the moments, if they go on with the slope
/// that they have there, counts among the errors, and so does what corrects the finest hats, which nothing refines.
/// Source: Ma, Zabaras, J. Comput. Phys. 228 (2009) 3084,
/// doi:10.1016/j.jcp.2009.01.006 (hierarchical surpluses, local refinement).
class PiecewiseLinear {
 public:
  /// When the refinement ends.
  struct Options {
    /// Of the estimated errors of mean and standard deviation, relative to the standard deviation.
    double tolerance = 1e-3;
    /// Of points; refinement ends before it would exceed them.
    int largestCount = 1000;
    /// The response that drives the refinement, from 0; all when not given.
    std::optional<int> response;
  };

  /// Of a germ, on either side, beyond the range that is interpolated: 2.9e-7.
  static double omittedProbability();

  /// Throws base::Error (input) unless there are one to three germs, a positive tolerance and a positive count.
  /// `variables` is shared.
  PiecewiseLinear(std::shared_ptr<const RandomVector> variables, const Options& options);

  /// The next points of germs, [point][germ]; none when the tolerance is reached or the largest count is.
  std::vector<std::vector<double>> next();
  /// Values at the points that `next` gave last, [point][response]. Throws base::Error when one is missing or not
  /// finite, or the response that drives the refinement does not exist.
  void tell(const std::vector<std::vector<double>>& values);

  /// Number of points that were told.
  int count() const { return static_cast<int>(points_.size()); }
  /// All responses at a point of germs, each in its unit. Throws base::Error before the first values.
  std::vector<double> evaluate(const std::vector<double>& germs) const;
  /// The same function, to be kept. Throws as evaluate().
  HatSum function() const;
  /// What the next points are expected to change, as a function of the germs, per response in its unit and at least 0:
  /// it tells where the function is uncertain, but not to what factor. See leftOut().
  HatSum doubt() const;
  /// A point that nothing refines yet, left out: what the others say of it.
  struct LeftOut {
    std::vector<double> errors;  // of the function of all others at the point, per response in its unit
    std::vector<double> doubts;  // what doubt() would be there without the point
  };
  /// All such points: by them doubt() can be calibrated.
  std::vector<LeftOut> leftOut() const;
  /// Of one response, in its unit.
  double mean(int response) const;
  /// The same.
  double standardDeviation(int response) const;
  /// Estimated error of mean and standard deviation, relative to the standard deviation; the largest of the responses
  /// that drive the refinement. An extrapolation of the last corrections, not a bound. Infinite before values are told;
  /// `next` brings it up to date.
  double errorIndicator() const { return error_; }
  /// The same of one response, from 0, whether it drives the refinement or not.
  double errorIndicator(int response) const { return errors_[response] + unseen_[response]; }
  /// Whether the indicator is not above the tolerance.
  bool isReached() const { return error_ <= options_.tolerance; }

 private:
  using Node = std::vector<int>;  // of every germ

  struct Point {
    Node node;
    std::vector<double> surpluses;    // what the value at the node exceeds the coarser functions by, per response
    double mean;                      // of the function of this point
    std::vector<double> covariances;  // of this function and those of all points up to it
  };

  /// The children of all points and what they are expected to change.
  struct Outlook {
    std::map<Node, double> shares;
    std::vector<double> errors;  // per response
  };

  std::vector<double> germsOf(const Node& node) const;
  std::vector<Node> firstNodes() const;
  /// Nodes that refine a point and are none yet.
  std::set<Node> candidates() const;
  /// What lies beyond the range of a germ: how far, on the average.
  struct Tails {
    double lower, upper;
  };

  struct Moments {
    double mean, deviation;
  };

  /// Of all responses.
  std::vector<Moments> allMoments() const;
  /// Per response, relative to the standard deviation: what the moments lack of what lies beyond the range.
  std::vector<double> errorsOfTails() const;
  /// Likewise: what the corrections at the finest nodes, below which nothing can be seen, may change once more.
  std::vector<double> errorsOfCells() const;
  /// From the surpluses of the points that the node would refine.
  std::vector<double> expectedSurpluses(const Node& node) const;
  Outlook outlook() const;
  /// Also for what it refines, in all germs: only then surpluses never change again.
  void ask(const Node& node);
  void add(const Node& node, const std::vector<double>& values);

  std::shared_ptr<const RandomVector> variables_;
  Options options_;
  std::vector<HatLine> lines_;
  std::vector<Tails> tails_;  // of every germ
  std::vector<Point> points_;
  std::map<Node, std::size_t> numbers_;  // of the points
  std::vector<Node> asked_;
  std::vector<double> errors_;  // per response, once values were told: what more points would change
  std::vector<double> unseen_;  // likewise: what they would not
  double error_;
};

}  // namespace harmos::probability
