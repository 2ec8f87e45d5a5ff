#pragma once

#include <harmos/latin/Response.hpp>

namespace harmos::latin {

/// Mean overlap of the two sides of interfaces along the normal [length]: - sum of h delta_n / sum of h.
///
/// At a cut through a bolt it is what tightening has drawn together: the elongation of the bolt and the shortening of
/// the parts that it clamps.
class OverlapResponse : public PairResponse {
 public:
  /// `interfaces`: positions in the assembly, of one name.
  OverlapResponse(std::string name, std::vector<int> interfaces)
      : PairResponse(std::move(name), Quantity::displacement, std::move(interfaces)) {}
  void include(const assembly::Interface& interface, const PairFields& fields,
               std::vector<double>& values) const override;
  std::vector<double> finish(std::vector<double> values) const override;

 protected:
  int width() const override { return 2; }
};

}  // namespace harmos::latin
