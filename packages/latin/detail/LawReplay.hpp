#pragma once

#include <vector>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/laws/LocalLine.hpp>

namespace harmos::latin {

/// The law of an interface, asked again at some of its pairs, load step after load step, with the history that the
/// states of these leave.
class LawReplay {
 public:
  /// `pairs` of an interface of the assembly, which must outlive it; unloaded. Laws over whole faces cannot be asked.
  LawReplay(const assembly::Assembly& assembly, int interfaceIndex, std::vector<int> pairs);

  /// What the law makes of a line for each pair [length, length/stress], in its frame, at a load step counted from 0
  /// that follows on the last advance(). Changes nothing. Not collective.
  std::vector<laws::LocalState> ask(int step, const std::vector<laws::LocalLine>& lines) const;
  /// Goes to the end of a load step, whose states lie on these lines.
  void advance(int step, const std::vector<laws::LocalLine>& lines);

  /// Pairs of the interface.
  const std::vector<int>& pairs() const { return pairs_; }
  /// The components of a global vector in the law's frame, at the i-th of the pairs.
  base::Vector3 toLaw(std::size_t i, const base::Vector3& v) const;

 private:
  std::vector<laws::LocalState> solve(int step, const std::vector<laws::LocalLine>& lines,
                                      std::vector<double>& history) const;

  const assembly::Assembly& assembly_;
  const assembly::Interface& interface_;
  std::vector<int> pairs_;
  std::vector<double> gaps_, areas_;
  std::vector<base::Vector3> positions_;
  std::vector<base::Frame> frames_;
  std::vector<double> history_;
};

}  // namespace harmos::latin
