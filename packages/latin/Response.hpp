#pragma once

#include <optional>
#include <string>
#include <vector>

#include <harmos/latin/PairFields.hpp>

namespace harmos::latin {

/// What a response is measured in; decides below which size its relative error stops to matter.
enum class Quantity { displacement, force, moment, stress, energy, ratio };

/// Derivative of a response at one load step: dJ = sum of weight.du over nodes + sum of h weight.df1 over pairs.
///
/// u [length] in global components, f1 [stress] the traction on side 1, h [area]; the weights are in what makes it the
/// unit of J.
struct ResponseGradient {
  /// A node of a body.
  struct NodeShare {
    int body;              ///< position in the assembly
    int node;              ///< of the body, from 0
    base::Vector3 weight;  ///< dJ/du
  };
  /// A pair of an interface.
  struct PairShare {
    int interface;         ///< position in the assembly
    int pair;              ///< of the interface, from 0
    base::Vector3 weight;  ///< dJ/df1 over h
  };
  std::vector<NodeShare> nodes;  ///< may name a node more than once
  std::vector<PairShare> pairs;  ///< the same
};

/// What the time of an evaluation goes with, at one load step.
struct ResponseWork {
  double nodes = 0.0;      ///< displacements that are read, and tractions of boundaries, which may be reactions
  double pairs = 0.0;      ///< of interfaces between two bodies, that are read
  double recovered = 0.0;  ///< nodes at which stress is recovered from linear elements, or as many as take this time
  double together = 0.0;   ///< the most of these at once

  /// Adds what another response takes; nodes that are recovered at once are those of one response.
  ResponseWork& operator+=(const ResponseWork& other);
};

/// A number per load step that the user asks for, read from the fields of an iteration. Its error is estimated and
/// certified by name.
///
/// It is linear, or a PairResponse; others cannot be random.
class Response {
 public:
  /// `name`: for results and messages.
  Response(std::string name, Quantity quantity) : name_(std::move(name)), quantity_(quantity) {}
  virtual ~Response() = default;
  /// The name that was given.
  const std::string& name() const { return name_; }
  /// What it is measured in.
  Quantity quantity() const { return quantity_; }
  /// The size below which its relative error stops to matter, in its unit; 0: that of its quantity, see NaturalSizes.
  double scale() const { return scale_; }
  /// To be called before the response is given to a solver; at least 0.
  void setScale(double scale) { scale_ = scale; }
  /// One value per load step. Collective: the same values on every rank. All load steps must be selected.
  virtual std::vector<double> evaluate(const Iterate& state) const = 0;
  /// What its evaluation takes; nothing worth counting, where it is not said.
  virtual ResponseWork work(const assembly::Assembly& /*assembly*/) const { return {}; }
  /// Whether it is linear in the fields of the linear stage and in the prescribed tractions.
  virtual bool isLinear() const { return true; }
  /// Its derivative, the same at all load steps; nothing where it is not linear in displacements and tractions.
  virtual std::optional<ResponseGradient> gradient(const assembly::Assembly& /*assembly*/) const {
    return std::nullopt;
  }

  /// A pair with unknowns at a load step, in global components.
  struct At {
    int interface = -1;          ///< position in the assembly
    int pair = -1;               ///< of the interface
    base::Vector3 traction{};    ///< f on side 1 [stress]
    base::Vector3 jumpChange{};  ///< of the jump over the load step [length]
  };
  /// How the value at the load step grows with the traction on side 1 of a pair while all displacements stay [its unit
  /// / stress]; of a value that is not linear a direction in which it grows. 0: it does not depend on it.
  virtual base::Vector3 slope(const assembly::Assembly& /*assembly*/, const At& /*at*/) const { return {}; }
  /// Whether it is a magnitude, which large tractions make large whichever way they point.
  virtual bool isMagnitude() const { return false; }

 private:
  std::string name_;
  Quantity quantity_;
  double scale_ = 0.0;
};

/// Weighted sum of nodal displacements along a direction: sum of weight (u . direction) [length].
///
/// With area weights that add up to 1 it is the mean over a surface, with one node the value at a point.
class DisplacementResponse : public Response {
 public:
  /// A node that is displaced, and what it counts.
  struct Node {
    int body;       ///< position in the assembly
    int node;       ///< of the body, from 0
    double weight;  ///< [-]
  };
  /// `direction`: global components, taken as it is: not made a unit vector.
  DisplacementResponse(std::string name, std::vector<Node> nodes, base::Vector3 direction)
      : Response(std::move(name), Quantity::displacement), nodes_(std::move(nodes)), direction_(direction) {}
  /// As they were given.
  const std::vector<Node>& nodes() const { return nodes_; }
  /// As it was given.
  const base::Vector3& direction() const { return direction_; }
  std::vector<double> evaluate(const Iterate& state) const override;
  ResponseWork work(const assembly::Assembly& assembly) const override;
  std::optional<ResponseGradient> gradient(const assembly::Assembly& assembly) const override;

