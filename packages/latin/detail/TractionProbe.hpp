#pragma once

#include <optional>
#include <vector>

#include <harmos/latin/detail/LawReplay.hpp>
#include <harmos/latin/detail/TractionSet.hpp>

namespace harmos::latin {

/// Finds what a law of any kind admits at closed pairs, by asking it.
///
/// A line through a jump with a compliance far below that of the bodies leaves the jump where it is, so that the law
/// gives back the traction that was put on it if it admits that, and otherwise what it has instead. Pairs are pressed
/// by some pressures, and sheared in some directions by more than they bear: where the answers are linear in the
/// pressure, they are those of a cone or a ray, which may begin beside nothing; where they are not, a cone lies inside,
/// up to four times the tractions around. A pair that can be pulled as well may have any normal traction, with the
/// shear that goes with it. What is found is a part of what is admitted, never more, but for round-off of 1e-4.
class TractionProbe {
 public:
  /// A closed pair, in the law's frame.
  struct Pair {
    base::Vector3 traction{};  ///< of the state [stress]
    base::Vector3 jump{};      ///< where it is closed, and sticks unless it slides [length]
    double size = 0.0;         ///< of the tractions around it [stress]; 0: not to be asked
    double compliance = 0.0;   ///< of the bodies [length/stress]
    bool slides = false;       ///< its shear depends on the pressure alone
  };

  /// `replay` must outlive it.
  TractionProbe(const LawReplay& replay, const assembly::Interface& interface, int dimension)
      : replay_(replay), interface_(interface), dimension_(dimension) {}

  /// Of all pairs of the replay, at the load step that follows; none where nothing but the traction of the state is
  /// known to be admitted, and where it was not asked. Not collective.
  std::vector<std::optional<TractionSet>> find(int step, const std::vector<Pair>& pairs) const;

 private:
  using Vectors = std::vector<base::Vector3>;  // a vector for each pair

  /// What the law makes of these tractions, one for each pair.
  Vectors answer(int step, const std::vector<Pair>& pairs, const Vectors& tractions) const;
  /// The least shear that pairs bear under each pressure [stress], by pairs.
  std::vector<std::vector<double>> limits(int step, const std::vector<Pair>& pairs) const;
  /// Whether shears are borne whatever they are, up to a limit, and not by a spring, by pairs.
  std::vector<bool> areStuck(int step, const std::vector<Pair>& pairs) const;

  const LawReplay& replay_;
  const assembly::Interface& interface_;
  int dimension_;
};

}  // namespace harmos::latin
