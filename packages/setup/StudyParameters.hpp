#pragma once

#include <memory>
#include <string>
#include <vector>

#include <harmos/base/ErrorList.hpp>
#include <harmos/base/InputTree.hpp>
#include <harmos/base/Parameters.hpp>
#include <harmos/chaos/Distribution.hpp>
#include <harmos/setup/Scene.hpp>
#include <harmos/setup/StudyPhase.hpp>
#include <harmos/study/Plan.hpp>

namespace harmos::setup {

/// A parameter of a study and what it does to the scene.
struct StudyParameter {
  std::string name;
  std::string unit;
  std::string formula;               // of a derived parameter, else empty
  std::string where;                 // it stands, for messages
  std::vector<std::string> entries;  // of the scene that it sets, "List/Sublist/Name"
  std::vector<std::string> effects;  // where these entries are used
  StudyPhase phase = StudyPhase::nothing;
  bool isRandom = false;
  std::shared_ptr<const chaos::Distribution> distribution;  // of a random parameter; null when it has errors
};

/// Reports a name that cannot head a column of the results or, of a parameter, stand in formulas.
void checkStudyName(const base::Parameters& list, base::ErrorList& errors);

/// Reads the parameters of a study one after the other and holds them against its scene.
class StudyParameterReader {
 public:
  /// `scene` is made of `tree`; null when it has errors, then entries are not checked. `directory`: of the study's
  /// file. `isListed`: values come from a table, so that a parameter needs none. All must outlive the reader.
  StudyParameterReader(const base::InputTree& tree, const Scene* scene, const base::ParameterSpec& sceneSpec,
                       std::string directory, bool isListed, base::ErrorList& errors)
      : tree_(tree),
        scene_(scene),
        spec_(sceneSpec),
        directory_(std::move(directory)),
        isListed_(isListed),
        errors_(errors) {}

  void read(const base::Parameters& list);
  const std::vector<StudyParameter>& parameters() const { return parameters_; }
  /// The same parameters as a design sees them.
  const std::vector<study::PlannedParameter>& planned() const { return planned_; }

 private:
  void readEntries(const base::Parameters& list, StudyParameter& parameter);
  void readLevels(const base::Parameters& list, study::Axis& axis);

  const base::InputTree& tree_;
  const Scene* scene_;
  const base::ParameterSpec& spec_;
  std::string directory_;
  bool isListed_;
  base::ErrorList& errors_;
  std::vector<StudyParameter> parameters_;
  std::vector<study::PlannedParameter> planned_;
};

}  // namespace harmos::setup
