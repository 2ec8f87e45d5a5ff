#pragma once

#include <map>
#include <string>
#include <vector>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/input/InputTree.hpp>
#include <harmos/latin/ModelParameter.hpp>
#include <harmos/laws/LawRegistry.hpp>
#include <harmos/scene/Scene.hpp>

namespace harmos::scene {

/// Puts the laws of a scene on the interfaces and boundaries of an assembly that was made of it; laws of cuts stay.
/// Shares them. For solvers of the assembly, FixedPoint::updateLaws() must follow.
void useLaws(const Scene& scene, assembly::Assembly& assembly);

/// Entries of a scene that only its laws depend on, see lawEntry(), as numbers that can be changed while the operators
/// stay.
class LawParameters {
 public:
  /// `input`, `path` and `overrides` are those that the scene was made of. `laws` and `assembly` must outlive it and
  /// all parameters that it gives.
  LawParameters(input::InputTree input, std::string path, std::vector<std::string> overrides,
                const laws::LawRegistry& laws, assembly::Assembly& assembly);

  /// The scene with the values set so far.
  const Scene& scene() const { return scene_; }
  /// The value of an entry now [unit of the entry]. Throws base::Error (input) when it is no number of this kind.
  double value(const std::string& entry) const;
  /// Gives an entry another value and exchanges the laws of the assembly. Throws base::Error (input) when it is no
  /// entry of this kind, or the value is not admissible; nothing has changed then.
  void set(const std::string& entry, double value);
  /// The entry as a parameter with its present value and a millionth of it as step; of one side where the value is the
  /// least or the largest that is admissible. This object must outlive it. Throws as value().
  latin::ModelParameter parameter(const std::string& entry);

 private:
  bool isAdmissible(const std::string& entry, double number);

  input::InputTree input_;
  std::string path_;
  std::vector<std::string> overrides_;
  const laws::LawRegistry& laws_;
  assembly::Assembly& assembly_;
  std::map<std::string, double> changes_;
  Scene scene_;
  input::Parameters given_;  // of the scene without changes
};

}  // namespace harmos::scene
