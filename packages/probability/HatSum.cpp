#include <harmos/probability/HatSum.hpp>

#include <algorithm>

#include <harmos/probability/detail/Require.hpp>

namespace harmos::probability {

HatSum::HatSum(std::vector<HatLine> lines, std::vector<Term> terms)
    : lines_(std::move(lines)), terms_(std::move(terms)) {
  for (const Term& term : terms_) {
    const bool hasNodes =
        std::all_of(term.node.begin(), term.node.end(), [](int node) { return node >= 0 && node <= HatLine::last; });
    require(term.node.size() == lines_.size() && hasNodes && term.factors.size() == terms_.front().factors.size(),
            "A sum of hats wants a node of every germ and a factor of every function in each of its terms.");
  }
}

std::vector<double> HatSum::evaluate(const std::vector<double>& germs) const {
  if (terms_.empty()) return {};
  std::vector<double> values(terms_.front().factors.size(), 0.0);
  for (const Term& term : terms_) {
    const double hat = hatAt(lines_, term.node, germs);
    if (hat == 0.0) continue;
    for (std::size_t r = 0; r < values.size(); ++r) values[r] += hat * term.factors[r];
  }
  return values;
}

double hatAt(const std::vector<HatLine>& lines, const std::vector<int>& node, const std::vector<double>& germs) {
  double value = 1.0;
  for (std::size_t i = 0; i < node.size() && value != 0.0; ++i) value *= lines[i].value(node[i], germs[i]);
  return value;
}

}  // namespace harmos::probability
