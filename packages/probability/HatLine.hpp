#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace harmos::probability {

/// Hierarchical piecewise-linear functions of one germ: the constant 1, falling ramps from both ends of its range to
/// the middle, and hats on ever finer halvings. Each belongs to a node, where it is 1 and where all finer ones are 0.
///
/// The nodes lie as densely as the cube root of the probability density, which gives the least error of the mean of a
/// smooth function. Between two neighbouring nodes of the finest level the probability counts as evenly spread over
/// each quarter; where there is much, as at the values of a sample, over ever smaller parts. Source: Ma, Zabaras, J.
/// Comput. Phys. 228 (2009), doi:10.1016/j.jcp.2009.01.006, sec. 3.1 (the hierarchy).
class HatLine {
 public:
  /// Nodes are numbered 0 to `last` from the lower end of the range to the upper.
  static constexpr int last = 4096, middle = last / 2;  // the node of the constant

  /// The range of the germ, from < to; `cumulative`: its probability not to exceed a value, asked for here only. What
  /// lies out of the range counts as if it were at its ends.
  HatLine(double from, double to, const std::function<double(double)>& cumulative);

  /// With the nodes where those of another line are; it knows values, but no expectations. Throws base::Error (input)
  /// unless the positions are `last` + 1 ascending numbers.
  explicit HatLine(std::vector<double> germs);

  /// Position of a node on the line of the germ [-].
  double germ(int node) const { return germs_[node]; }
  /// Of all nodes.
  const std::vector<double>& germs() const { return germs_; }
  /// The node from whose hat this one refines; none of the middle.
  static std::optional<int> parent(int node);
  /// The nodes whose hats refine this one: two of the middle, one of an end, none on the finest level, else two.
  static std::vector<int> children(int node);
  /// First and last node of where the hat of a node is not zero.
  static std::pair<int, int> support(int node);
  /// The hat of a node at a germ, 0 to 1; beyond the range its value at the end.
  double value(int node, double germ) const;
  /// Expectation of the hat of a node, 0 to 1. Not of a line that was made of positions, as product().
  double mean(int node) const;
  /// Expectation of the product of two hats.
  double product(int node, int other) const;

 private:
  /// The hat at a node; between the node itself and an end of its support it is linear.
  double valueAtNode(int node, int at) const { return value(node, germ(at)); }

  std::vector<double> germs_;
  std::vector<double> moments_[3];  // of the germ up to each node: integral of 1, xi and xi^2
};

}  // namespace harmos::probability
