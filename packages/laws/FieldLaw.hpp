#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

#include <harmos/input/ErrorList.hpp>
#include <harmos/input/Field.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/laws/FieldFollower.hpp>
#include <harmos/laws/InterfaceLaw.hpp>

namespace harmos::laws {

/// A law of which some numbers vary over the surface: at every place the law that has the numbers of this place.
///
/// A number that varies is its value times its history times its formula (input::Field) times the field that it names
/// (SpatialField); of a list every number is multiplied so. What the law is besides, see roleOf(), varies nowhere. The
/// laws are made where they are first asked for, or by prepare(); places with equal numbers share one. It costs a
/// look-up per pair, and laws without fields nothing.
class FieldLaw final : public InterfaceLaw, public FieldFollower {
 public:
  /// Makes a law of checked parameters, see input::Registry.
  using Factory = std::function<std::unique_ptr<InterfaceLaw>(const input::Parameters&)>;
  /// Reports what parameters must not be beside each other, see input::Registry; may be empty.
  using Check = std::function<void(const input::Parameters&, input::ErrorList&)>;

  /// Declares "<name> Formula" and "<name> Field" for every entry of a law that varies overSurface().
  static void describe(input::ParameterSpec& law);
  /// Whether a formula or a field is given for any entry.
  static bool isAskedFor(const input::Parameters& parameters);
  /// Reports formulas and fields of entries that are not given. `law`: what describe() has been applied to.
  static void check(const input::ParameterSpec& law, const input::Parameters& parameters, input::ErrorList& errors);

  /// `declared`: what describe() has been applied to. Throws what `make` throws, and base::Error (input) for formulas
  /// that are none, and for those that look at the time where the number may not.
  FieldLaw(const input::ParameterSpec& declared, const input::Parameters& parameters, Factory make, Check check);

  void tell(std::vector<input::Parameters> lists) override { fields_.tell(std::move(lists)); }
  /// Throws base::Error (input) where a number that does not vary over the load steps names a field that does.
  void bind(std::shared_ptr<const SpatialFields> fields) const override;
  std::shared_ptr<const SpatialFields> fields() const override;
  /// Makes the laws of all these places [length]. Throws base::Error (input) with entry and place where a number leaves
  /// its range, a formula has no value, or numbers do not go together.
  void prepare(const std::vector<base::Vector3>& places) const override;
  std::vector<base::Vector3> places() const override;

  /// The law with the numbers as they are written, without formulas and fields.
  const InterfaceLaw& plain() const { return *law_; }
  /// Those that follow are the law's with the numbers as they are written, or what all laws have in common.
  const char* name() const override { return law_->name(); }
  int historySize() const override { return law_->historySize(); }
  Frame frame() const override { return law_->frame(); }
  Sides sides() const override { return law_->sides(); }
  bool prescribesTraction() const override { return law_->prescribesTraction(); }
  bool dissipates() const override { return law_->dissipates(); }
  double keptWork(const PairStep& step) const override { return at(step.at.position()).keptWork(step); }
  double storedEnergy(const PairStep& step) const override { return at(step.at.position()).storedEnergy(step); }
  std::vector<OutputField> outputs() const override { return law_->outputs(); }
  void output(const PairStep& step, double* values) const override { at(step.at.position()).output(step, values); }
  bool bonds() const override { return law_->bonds(); }
  /// Of laws whose slopes are not the same everywhere only those are that have none.
  bool isAffine() const override { return law_->isAffine() && prescribesTraction(); }
  double lowestSlope() const override;
  bool isSmooth() const override { return law_->isSmooth(); }
  Creases creases() const override { return law_->creases(); }
  /// Nothing where more than friction differs from place to place; then with the largest.
  std::optional<AdmissibleTractions> admissibleTractions(int step) const override;
  std::optional<double> shearLimit(const NodeContext& at, const base::Vector3& traction) const override {
    return this->at(at.position()).shearLimit(at, traction);
  }
  void solve(int step, const NodeArrays& nodes) const override;

 private:
  /// A number that varies, or a list.
  struct Entry {
    std::shared_ptr<const input::ParameterEntry> declaration;
    input::Field field;   // of a list its factor
    std::string spatial;  // name of the field, may be empty
    bool isList() const { return declaration->type == input::ParameterType::numbers; }
  };

  struct PlaceHash {
    std::size_t operator()(const base::Vector3& place) const;
  };

  double valueOf(const Entry& entry, int step, const base::Vector3& place) const;
  void demandRange(const Entry& entry, double value, const base::Vector3& place) const;
  const SpatialField& spatialOf(const Entry& entry) const;
  const InterfaceLaw& at(const base::Vector3& place) const;
  const InterfaceLaw& lawAt(const base::Vector3& place) const;  // mutex_ is locked
  input::Parameters with(const std::vector<std::vector<double>>& values) const;
  void demandTogether(const input::Parameters& here, const base::Vector3& place) const;
  std::vector<const InterfaceLaw*> all() const;

  input::Parameters parameters_;
  Factory make_;
  Check check_;
  std::shared_ptr<const InterfaceLaw> law_;
  std::vector<Entry> entries_;
  int steps_ = 1;  // load steps for which histories and times are known
  mutable FollowedFields fields_;
  mutable std::mutex mutex_;
  mutable std::unordered_map<base::Vector3, const InterfaceLaw*, PlaceHash> byPlace_;
  mutable std::map<std::vector<std::vector<double>>, std::unique_ptr<const InterfaceLaw>> byValues_;
};

/// What a law is besides, such as a TurnedLaw, whatever of its numbers varies over the surface; null: it is none.
template <class Role>
const Role* roleOf(const InterfaceLaw& law) {
  const auto* field = dynamic_cast<const FieldLaw*>(&law);
  return dynamic_cast<const Role*>(field == nullptr ? &law : &field->plain());
}

}  // namespace harmos::laws
