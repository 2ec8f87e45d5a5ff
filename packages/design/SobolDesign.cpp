#include <harmos/design/SobolDesign.hpp>

#include <cmath>
#include <cstdint>

#include <boost/random/sobol.hpp>

#include <harmos/design/detail/RandomNumbers.hpp>

namespace harmos::design {

std::vector<std::vector<double>> SobolDesign::points(const std::vector<Axis>& axes) const {
  boost::random::sobol_engine<std::uint64_t, 53> sequence(axes.size());
  RandomNumbers random(seed_);
  std::vector<std::uint64_t> shift(axes.size(), 0);
  if (seed_ != 0) {
    for (auto& digits : shift) digits = static_cast<std::uint64_t>(std::ldexp(random.fraction(), 53));
  }
  std::vector<std::vector<double>> points(count_);
  for (auto& point : points) {
    for (std::size_t a = 0; a < axes.size(); ++a) {
      point.push_back(axes[a].at(std::ldexp(static_cast<double>(sequence() ^ shift[a]), -53)));
    }
  }
  return points;
}

}  // namespace harmos::design
