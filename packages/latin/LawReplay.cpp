#include <harmos/latin/detail/LawReplay.hpp>

#include <utility>

namespace harmos::latin {

LawReplay::LawReplay(const assembly::Assembly& assembly, int interfaceIndex, std::vector<int> pairs)
    : assembly_(assembly),
      interface_(assembly.interfaces[interfaceIndex]),
      pairs_(std::move(pairs)),
      history_(pairs_.size() * static_cast<std::size_t>(interface_.law->historySize()), 0.0) {
  for (const int p : pairs_) {
    gaps_.push_back(interface_.gap[p]);
    areas_.push_back(interface_.area[p]);
    positions_.push_back(interface_.position[p]);
    frames_.push_back(interface_.frame[p]);
  }
}

base::Vector3 LawReplay::toLaw(std::size_t i, const base::Vector3& v) const {
  return interface_.law->frame() == laws::Frame::interface ? base::toFrame(frames_[i], v) : v;
}

std::vector<laws::LocalState> LawReplay::solve(int step, const std::vector<laws::LocalLine>& lines,
                                               std::vector<double>& history) const {
  std::vector<laws::LocalState> states(lines.size());
  history.resize(history_.size());
  laws::NodeArrays nodes = interface_.nodes(assembly_.times, step);
  nodes.count = static_cast<int>(lines.size());
  nodes.line = lines.data();
  nodes.gap = gaps_.data();
  nodes.oldHistory = history_.data();
  nodes.newHistory = history.data();
  nodes.state = states.data();
  nodes.position = positions_.data();
  nodes.frame = frames_.data();
  nodes.area = areas_.data();
  nodes.number = pairs_.data();
  interface_.solve(step, nodes);
  return states;
}

std::vector<laws::LocalState> LawReplay::ask(int step, const std::vector<laws::LocalLine>& lines) const {
  std::vector<double> history;
  return solve(step, lines, history);
}

void LawReplay::advance(int step, const std::vector<laws::LocalLine>& lines) {
  if (history_.empty()) return;
  std::vector<double> history;
  solve(step, lines, history);
  history_.swap(history);
}

}  // namespace harmos::latin
