// A bolt between the mean motions of two faces, which stay free to deform: one traction on all points, along the
// normal. A law over all points of an interface, whatever pieces it is cut into.
#pragma once

#include <harmos/laws/CoupledLaw.hpp>

#include "Harmos.hpp"

class MeanBolt final : public CoupledLaw {
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
  bool dissipates() const override { return false; }

  int sums() const override { return 3; }  // of area, area times free jump, area times compliance
  void addToSums(int, const NodeArrays& nodes, double* sums) const override {
    for (int i = 0; i < nodes.count; ++i) {
      sums[0] += nodes.area[i];
      sums[1] += nodes.area[i] * nodes.line[i].freeJump[0];
      sums[2] += nodes.area[i] * nodes.line[i].compliance;
    }
  }
  void solvePoints(int step, const NodeArrays& nodes, const double* sums) const override {
    pull(preload_[step], nodes, sums);
  }
  void solveTangent(int, const NodeArrays& nodes, const double* sums) const override { pull(0.0, nodes, sums); }

 private:
  /// T = (P + k <delta_free>) / (1 + k <H>), with means over the face.
  void pull(double preload, const NodeArrays& nodes, const double* sums) const {
    const double tension = (preload * sums[0] + stiffness_ * sums[1]) / (sums[0] + stiffness_ * sums[2]);
    for (int i = 0; i < nodes.count; ++i) nodes.state[i] = {{tension, 0.0, 0.0}, Status::bonded};
  }

  double stiffness_;
  input::Schedule preload_;
};
