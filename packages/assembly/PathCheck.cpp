#include <harmos/assembly/PathCheck.hpp>

#include <cmath>

#include <harmos/laws/AffineComponent.hpp>

namespace harmos::assembly {
namespace {

/// What a law answers to lines without a free jump: what it prescribes, or what that takes on a spring.
std::vector<laws::LocalState> answers(const Assembly& assembly, const Interface& interface, int step) {
  laws::LocalLine line;
  line.compliance = 1.0;
  const std::vector<laws::LocalLine> lines(interface.pairs(), line);
  std::vector<laws::LocalState> states(interface.pairs());
  laws::NodeArrays nodes = interface.nodes(assembly.times, step);
  nodes.line = lines.data();
  nodes.state = states.data();
  interface.solve(step, nodes);
  return states;
}

}  // namespace

std::string faultOfLoad(const Assembly& assembly, int index) {
  const Interface& interface = assembly.interfaces[index];
  const laws::InterfaceLaw& law = *interface.law;
  if (interface.sides() != 1) return "it joins two parts and is no load";
  if (!law.prescribesTraction()) {
    if (!law.isAffine()) return "a load factor cannot multiply what its law does";
    for (const laws::AffineComponent& component : laws::affineComponents(law, 0)) {
      if (!std::isinf(component.stiffness) && component.offset != 0.0) {
        return "its law is a spring; a load factor multiplies prescribed tractions and displacements";
      }
    }
  }
  const std::vector<laws::LocalState> first = answers(assembly, interface, 0);
  bool isZero = true;
  for (const laws::LocalState& state : first) isZero = isZero && base::norm(state.traction) == 0.0;
  for (int t = 1; t < assembly.steps(); ++t) {
    const std::vector<laws::LocalState> then = answers(assembly, interface, t);
    for (std::size_t p = 0; p < then.size(); ++p) {
      if (then[p].traction != first[p].traction) return "it varies with time, but its size is what is looked for";
    }
  }
  return isZero ? "all that it prescribes is 0, which a load factor does not change" : "";
}

}  // namespace harmos::assembly
