#pragma once

#include <memory>
#include <string>
#include <vector>

#include <harmos/base/Vector3.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/laws/SpatialField.hpp>

namespace harmos::laws {

/// The name of a field in the parameters of a law.
struct FieldName {
  std::string entry;  ///< that holds it
  std::string name;   ///< an entry of the list Fields of the scene
};
/// The entry that names the field which multiplies a number of a law.
std::string fieldEntryOf(const std::string& number);

/// The fields that a law follows: those that entries "<number> Field" name, which multiply a number, and those of the
/// entry "Fields", a list of texts, which the law reads itself.
std::vector<FieldName> fieldNames(const input::Parameters& law);

/// What an InterfaceLaw is besides that follows fields (SpatialField). Before it is asked for a traction it is told
/// what the lists of the fields hold, bound to them and prepared for all places, by whoever puts it on an interface.
class FieldFollower {
 public:
  virtual ~FieldFollower() = default;
  /// Tells what the lists of fields hold now, see SpatialField::with(); for the next bind().
  virtual void tell(std::vector<input::Parameters> lists) = 0;
  /// Gives the fields of the scene; shared. Must come before any place is asked for. Throws base::Error (input) where
  /// it cannot follow one of them.
  virtual void bind(std::shared_ptr<const SpatialFields> fields) const = 0;
  /// Those of bind(); null: none.
  virtual std::shared_ptr<const SpatialFields> fields() const = 0;
  /// Makes ready for places [length]. Throws base::Error (input) with entry and place where a field is not known, or
  /// what it makes is not allowed.
  virtual void prepare(const std::vector<base::Vector3>& places) const = 0;
  /// The places at which it has been asked so far, or for which it was prepared.
  virtual std::vector<base::Vector3> places() const = 0;
};

/// The fields that a law is bound to. Not for use by several threads, but what it finds is.
class FollowedFields {
 public:
  /// See FieldFollower::tell().
  void tell(std::vector<input::Parameters> lists) { lists_ = std::move(lists); }
  /// Takes the fields of these names with what their lists hold now; those that are not there are left out.
  void bind(std::shared_ptr<const SpatialFields> fields, const std::vector<std::string>& names);
  /// Those of bind(); null: none.
  const std::shared_ptr<const SpatialFields>& shared() const { return shared_; }
  /// The field of this name, valid until the next bind(). Throws base::Error (input) where there is none; `where` is
  /// the entry that names it.
  const SpatialField& find(const std::string& name, const std::string& where) const;

 private:
  std::vector<input::Parameters> lists_;
  std::shared_ptr<const SpatialFields> shared_;
  SpatialFields own_;  // those that are followed, with what the lists hold
};

}  // namespace harmos::laws
