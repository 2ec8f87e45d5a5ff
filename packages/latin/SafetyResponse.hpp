#pragma once

#include <harmos/latin/Response.hpp>

namespace harmos::latin {

/// Least safety of interfaces against slip or gaping [-]: at their worst point, or of all of them as one.
class SafetyResponse : public PairResponse {
 public:
  /// What is to be avoided.
  enum class Against { slip, gaping };
  /// The worst pair that counts (Safety), or the sums of all (ContactSums).
  enum class Where { point, whole };
  /// `interfaces`: positions in the assembly; those that cannot slip or gape say nothing.
  SafetyResponse(std::string name, std::vector<int> interfaces, Against against, Where where)
      : PairResponse(std::move(name), Quantity::ratio, std::move(interfaces)), against_(against), where_(where) {}
  void include(const assembly::Interface& interface, const PairFields& fields,
               std::vector<double>& values) const override;
  std::vector<double> finish(std::vector<double> values) const override;

 protected:
  int width() const override { return where_ == Where::point ? 1 : 3; }
  double start() const override;

 private:
  Against against_;
  Where where_;
};

}  // namespace harmos::latin
