#pragma once

#include <vector>

#include <harmos/probability/HatLine.hpp>

namespace harmos::probability {

/// Several functions of germs as sums of products of hats, one HatLine per germ: f_r(xi) = sum over p of s_pr times the
/// product over i of hat_{n_pi}(xi_i). p: terms, r: functions, n_pi: nodes.
class HatSum {
 public:
  /// A product of hats, and its factor in every function.
  struct Term {
    std::vector<int> node;        // of every germ
    std::vector<double> factors;  // s_pr, in the units of the functions
  };

  /// Throws base::Error (input) when a term has another number of germs or factors than the others, or a node that the
  /// lines do not have.
  HatSum(std::vector<HatLine> lines, std::vector<Term> terms);

  /// One per germ.
  const std::vector<HatLine>& lines() const { return lines_; }
  /// As given.
  const std::vector<Term>& terms() const { return terms_; }
  /// All functions at a point, [germ]; none without a term.
  std::vector<double> evaluate(const std::vector<double>& germs) const;

 private:
  std::vector<HatLine> lines_;
  std::vector<Term> terms_;
};

/// The product of the hats of a node, [germ], at a point, [germ]: 0 to 1.
double hatAt(const std::vector<HatLine>& lines, const std::vector<int>& node, const std::vector<double>& germs);

}  // namespace harmos::probability
