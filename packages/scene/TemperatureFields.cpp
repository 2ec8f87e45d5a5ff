#include <harmos/base/Error.hpp>
#include <harmos/files/NodalVariable.hpp>
#include <harmos/input/Field.hpp>
#include <harmos/scene/MeshSource.hpp>
#include <harmos/scene/detail/TemperatureField.hpp>
#include <harmos/scene/detail/VolumeLoad.hpp>

namespace harmos::scene {

namespace {

/// A number, with history and formula.
class PrescribedTemperature final : public TemperatureField {
 public:
  static input::ParameterSpec form() {
    input::ParameterSpec spec("Prescribed");
    spec.summary("A temperature of parts, which may follow a history and a formula.");
    spec.number("Temperature").unit("temperature").required().varying().doc("Of the parts.");
    input::Field::describe(spec, "Temperature");
    return spec;
  }
  PrescribedTemperature(const input::Parameters& parameters, const mesh::Mesh& mesh)
      : mesh_(mesh), field_(parameters, "Temperature") {}
  double at(int step, int node) const override { return field_(step, mesh_.nodes[node]); }

 private:
  const mesh::Mesh& mesh_;
  input::Field field_;
};

/// What the file of the mesh says of its nodes.
class NodalTemperature final : public TemperatureField {
 public:
  static input::ParameterSpec form() {
    input::ParameterSpec spec("Nodal Variable");
    spec.summary(
        "A temperature that the Exodus file of the mesh has at its nodes, such as that of a thermal analysis.");
    spec.text("Variable").required().doc("Name of the nodal variable.");
    spec.integer("Time Step").optional().atLeast(1).doc("Of the file, counted from 1; absent: the last.");
    spec.number("Factor").unit("-").defaultValue(1.0).varying().doc("Multiplies the variable.");
    return spec;
  }
  NodalTemperature(const input::Parameters& parameters, const TemperatureContext& context)
      : factor_(parameters.schedule("Factor")) {
    const auto refuse = [&](const std::string& what, const std::string& repair) {
      throw base::Error(parameters.where() + ": " + what + "\n  " + repair, base::ExitCode::input);
    };
    const auto file = meshFile(context.source, context.scenePath);
    if (!file) refuse("a generated mesh has no nodal variables.", "Take Type = Prescribed, with a formula.");
    if (context.source.has("Refine") || context.source.has("Order")) {
      refuse("the variable is known at the nodes of the file only.", "Remove Refine and Order from the list Mesh.");
    }
    values_ = files::readNodalVariable(*file, parameters.text("Variable"),
                                       parameters.has("Time Step") ? parameters.integer("Time Step") : 0);
    if (values_.size() != context.mesh.nodes.size()) {
      refuse("the variable has " + std::to_string(values_.size()) + " values, the mesh " +
                 std::to_string(context.mesh.nodes.size()) + " nodes.",
             "Give the file of the mesh itself.");
    }
  }
  double at(int step, int node) const override { return factor_[step] * values_[node]; }

 private:
  input::Schedule factor_;
  std::vector<double> values_;
};

}  // namespace

void describeTemperature(input::ParameterSpec& spec) {
  describeParts(spec);
  spec.number("Reference")
      .unit("temperature")
      .defaultValue(0.0)
      .doc("Temperature at which the parts are free of stress, as at the unloaded start.");
}

const TemperatureRegistry& builtInTemperatures() {
  static const TemperatureRegistry registry = [] {
    TemperatureRegistry all;
    all.add(PrescribedTemperature::form(), [](const input::Parameters& p, const TemperatureContext& context) {
      return std::make_unique<PrescribedTemperature>(p, context.mesh);
    });
    all.add(NodalTemperature::form(), [](const input::Parameters& p, const TemperatureContext& context) {
      return std::make_unique<NodalTemperature>(p, context);
    });
    return all;
  }();
  return registry;
}

}  // namespace harmos::scene
