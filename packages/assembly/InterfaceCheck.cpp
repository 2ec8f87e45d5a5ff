#include <harmos/assembly/detail/InterfaceCheck.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <harmos/base/Numerals.hpp>
#include <harmos/base/UsableNumbers.hpp>

namespace harmos::assembly {
namespace {

// Of sums of weights and products of unit vectors: far above round-off, also that of seven digits in a text file.
constexpr double tolerance = 1e-6;

/// The three rows are unit vectors at right angles, the third one the product of the others.
bool isFrame(const base::Frame& frame) {
  const base::Vector3 third = cross(frame[0], frame[1]);
  return std::abs(norm(frame[0]) - 1.0) <= tolerance && std::abs(norm(frame[1]) - 1.0) <= tolerance &&
         std::abs(dot(frame[0], frame[1])) <= tolerance && distance(third, frame[2]) <= tolerance;
}

class Check {
 public:
  Check(const Assembly& assembly, int index, Faults& faults)
      : assembly_(assembly),
        interface_(assembly.interfaces[index]),
        where_("interface " + std::to_string(index) + " \"" + interface_.name + "\""),
        faults_(faults) {}

  void run() {
    if (!interface_.law) {
      add("it has no law");
      return;
    }
    const int bodies = static_cast<int>(assembly_.bodies.size());
    if (interface_.body1 < 0 || interface_.body1 >= bodies || interface_.body2 < -1 || interface_.body2 >= bodies) {
      add("it joins bodies " + std::to_string(interface_.body1) + " and " + std::to_string(interface_.body2) +
          ", but there are " + std::to_string(bodies) + ", counted from 0; body2 is -1 on a boundary");
      return;
    }
    if (interface_.body1 == interface_.body2) {
      add("it joins body " + std::to_string(interface_.body1) +
          " with itself; a body whose own faces meet is to be divided between them");
      return;
    }
    checkSides();
    checkTrace(0);
    checkTrace(1);
    if (!hasLengths()) return;
    for (int p = 0; p < interface_.pairs(); ++p) {
      if (!checkPair(p)) break;  // the others most likely have the same fault
    }
    checkMass();
  }

 private:
  void add(const std::string& what) { faults_.add(where_, what); }

  void checkSides() {
    const laws::InterfaceLaw& law = *interface_.law;
    // Faces that lie apart from each other are two interfaces, which a law over both takes together.
    if (interface_.sides() == 1 && law.sides() == laws::Sides::two && interface_.face < 0) {
      add("the law \"" + std::string(law.name()) + "\" joins two bodies, but body2 is -1");
    }
    if (interface_.sides() == 2 && law.sides() == laws::Sides::one) {
      add("the law \"" + std::string(law.name()) + "\" acts on one body, but body2 is " +
          std::to_string(interface_.body2));
    }
  }

  void checkTrace(int side) {
    const mesh::TraceOperator& trace = interface_.trace(side);
    const std::string name = side == 0 ? "trace1" : "trace2";
    const int points = side < interface_.sides() ? interface_.pairs() : 0;
    if (trace.points() != points) {
      add(name + " has " + std::to_string(trace.points()) + " points instead of " + std::to_string(points) +
          (side < interface_.sides() ? ", those of trace1" : ": a boundary has one side"));
      return;
    }
    if (points == 0) return;
    const int nodes = static_cast<int>(assembly_.bodies[interface_.body(side)].nodes.size());
    for (int p = 0; p < points; ++p) {
      double sum = 0.0;
      for (const auto& [node, weight] : trace.row(p)) {
        if (node < 0 || node >= nodes) {
          add(name + " names node " + std::to_string(node) + " at pair " + std::to_string(p) + ", but the body has " +
              std::to_string(nodes));
          return;
        }
        sum += weight;
      }
      if (std::abs(sum - 1.0) <= tolerance) continue;
      add("the weights of " + name + " at pair " + std::to_string(p) + " have the sum " + base::toText(sum) +
          " instead of 1");
      return;
    }
  }

  bool hasLengths() {
    const std::pair<const char*, std::size_t> arrays[] = {{"position", interface_.position.size()},
                                                          {"frame", interface_.frame.size()},
                                                          {"area", interface_.area.size()},
                                                          {"gap", interface_.gap.size()}};
    bool fits = true;
    for (const auto& [name, length] : arrays) {
      if (length == static_cast<std::size_t>(interface_.pairs())) continue;
      add(std::string(name) + " has " + std::to_string(length) + " entries instead of " +
          std::to_string(interface_.pairs()) + ", one for each point of trace1");
      fits = false;
    }
    return fits;
  }

  bool checkPair(int p) {
    const std::string pair = " of pair " + std::to_string(p);
    const int before = faults_.count();
    const base::Vector3& x = interface_.position[p];
    if (!base::isUsable(x[0]) || !base::isUsable(x[1]) || !base::isUsable(x[2])) {
      add("the position" + pair + " is not finite, or beyond " + base::toText(base::largestNumber));
    }
    if (!isFrame(interface_.frame[p])) {
      add("the frame" + pair + " is not made of three unit vectors n, t1, t2 at right angles with t2 = n x t1");
    }
    const double area = interface_.area[p];
    if (!base::isUsable(area) || (!(area >= 1.0 / base::largestNumber) && !interface_.law->prescribesTraction())) {
      add("the area" + pair + " is " + base::toText(area) +
          "; areas are positive where the law prescribes no traction, and between " +
          base::toText(1.0 / base::largestNumber) + " and " + base::toText(base::largestNumber));
    }
    if (!base::isUsable(interface_.gap[p])) add("the gap" + pair + " is " + base::toText(interface_.gap[p]));
    return faults_.count() == before;
  }

  void checkMass() {
    std::map<std::pair<int, int>, double> values;
    for (const mesh::MassEntry& entry : interface_.mass) {
      const int largest = interface_.pairs() - 1;
      if (entry.row < 0 || entry.row > largest || entry.column < 0 || entry.column > largest ||
          !base::isUsable(entry.value) || (entry.row == entry.column && entry.value < 0.0)) {
        add("the mass has the entry " + base::toText(entry.value) + " at (" + std::to_string(entry.row) + ", " +
            std::to_string(entry.column) + "); pairs are counted from 0 to " + std::to_string(largest) +
            ", entries are finite and not beyond " + base::toText(base::largestNumber) +
            ", those of the diagonal not negative");
        return;
      }
      values[{entry.row, entry.column}] += entry.value;
    }
    for (const auto& [place, value] : values) {
      const auto other = values.find({place.second, place.first});
      if (other != values.end() && std::abs(other->second - value) <= tolerance * std::abs(value)) continue;
      add("the mass is not symmetric at (" + std::to_string(place.first) + ", " + std::to_string(place.second) +
          "); both triangles must be given");
      return;
    }
  }

  const Assembly& assembly_;
  const Interface& interface_;
  std::string where_;
  Faults& faults_;
};

}  // namespace

void checkInterface(const Assembly& assembly, int index, Faults& faults) {
  Check(assembly, index, faults).run();
}

}  // namespace harmos::assembly