 private:
  std::vector<Node> nodes_;
  base::Vector3 direction_;
};

/// Resultant of the tractions that an interface exerts on its side 1: sum of h f . direction [force], or with a centre
/// sum of h ((x - centre) x f) . direction [force length]. Without a direction, the component along the normal n: with
/// f1.n > 0 in tension this is the force of a bolt.
class ResultantResponse : public Response {
 public:
  /// `interfaces`: those of one name. `direction`: none, or one in global components; `centre`: none, or one [length].
  ResultantResponse(std::string name, std::vector<int> interfaces, std::vector<base::Vector3> direction,
                    std::vector<base::Vector3> centre = {})
      : Response(std::move(name), centre.empty() ? Quantity::force : Quantity::moment),
        interfaces_(std::move(interfaces)),
        direction_(std::move(direction)),
        centre_(std::move(centre)) {}
  std::vector<double> evaluate(const Iterate& state) const override;
  ResponseWork work(const assembly::Assembly& assembly) const override;
  std::optional<ResponseGradient> gradient(const assembly::Assembly& assembly) const override;
  base::Vector3 slope(const assembly::Assembly& assembly, const At& at) const override;

 private:
  base::Vector3 arm(const assembly::Assembly& assembly, const assembly::Interface& interface, int pair) const;

  std::vector<int> interfaces_;
  std::vector<base::Vector3> direction_;  // none or one
  std::vector<base::Vector3> centre_;     // none or one
};

/// A number that depends on the fields of interfaces, in whatever way.
class PairResponse : public Response {
 public:
  /// `interfaces`: positions in the assembly.
  PairResponse(std::string name, Quantity quantity, std::vector<int> interfaces)
      : Response(std::move(name), quantity), interfaces_(std::move(interfaces)) {}
  std::vector<double> evaluate(const Iterate& state) const final;
  ResponseWork work(const assembly::Assembly& assembly) const final;
  bool isLinear() const final { return false; }
  /// On which the number depends.
  const std::vector<int>& interfaces() const { return interfaces_; }
  /// What is gathered from the interfaces: `width()` numbers per load step, step by step, before the first one.
  std::vector<double> begin(int steps) const;
  /// Includes the share of one interface in `values`.
  virtual void include(const assembly::Interface& interface, const PairFields& fields,
                       std::vector<double>& values) const = 0;
  /// The value at each load step, of all that was included.
  virtual std::vector<double> finish(std::vector<double> values) const { return values; }
  /// Whether the number depends on an interface.
  bool reads(int interface) const;

 protected:
  /// Numbers per load step that include() needs.
  virtual int width() const { return 1; }
  /// What they are before the first interface.
  virtual double start() const { return 0.0; }

 private:
  std::vector<int> interfaces_;
};

/// Energy [force length] lost in interfaces up to each load step: sum over steps and pairs of h times LawFields::lost,
/// the work on the interface less what the law keeps.
class DissipationResponse : public PairResponse {
 public:
  /// `interfaces`: positions in the assembly; those whose laws do not dissipate add nothing.
  DissipationResponse(std::string name, std::vector<int> interfaces)
      : PairResponse(std::move(name), Quantity::energy, std::move(interfaces)) {}
  void include(const assembly::Interface& interface, const PairFields& fields,
               std::vector<double>& values) const override;
  base::Vector3 slope(const assembly::Assembly& assembly, const At& at) const override;
};

/// Largest value over the nodes of an interface, of the local stage's fields (which obey the laws).
class MaximumResponse : public PairResponse {
 public:
  /// -t_n, |t_n| and |t_t| [stress]; delta_n + gap and |delta_t| [length].
  enum class Field { contactPressure, normalTraction, tangentialTraction, opening, slip };
  /// `interfaces`: positions in the assembly. No value is below 0.
  MaximumResponse(std::string name, std::vector<int> interfaces, Field field)
      : PairResponse(std::move(name),
                     field == Field::opening || field == Field::slip ? Quantity::displacement : Quantity::stress,
                     std::move(interfaces)),
        field_(field) {}
  void include(const assembly::Interface& interface, const PairFields& fields,
               std::vector<double>& values) const override;
  base::Vector3 slope(const assembly::Assembly& assembly, const At& at) const override;
  bool isMagnitude() const override { return true; }

 private:
  Field field_;
};

}  // namespace harmos::latin
