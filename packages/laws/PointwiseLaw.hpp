#pragma once

#include <type_traits>
#include <utility>
#include <vector>

#include <harmos/laws/InterfaceLaw.hpp>

namespace harmos::laws {

/// Turns a small struct into an InterfaceLaw; the loop over the nodes is compiled around its inlined solve().
///
/// The struct L gives
///   static constexpr const char* name;                    as written in XML
///   static constexpr int historySize;                     numbers kept per node between load steps; or, where they
///   int historySize() const;                              depend on the parameters, a function
///   static constexpr Sides sides;                         two bodies, one body and the ground, or any
///   static void describe(input::ParameterSpec&);           its parameters (only for laws built from XML)
///   explicit L(const input::Parameters&);                  copies constants (only for laws built from XML)
///   LocalState solve(const LocalLine&, const NodeContext&, const double* old, double* now) const;
/// and may give
///   static void check(const input::Parameters&, input::ErrorList&);  what parameters must be beside each other
///   static constexpr Frame frame = Frame::global;         default Frame::interface
///   static constexpr bool prescribesTraction = true;      default false
///   static constexpr bool dissipates = true;              default false
///   static constexpr bool bonds = true;                   default false
///   static constexpr bool isAffine = true;                default false
///   static constexpr Creases creases = Creases::refuse;   default as InterfaceLaw::creases()
///   double keptWork(const PairStep&) const;               default 0
///   double storedEnergy(const PairStep&) const;           default 0
///   static std::vector<OutputField> outputs();            default none; may be a member that is const
///   void output(const PairStep&, double* values) const;   to be given with outputs()
///   double lowestSlope() const;                           default 0: monotone
///   static constexpr bool isSmooth = true;                default isAffine
///   AdmissibleTractions admissibleTractions(int step) const;  default: not known
///   double shearLimit(const NodeContext& at, const base::Vector3& traction) const;  default: of these, if it is known
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
  /// L::historySize, or what it returns.
  int historySize() const override { return historySizeOf(law_, 0); }
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
  double storedEnergy(const PairStep& step) const override { return storedEnergyOf(law_, step, 0); }
  /// L::outputs(), or none.
  std::vector<OutputField> outputs() const override { return outputsOf(law_, 0); }
  /// L::output(), if there is one.
  void output(const PairStep& step, double* values) const override { outputOf(law_, step, values, 0); }
  /// L::lowestSlope(), or 0.
  double lowestSlope() const override { return lowestSlopeOf(law_, 0); }
  /// L::isSmooth, or isAffine().
  bool isSmooth() const override { return isSmoothOf<L>(0); }
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

  /// L::shearLimit(), or what follows from admissibleTractions().
  std::optional<double> shearLimit(const NodeContext& at, const base::Vector3& traction) const override {
    return shearLimitOf(law_, at, traction, 0);
  }

  /// Calls L::solve() for one pair after the other.
  void solve(int step, const NodeArrays& nodes) const override {
    const int size = historySizeOf(law_, 0);
    for (int i = 0; i < nodes.count; ++i) {
      nodes.state[i] = law_.solve(nodes.line[i], NodeContext(step, nodes, i), nodes.oldHistory + i * size,
                                  nodes.newHistory + i * size);
    }
  }

 private:
  // An absent trait falls to the overload that takes long.
  template <class T>
  static auto historySizeOf(const T& law, int) -> decltype(law.historySize()) {
    return law.historySize();
  }
  template <class T>
  static constexpr int historySizeOf(const T&, long) {
    return T::historySize;
  }
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
  static auto storedEnergyOf(const T& law, const PairStep& step, int) -> decltype(law.storedEnergy(step)) {
    return law.storedEnergy(step);
  }
  template <class T>
  static double storedEnergyOf(const T&, const PairStep&, long) {
    return 0.0;
  }
  template <class T>
  static auto outputsOf(const T& law, int) -> decltype(law.outputs()) {
    return law.outputs();
  }
  template <class T>
  static std::vector<OutputField> outputsOf(const T&, long) {
    return {};
  }
  template <class T>
  static auto outputOf(const T& law, const PairStep& step, double* values, int) -> decltype(law.output(step, values)) {
    law.output(step, values);
  }
  template <class T>
  static void outputOf(const T&, const PairStep&, double*, long) {}
  template <class T>
  static auto lowestSlopeOf(const T& law, int) -> decltype(law.lowestSlope()) {
    return law.lowestSlope();
  }
  template <class T>
  static double lowestSlopeOf(const T&, long) {
    return 0.0;
  }
  template <class T>
  static constexpr auto isSmoothOf(int) -> decltype(T::isSmooth) {
    return T::isSmooth;
  }
  template <class T>
  static constexpr bool isSmoothOf(long) {
    return isAffineOf<T>(0);
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

  template <class T>
  auto shearLimitOf(const T& law, const NodeContext& at, const base::Vector3& traction, int) const
      -> decltype(std::optional<double>(law.shearLimit(at, traction))) {
    return law.shearLimit(at, traction);
  }
  template <class T>
  std::optional<double> shearLimitOf(const T&, const NodeContext& at, const base::Vector3& traction, long) const {
    return InterfaceLaw::shearLimit(at, traction);
  }

  L law_;
};

}  // namespace harmos::laws
