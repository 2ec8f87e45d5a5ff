#include <harmos/design/GermDesign.hpp>

namespace harmos::design {

std::vector<std::vector<double>> germsOf(const Design& design, int count, const probability::RandomVector& variables) {
  const Axis unit{"", {}, 0.0, 1.0};
  const double least = 0.5 / count;
  std::vector<std::vector<double>> germs;
  for (auto& point : design.points(std::vector<Axis>(variables.dimension(), unit))) {
    for (double& u : point) u = u > 0.0 ? u : least;
    germs.push_back(variables.germs(point));
  }
  return germs;
}

}  // namespace harmos::design
