#pragma once

namespace harmos::scene {

/// Seconds of solves with some right-hand sides at once, which read a factor together: a single one reads it faster
/// than several can be worked on.
struct SolveSeconds {
  double alone = 0.0;    ///< of a single column
  double first = 0.0;    ///< of several: what all of them wait for
  double further = 0.0;  ///< and each of them

  /// Of so many columns, of which solvers are given 64 at once.
  double seconds(double columns) const;
  /// Of both, one after the other.
  SolveSeconds operator+(const SolveSeconds& other) const {
    return {alone + other.alone, first + other.first, further + other.further};
  }
  /// Of so many times as much.
  friend SolveSeconds operator*(double factor, const SolveSeconds& one) {
    return {factor * one.alone, factor * one.first, factor * one.further};
  }
};

}  // namespace harmos::scene
