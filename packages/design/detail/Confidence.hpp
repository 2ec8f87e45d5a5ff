#pragma once

namespace harmos::design {

/// Share of its predictions that a response surface vouches for, and the deviations of a normal distribution on either
/// side that hold it.
constexpr double confidence = 0.95;
constexpr double confidentDeviations = 1.96;

}  // namespace harmos::design
