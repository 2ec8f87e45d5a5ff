#include <harmos/stochastic/detail/ProjectedLaw.hpp>

namespace harmos::stochastic {

void ProjectedLaw::solve(int column, const laws::NodeArrays& nodes) const {
  const int step = column / projection_->terms();
  const int term = column % projection_->terms();
  const auto count = static_cast<std::size_t>(nodes.count);
  std::vector<laws::LocalState> states(count);
  laws::NodeArrays realised = nodes;
  realised.state = states.data();
  for (std::size_t p = 0; p < count; ++p) nodes.state[p] = {};
  for (int q = 0; q < projection_->points(); ++q) {
    const double weight = projection_->projector()(term, q);
    realisations_[q]->solve(step, realised);
    for (std::size_t p = 0; p < count; ++p) {
      for (std::size_t c = 0; c < 3; ++c) nodes.state[p].traction[c] += weight * states[p].traction[c];
    }
  }
}

}  // namespace harmos::stochastic
