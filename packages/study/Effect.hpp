#pragma once

#include <string>
#include <vector>

#include <harmos/input/References.hpp>
#include <harmos/scene/Scene.hpp>

namespace harmos::study {

/// What a new value of one entry of the scene changes.
struct Effect {
  /// What becomes invalid, from nothing to everything; each includes those before it.
  enum class Kind {
    nothing,     // no entry of the scene
    localStage,  // interface laws: all operators stay
    loads,       // prescribed tractions: new right-hand sides, all operators stay
    operators    // materials, meshes, parts: bodies are assembled and factored anew
  };
  /// Where the entry stands: in the law of an interface or boundary, in Histories, Parts, Materials or Steps,
  /// elsewhere.
  enum class Target { law, history, part, material, step, other };

  Kind kind = Kind::nothing;      // what must be made anew
  Target target = Target::other;  // what the entry belongs to
  std::string name;   // of the interface or boundary that has the law, of the history, part, material or step
  std::string entry;  // its path "List/Sublist/Name"

  /// Whether the law of an interface or boundary is another one then. Histories may belong to any.
  bool changesLawOf(const std::string& interface) const {
    return target == Target::history || (target == Target::law && name == interface);
  }
};

/// The kind in words, as files have it.
const char* effectName(Effect::Kind kind);

/// The effect of an entry outside of Values, by its path "List/Sublist/Name", which is not checked.
Effect effectOf(const std::string& entry, const scene::Scene& scene);

/// Of an entry of Values all entries that name it by "$name"; of others none.
std::vector<std::string> entriesThatName(const std::string& entry, const input::References& references);

/// The effects of an entry of the input that `scene` is made of, whose `references` are given: its own, or for an entry
/// of Values those of all entries that name it by "$name"; then none when nothing does.
std::vector<Effect> effectsOf(const std::string& entry, const input::References& references, const scene::Scene& scene);

}  // namespace harmos::study
