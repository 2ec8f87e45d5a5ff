#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

/// Damages the bytes of files as disks, networks, editors and people do. The same seed gives the same damages on every
/// machine.
class Mutator {
 public:
  explicit Mutator(std::uint32_t seed) : random_(seed) {}

  /// `bytes` with one to four damages. `isText`: words and numbers are damaged besides.
  std::string damaged(std::string bytes, bool isText);
  /// A number below `count`, which is not 0.
  std::size_t below(std::size_t count) { return random_() % count; }

 private:
  void damageBytes(std::string& bytes);
  void damageText(std::string& bytes);

  std::mt19937 random_;
};
