#pragma once

#include <string>
#include <vector>

#include <harmos/input/InputTree.hpp>
#include <harmos/scene/Scene.hpp>

namespace harmos::study {

/// What a new value of a parameter makes invalid, from nothing to everything; each includes those before it.
enum class StudyPhase {
  nothing,     // no entry of the scene
  localStage,  // interface laws: all operators stay
  loads,       // prescribed tractions: new right-hand sides, all operators stay
  operators    // materials, meshes, parts: bodies are assembled and factored anew
};

/// In words, for users.
const char* phaseName(StudyPhase phase);

/// Where an entry of the scene takes effect: itself, or for an entry of Values all that name it by "$name".
std::vector<std::string> effectsOf(const std::string& entry, const input::InputTree& scene);

/// The phase of an entry outside of Values, by its path "List/Sublist/Name".
StudyPhase phaseOf(const std::string& entry, const scene::Scene& scene);

}  // namespace harmos::study
