#pragma once

#include <array>
#include <type_traits>

#include <Sacado.hpp>

#include <harmos/laws/NewtonOnLine.hpp>
#include <harmos/laws/NoIntersection.hpp>
#include <harmos/laws/PointwiseLaw.hpp>

namespace harmos::laws {

/// The graph of a struct as SmoothLaw describes it, at one pair and load step; refers to what it is made of.
template <class G>
class SmoothGraph {
 public:
  /// The struct, where it is asked, and its history before.
  SmoothGraph(const G& graph, const NodeContext& at, const double* old) : graph_(graph), at_(at), old_(old) {}

  /// The traction at a jump.
  base::Vector3 tractionAt(const base::Vector3& jump) const {
    const std::array<double, 3> t = graph_.template traction<double>(jump, at_, old_);
    return {t[0], t[1], t[2]};
  }
  /// The same with its derivatives.
  GraphPoint pointAt(const base::Vector3& jump) const {
    std::array<Dual, 3> dual;
    for (int c = 0; c < 3; ++c) dual[static_cast<std::size_t>(c)] = Dual(3, c, jump[static_cast<std::size_t>(c)]);
    const std::array<Dual, 3> t = graph_.template traction<Dual>(dual, at_, old_);
    GraphPoint point;
    for (std::size_t c = 0; c < 3; ++c) {
      point.traction[c] = t[c].val();
      for (int d = 0; d < 3; ++d) point.slope[c][static_cast<std::size_t>(d)] = t[c].fastAccessDx(d);
    }
    return point;
  }
  /// G::update(), where there is one.
  void update(const base::Vector3& jump, double* now) const { updateOf(graph_, jump, now, 0); }
  /// G::status(), or bonded.
  Status status(const base::Vector3& jump) const { return statusOf(graph_, jump, 0); }

 private:
  const G& graph_;
  const NodeContext& at_;
  const double* old_;

  using Dual = Sacado::Fad::SFad<double, 3>;

  // An absent member falls to the overload that takes long.
  template <class T>
  auto updateOf(const T& graph, const base::Vector3& jump, double* now, int) const
      -> decltype(graph.update(jump, at_, old_, now)) {
    graph.update(jump, at_, old_, now);
  }
  template <class T>
  void updateOf(const T&, const base::Vector3&, double*, long) const {}
  template <class T>
  auto statusOf(const T& graph, const base::Vector3& jump, int) const -> decltype(graph.status(jump, at_, old_)) {
    return graph.status(jump, at_, old_);
  }
  template <class T>
  Status statusOf(const T&, const base::Vector3&, long) const {
    return Status::bonded;
  }
};

/// Where a smooth graph meets a line. Throws NoIntersection where Newton's method fails.
template <class G>
LocalState onLine(const G& graph, const LocalLine& line, const NodeContext& at, const double* old, double* now) {
  const SmoothGraph<G> here(graph, at, old);
  const auto traction = newtonOnLine(
      line, [&](const base::Vector3& jump) { return here.tractionAt(jump); },
      [&](const base::Vector3& jump) { return here.pointAt(jump); });
  if (!traction) throw NoIntersection(line, at, "Newton's method comes to no end");
  const base::Vector3 jump = line.jump(*traction);
  here.update(jump, now);
  return {*traction, here.status(jump)};
}

/// Makes a law of a struct that gives the traction as a smooth function of jump and history: where its graph meets the
/// line is found by Newton's method, derivatives are automatic (Sacado).
///
/// The struct G gives all that PointwiseLaw asks for but solve(), and instead
/// @code
///   template <class Scalar>
///   std::array<Scalar, 3> traction(const std::array<Scalar, 3>& jump, const NodeContext&, const double* old) const;
/// @endcode
/// written with the functions of the header cmath without "std::" before them; where it has history also
/// @code
///   void update(const base::Vector3& jump, const NodeContext&, const double* old, double* now) const;
/// @endcode
/// which writes all of `now` at the jump that was found. It may give
/// @code
///   Status status(const base::Vector3& jump, const NodeContext&, const double* old) const;  // default: bonded
/// @endcode
/// The traction must have a derivative at every jump that the law may meet, but for the jump 0, as sqrt(x^2 + y^2) has
/// not. SmoothLaw<G> is a struct as PointwiseLaw wants it: addLaw<SmoothLaw<G>>(laws),
/// HARMOS_LAW_PLUGIN(harmos::laws::SmoothLaw<G>).
template <class G>
struct SmoothLaw : G {
  using G::G;
  /// Has a derivative, see InterfaceLaw::isSmooth().
  static constexpr bool isSmooth = true;

  /// Meets a line. Throws NoIntersection where Newton's method fails.
  LocalState solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const {
    return onLine<G>(*this, line, at, old, now);
  }
};

}  // namespace harmos::laws
