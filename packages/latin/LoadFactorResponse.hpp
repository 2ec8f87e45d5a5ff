#pragma once

#include <harmos/latin/Response.hpp>

namespace harmos::latin {

/// The load factor [-] of a PathControl.
class LoadFactorResponse : public Response {
 public:
  /// `name`: for results and messages.
  explicit LoadFactorResponse(std::string name) : Response(std::move(name), Quantity::ratio) {}
  std::vector<double> evaluate(const Iterate& state) const override { return state.loadFactors(); }
  bool isLinear() const override { return false; }
};

}  // namespace harmos::latin
