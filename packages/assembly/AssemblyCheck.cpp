#include <harmos/assembly/AssemblyCheck.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/assembly/PathCheck.hpp>
#include <harmos/assembly/detail/BodyCheck.hpp>
#include <harmos/assembly/detail/InterfaceCheck.hpp>
#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/base/Numerals.hpp>

namespace harmos::assembly {
namespace {

/// A number that differs, but for chance, when anything differs that all ranks must have alike (FNV-1a).
class Fingerprint {
 public:
  explicit Fingerprint(const Assembly& assembly) {
    add(assembly.dimension);
    for (const double time : assembly.times) add(time);
    for (const int rank : assembly.owner) add(rank);
    for (const auto& body : assembly.bodies) {
      add(body.dimension);
      add(static_cast<int>(body.nodes.size()));
      for (const base::Vector3& x : body.nodes) addAll(x.data(), x.size());
    }
    for (const Interface& interface : assembly.interfaces) {
      add(interface.body1);
      add(interface.body2);
      for (int side = 0; side < 2; ++side) addTrace(interface.trace(side));
      for (const base::Frame& frame : interface.frame) {
        for (const base::Vector3& row : frame) addAll(row.data(), row.size());
      }
      addAll(interface.area.data(), interface.area.size());
      addAll(interface.gap.data(), interface.gap.size());
    }
  }

  /// Half of its bits: a double holds them.
  double value() const { return static_cast<double>(state_ >> 32U); }

 private:
  template <class T>
  void add(T value) {
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    for (const unsigned char byte : bytes) state_ = (state_ ^ byte) * 1099511628211U;
  }
  void addAll(const double* values, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) add(values[i]);
  }
  void addTrace(const mesh::TraceOperator& trace) {
    add(trace.points());
    for (int p = 0; p < trace.points(); ++p) {
      for (const auto& [node, weight] : trace.row(p)) {
        add(node);
        add(weight);
      }
    }
  }

  std::uint64_t state_ = 14695981039346656037U;
};

/// Throws on every rank when one has faults, with those of the lowest such rank.
void throwIfAny(const Faults& faults, const Teuchos::Comm<int>& comm) {
  const int none = comm.getSize();
  const int mine = faults.count() > 0 ? comm.getRank() : none;
  int first = none;
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MIN, mine, Teuchos::outArg(first));
  if (first == none) return;
  std::string text = faults.text();
  int length = static_cast<int>(text.size());
  Teuchos::broadcast(comm, first, Teuchos::outArg(length));
  text.resize(static_cast<std::size_t>(length));
  Teuchos::broadcast(comm, first, length, text.data());
  throw base::Error("The assembly cannot be solved:" + text, base::ExitCode::input);
}

void checkTimes(const Assembly& assembly, Faults& faults) {
  if (assembly.times.empty()) faults.add("times", "there is no load step");
  double before = 0.0;
  for (std::size_t t = 0; t < assembly.times.size(); ++t) {
    const double time = assembly.times[t];
    if (!std::isfinite(time) || !(time > before)) {
      faults.add("times", "load step " + std::to_string(t) + " ends at " + base::toText(time) +
                              "; times are finite, above 0 and ascending");
      return;
    }
    before = time;
  }
}

void checkOwners(const Assembly& assembly, int ranks, Faults& faults) {
  if (!assembly.owner.empty() && assembly.owner.size() != assembly.bodies.size()) {
    faults.add("owner", "it has " + std::to_string(assembly.owner.size()) + " entries, but there are " +
                            std::to_string(assembly.bodies.size()) + " bodies");
    return;
  }
  for (std::size_t b = 0; b < assembly.owner.size(); ++b) {
    if (assembly.owner[b] >= 0 && assembly.owner[b] < ranks) continue;
    faults.add("owner", "rank " + std::to_string(assembly.owner[b]) + " owns body " + std::to_string(b) +
                            ", but the communicator has " + std::to_string(ranks) + " ranks, counted from 0");
  }
}

/// Results and messages name bodies.
void checkNames(const Assembly& assembly, Faults& faults) {
  std::map<std::string, std::size_t> first;
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b) {
    const auto [before, isNew] = first.emplace(assembly.bodies[b].name, b);
    if (isNew) continue;
    faults.add("body " + std::to_string(b) + " " + base::quoted(assembly.bodies[b].name),
               "body " + std::to_string(before->second) + " has the same name");
  }
}

void checkPath(const Assembly& assembly, Faults& faults) {
  const PathControl& path = *assembly.path;
  const int interfaces = static_cast<int>(assembly.interfaces.size());
  if (path.loads.empty()) faults.add("path", "it has no loads");
  if (path.shares.empty()) faults.add("path", "it controls nothing");
  if (path.values.size() != assembly.times.size()) {
    faults.add("path", "it has " + std::to_string(path.values.size()) + " values, but there are " +
                           std::to_string(assembly.times.size()) + " load steps");
  }
  for (const int load : path.loads) {
    const std::string fault =
        load < 0 || load >= interfaces ? "there is no interface " + std::to_string(load) : faultOfLoad(assembly, load);
    if (!fault.empty()) faults.add("path, load " + std::to_string(load), fault);
  }
  for (const PathControl::Share& share : path.shares) {
    const std::string where = "path, share of interface " + std::to_string(share.interface);
    if (share.interface < 0 || share.interface >= interfaces) {
      faults.add(where, "there is no such interface");
    } else if (assembly.interfaces[share.interface].sides() != 2) {
      faults.add(where, "it has no jump, because it has one side");
    } else if (static_cast<int>(share.weight.size()) != assembly.interfaces[share.interface].pairs()) {
      faults.add(where, "it has " + std::to_string(share.weight.size()) + " weights, but the interface has " +
                            std::to_string(assembly.interfaces[share.interface].pairs()) + " pairs");
    }
  }
}

}  // namespace

const Assembly& demandValid(const Assembly& assembly, const Teuchos::Comm<int>& comm) {
  Faults faults;
  if (assembly.dimension != 2 && assembly.dimension != 3) {
    faults.add("dimension", "it is " + std::to_string(assembly.dimension) + ", not 2 or 3");
  }
  if (assembly.bodies.empty()) faults.add("bodies", "there are none");
  checkTimes(assembly, faults);
  checkOwners(assembly, comm.getSize(), faults);
  checkNames(assembly, faults);
  const int bodies = static_cast<int>(assembly.bodies.size());
  for (int b = 0; b < bodies; ++b) checkBody(assembly, b, faults);
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    checkInterface(assembly, static_cast<int>(i), faults);
  }
  if (assembly.path && faults.count() == 0) checkPath(assembly, faults);
  throwIfAny(faults, comm);

  const double mine = Fingerprint(assembly).value();
  double lowest = mine, highest = mine;
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MIN, mine, Teuchos::outArg(lowest));
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MAX, mine, Teuchos::outArg(highest));
  if (lowest != highest) {
    faults.add("ranks", "they were given different assemblies: times, owners, nodes and interfaces must be alike");
  }
  for (int b = 0; b < bodies; ++b) {
    if (assembly.ownerOf(b) == comm.getRank()) checkOwnedBody(assembly, b, faults);
  }
  throwIfAny(faults, comm);
  return assembly;
}

}  // namespace harmos::assembly
