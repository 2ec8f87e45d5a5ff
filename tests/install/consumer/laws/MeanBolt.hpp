// A bolt between the mean motions of two faces, which stay free to deform: one traction on all points, along the
// normal. A law of a whole interface, which must not be cut into pieces; it is written without PointwiseLaw.
#pragma once

#include <cassert>

#include "Harmos.hpp"

class MeanBolt final : public InterfaceLaw {
 public:
  static constexpr const char* lawName = "Outside Bolt";

  static void describe(input::ParameterSpec& p) {
    p.summary("A spring with preload between the mean normal motions of two faces.");
    p.number("Stiffness").unit("stress/length").required().atLeast(0.0).doc("Of the shank, per area of the face.");
    p.number("Preload").unit("stress").required().varying().doc("Tension per area of the face at rest.");
  }
  explicit MeanBolt(const input::Parameters& p) : stiffness_(p.number("Stiffness")), preload_(p.schedule("Preload")) {}

  const char* name() const override { return lawName; }
  int historySize() const override { return 0; }
  Frame frame() const override { return Frame::interface; }
  Sides sides() const override { return Sides::two; }
  bool prescribesTraction() const override { return false; }
  bool dissipates() const override { return false; }

  void solve(int step, const NodeArrays& nodes) const override {
    double area = 0.0, jump = 0.0, compliance = 0.0;
    assert(nodes.count == 0 || nodes.area != nullptr);
    for (int i = 0; i < nodes.count; ++i) {
      area += nodes.area[i];
      jump += nodes.area[i] * nodes.line[i].freeJump[0];
      compliance += nodes.area[i] * nodes.line[i].compliance;
    }
    if (nodes.count == 0) return;
    const double tension = (preload_[step] + stiffness_ * jump / area) / (1.0 + stiffness_ * compliance / area);
    for (int i = 0; i < nodes.count; ++i) nodes.state[i] = {{tension, 0.0, 0.0}, Status::bonded};
  }

 private:
  double stiffness_;
  input::Schedule preload_;
};
