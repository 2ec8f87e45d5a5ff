#pragma once

#include <type_traits>
#include <utility>

#include <harmos/laws/InterfaceLaw.hpp>

namespace harmos::laws {

/// Turns a small struct into an InterfaceLaw; the loop over the nodes is compiled around its inlined solve().
///
/// The struct L gives
///   static constexpr const char* name;                    as written in XML
///   static constexpr int historySize;                     numbers kept per node between load steps
///   static constexpr Sides sides;                         two bodies, one body and the ground, or any
///   static void describe(input::ParameterSpec&);           its parameters (only for laws built from XML)
///   explicit L(const input::Parameters&);                  copies constants (only for laws built from XML)
///   LocalState solve(const LocalLine&, const NodeContext&, const double* old, double* now) const;
/// and may give
///   static constexpr Frame frame = Frame::global;         default Frame::interface
///   static constexpr bool prescribesTraction = true;      default false
///   static constexpr bool dissipates = true;              default false
///   static constexpr bool bonds = true;                   default false
///   static constexpr bool isAffine = true;                default false
///   static constexpr Creases creases = Creases::refuse;   default as InterfaceLaw::creases()
///   double keptWork(const PairStep&) const;               default 0
///   double storedEnergy(const base::Vector3& jump, const base::Vector3& traction) const;  default 0
///   AdmissibleTractions admissibleTractions(int step) const;  default: not known
/// What they mean is said at the functions of InterfaceLaw of these names. `old` and `now` are the pair's numbers at
/// the end of the previous load step and of this one; solve() writes all of `now`.
template <class L>
class PointwiseLaw final : public InterfaceLaw {
 public:
  /// Makes the struct of these arguments, and owns it. Throws what its constructor throws.
  template <class... Arguments>
  explicit PointwiseLaw(Arguments&&... arguments) : law_(std::forward<Arguments>(arguments)...) {}

  /// L::name.
  const char* name() const override { return L::name; }
  /// L::historySize.
  int historySize() const override { return L::historySize; }
  /// L::sides.
  Sides sides() const override { return L::sides; }
  /// L::frame, or the frame of the interface.
  Frame frame() const override { return frameOf<L>(0); }
  /// L::prescribesTraction, or false.
  bool prescribesTraction() const override { return prescribesTractionOf<L>(0); }
  /// L::dissipates, or false.
  bool dissipates() const override { return dissipatesOf<L>(0); }
  /// L::keptWork(), or 0.
  double keptWork(const PairStep& step) const override { return keptWorkOf(law_, step, 0); }
  /// L::storedEnergy(), or 0.
  double storedEnergy(const base::Vector3& jump, const base::Vector3& traction) const override {
    return storedEnergyOf(law_, jump, traction, 0);
  }
  /// L::bonds, or false.
  bool bonds() const override { return bondsOf<L>(0); }
  /// L::isAffine, or false.
  bool isAffine() const override { return isAffineOf<L>(0); }

  /// L::creases, or what follows from the frame and from bonds().
  Creases creases() const override { return creasesOf<L>(0); }
  /// L::admissibleTractions(), or nothing.
  std::optional<AdmissibleTractions> admissibleTractions(int step) const override {
    return admissibleTractionsOf(law_, step, 0);
  }

  /// Calls L::solve() for one pair after the other.
  void solve(int step, const NodeArrays& nodes) const override {
    for (int i = 0; i < nodes.count; ++i) {
      const NodeContext at{step, nodes.gap[i], nodes.position == nullptr ? base::Vector3{} : nodes.position[i]};
      nodes.state[i] =
          law_.solve(nodes.line[i], at, nodes.oldHistory + i * L::historySize, nodes.newHistory + i * L::historySize);
    }
  }

 private:
  // An absent trait falls to the overload that takes long.
  template <class T>
  static constexpr auto frameOf(int) -> decltype(T::frame) {
    return T::frame;
  }
  template <class T>
  static constexpr Frame frameOf(long) {
    return Frame::interface;
  }
  template <class T>
  static constexpr auto prescribesTractionOf(int) -> decltype(T::prescribesTraction) {
    return T::prescribesTraction;
  }
  template <class T>
  static constexpr bool prescribesTractionOf(long) {
    return false;
  }
  template <class T>
  static constexpr auto dissipatesOf(int) -> decltype(T::dissipates) {
    return T::dissipates;
  }
  template <class T>
  static constexpr bool dissipatesOf(long) {
    return false;
  }
  template <class T>
  static auto keptWorkOf(const T& law, const PairStep& step, int) -> decltype(law.keptWork(step)) {
    return law.keptWork(step);
  }
  template <class T>
  static double keptWorkOf(const T&, const PairStep&, long) {
    return 0.0;
  }
  template <class T>
  static auto storedEnergyOf(const T& law, const base::Vector3& jump, const base::Vector3& traction, int)
      -> decltype(law.storedEnergy(jump, traction)) {
    return law.storedEnergy(jump, traction);
  }
  template <class T>
  static double storedEnergyOf(const T&, const base::Vector3&, const base::Vector3&, long) {
    return 0.0;
  }
  template <class T>
  static constexpr auto bondsOf(int) -> decltype(T::bonds) {
    return T::bonds;
  }
  template <class T>
  static constexpr bool bondsOf(long) {
    return false;
  }
  template <class T>
  static constexpr auto isAffineOf(int) -> decltype(T::isAffine) {
    return T::isAffine;
  }
  template <class T>
  static constexpr bool isAffineOf(long) {
    return false;
  }
  template <class T>
  auto creasesOf(int) const -> decltype(T::creases) {
    return T::creases;
  }
  template <class T>
  Creases creasesOf(long) const {
    return InterfaceLaw::creases();
  }
  template <class T>
  static auto admissibleTractionsOf(const T& law, int step, int)
      -> decltype(std::optional<AdmissibleTractions>(law.admissibleTractions(step))) {
    return law.admissibleTractions(step);
  }
  template <class T>
  static std::optional<AdmissibleTractions> admissibleTractionsOf(const T&, int, long) {
    return std::nullopt;
  }

  L law_;
};

}  // namespace harmos::laws
