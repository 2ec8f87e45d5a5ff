#include <harmos/assembly/Interface.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/laws/LawFailure.hpp>

namespace harmos::assembly {

laws::NodeArrays Interface::nodes(const std::vector<double>& times, int step) const {
  laws::NodeArrays nodes;
  nodes.count = pairs();
  nodes.gap = gap.data();
  nodes.position = position.data();
  nodes.frame = frame.data();
  nodes.area = area.data();
  nodes.time = times[step];
  int before = step - 1;
  while (before >= 0 && times[before] == nodes.time) --before;
  nodes.duration = before < 0 ? nodes.time : nodes.time - times[before];
  return nodes;
}

void Interface::solve(int step, const laws::NodeArrays& at) const {
  try {
    law->solve(step, at);
  } catch (const laws::LawFailure& error) {
    throw base::Error("interface \"" + name + "\", load step " + std::to_string(step + 1) + ": law \"" + law->name() +
                          "\" " + error.what(),
                      error.code());
  }
}

}  // namespace harmos::assembly
