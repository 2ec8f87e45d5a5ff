#pragma once

#include <memory>
#include <vector>

#include <harmos/laws/InterfaceLaw.hpp>

namespace harmos::stochastic {

/// The law of every interface at every point of a quadrature: [point][interface]. An interface that is not random has
/// the same object at all points.
using Realisations = std::vector<std::vector<std::shared_ptr<const laws::InterfaceLaw>>>;

}  // namespace harmos::stochastic
