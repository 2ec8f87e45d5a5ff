#pragma once

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include <harmos/design/Plan.hpp>
#include <harmos/input/ErrorList.hpp>
#include <harmos/input/InputTree.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/input/References.hpp>
#include <harmos/probability/Distribution.hpp>
#include <harmos/scene/Scene.hpp>
#include <harmos/study/Effect.hpp>

namespace harmos::study {

/// A parameter of a study and what it does to the scene.
struct StudyParameter {
  std::string name;                                               // heads a column of the results
  std::string unit;                                               // for tables and pictures; may be empty
  std::string formula;                                            // of a derived parameter, else empty
  std::string where;                                              // it stands, for messages
  std::vector<std::string> entries;                               // of the scene that it sets, "List/Sublist/Name"
  std::vector<Effect> effects;                                    // where these entries are used
  Effect::Kind effect = Effect::Kind::nothing;                    // the strongest of them
  bool isRandom = false;                                          // has a Distribution
  std::string sampleFile;                                         // that the distribution is read from, else empty
  std::shared_ptr<const probability::Distribution> distribution;  // of a random parameter; null when it has errors
};

/// Reports to `errors` a name that cannot head a column of the results or stand in formulas.
void checkStudyName(const input::Parameters& list, input::ErrorList& errors);

/// Reads the parameters of a study one after the other and holds them against its scene.
class StudyParameterReader {
 public:
  /// `scene` is made of `tree`; null when it has errors, then entries are not checked. `directory`: of the study's
  /// file. `isListed`: values come from a table, so that a parameter needs none. All must outlive the reader.
  StudyParameterReader(const input::InputTree& tree, const scene::Scene* scene, const input::ParameterSpec& sceneSpec,
                       std::string directory, bool isListed, input::ErrorList& errors)
      : tree_(tree),
        references_(tree),
        scene_(scene),
        spec_(sceneSpec),
        directory_(std::move(directory)),
        isListed_(isListed),
        errors_(errors) {}

  /// Adds the parameter that `list`, an entry of Parameters, describes. Its errors are reported.
  void read(const input::Parameters& list);
  /// Those read so far, in their order, also those with errors.
  const std::vector<StudyParameter>& parameters() const { return parameters_; }
  /// The same parameters as a design sees them.
  const std::vector<design::PlannedParameter>& planned() const { return planned_; }

 private:
  void readEntries(const input::Parameters& list, StudyParameter& parameter);
  /// Refuses an entry that another parameter sets, perhaps by the name of a value; whether none does.
  bool demandOneSetter(const std::string& entry, const std::string& parameter, const std::string& where);
  void readLevels(const input::Parameters& list, design::Axis& axis);

  const input::InputTree& tree_;
  input::References references_;
  const scene::Scene* scene_;
  const input::ParameterSpec& spec_;
  std::string directory_;
  bool isListed_;
  input::ErrorList& errors_;
  std::unordered_map<std::string, std::string> setters_;  // the first parameter that sets an entry of the scene
  std::vector<StudyParameter> parameters_;
  std::vector<design::PlannedParameter> planned_;
};

/// Whether any of them changes the law of an interface or boundary.
bool changeLawOf(const std::vector<StudyParameter>& parameters, const std::string& interface);

}  // namespace harmos::study
