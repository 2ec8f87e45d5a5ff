#pragma once

namespace harmos::probability {

/// Phi(z), the probability that a standard normal number does not exceed z, to full relative accuracy for z < 0; the
/// complement is normalCumulative(-z).
double normalCumulative(double z);

/// Phi^-1(u) to full relative accuracy for u < 1/2; the number that is exceeded with the probability v is
/// -normalQuantile(v). Throws base::Error unless 0 < u < 1.
double normalQuantile(double u);

}  // namespace harmos::probability
