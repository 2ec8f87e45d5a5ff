#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <Teuchos_XMLParameterListHelpers.hpp>
#include <Tpetra_Core.hpp>

#include <harmos/scene/LawParameters.hpp>
#include <harmos/scene/Problem.hpp>
#include <harmos/thyra/ResponseModel.hpp>

/// A block that is pushed to and fro over a glued pad, as a model g(p) of Trilinos: a scene in memory, numbers of its
/// laws as p, and the force that moves the block at every load step as g.
class Joint {
 public:
  /// `entries`: the numbers, by their paths in the scene; `way`: of the block, over its amplitude, at five equal times.
  Joint(const std::vector<std::string>& entries, const std::vector<double>& way) {
    namespace scene = harmos::scene;
    const auto comm = Tpetra::getDefaultComm();
    const auto list = Teuchos::getParametersFromXmlString(xml());
    list->sublist("Histories").sublist("way").set("Values", Teuchos::Array<double>(way));
    const auto input = harmos::input::InputTree::fromTeuchos(*list, "joint");
    scene::Scene checked = scene::makeScene(input, "joint", {}, laws_);
    checked.solver.stages.elimination = harmos::latin::Elimination::rigid;  // the glue on the ground may change
    harmos::base::Timers timers;
    problem_ = std::make_unique<scene::Problem>(scene::makeProblem(checked, *comm, timers));
    numbers_ =
        std::make_unique<scene::LawParameters>(input, "joint", std::vector<std::string>(), laws_, problem_->assembly);
    std::vector<harmos::latin::ModelParameter> parameters;
    for (const std::string& entry : entries) parameters.push_back(numbers_->parameter(entry));
    model_ = std::make_unique<harmos::thyra::ResponseModel>(problem_->assembly, checked.solver, problem_->responses,
                                                            std::move(parameters), comm);
  }

  /// Of which evalModel() can be asked, on all ranks.
  const harmos::thyra::ResponseModel& model() const { return *model_; }

 private:
  static std::string xml() {
    return R"xml(<ParameterList name="Harmos">
  <ParameterList name="Mesh"><Parameter name="Type" type="string" value="Boxes"/>
    <ParameterList name="Boxes">
      <ParameterList name="pad">
        <Parameter name="Lower Corner" type="Array(double)" value="{0, 0, 0}"/>
        <Parameter name="Upper Corner" type="Array(double)" value="{4, 2, 0.5}"/>
        <Parameter name="Cells" type="Array(double)" value="{4, 2, 1}"/>
      </ParameterList>
      <ParameterList name="block">
        <Parameter name="Lower Corner" type="Array(double)" value="{0, 0, 0.5}"/>
        <Parameter name="Upper Corner" type="Array(double)" value="{4, 2, 1.5}"/>
        <Parameter name="Cells" type="Array(double)" value="{4, 2, 1}"/>
      </ParameterList>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Materials"><ParameterList name="metal">
    <Parameter name="Type" type="string" value="Isotropic"/>
    <Parameter name="Young's Modulus" type="double" value="20000"/>
    <Parameter name="Poisson's Ratio" type="double" value="0.3"/>
  </ParameterList></ParameterList>
  <ParameterList name="Parts">
    <ParameterList name="pad"><Parameter name="Material" type="string" value="metal"/></ParameterList>
    <ParameterList name="block"><Parameter name="Material" type="string" value="metal"/></ParameterList>
  </ParameterList>
  <ParameterList name="Interfaces"><ParameterList name="sliding">
    <Parameter name="Part 1" type="string" value="pad"/>
    <Parameter name="Part 2" type="string" value="block"/>
    <ParameterList name="Law">
      <Parameter name="Type" type="string" value="Coulomb Friction"/>
      <Parameter name="Friction Coefficient" type="double" value="0.35"/>
    </ParameterList>
  </ParameterList></ParameterList>
  <ParameterList name="Boundaries">
    <ParameterList name="glue"><Parameter name="Side Set" type="string" value="pad_zmin"/>
      <ParameterList name="Law">
        <Parameter name="Type" type="string" value="Elastic Foundation"/>
        <Parameter name="Normal Stiffness" type="double" value="5000"/>
        <Parameter name="Tangential Stiffness" type="double" value="120"/>
      </ParameterList></ParameterList>
    <ParameterList name="load"><Parameter name="Side Set" type="string" value="block_zmax"/>
      <ParameterList name="Law">
        <Parameter name="Type" type="string" value="Pressure"/>
        <Parameter name="Pressure" type="double" value="10"/>
      </ParameterList></ParameterList>
    <ParameterList name="moved"><Parameter name="Side Set" type="string" value="block_xmin"/>
      <ParameterList name="Law">
        <Parameter name="Type" type="string" value="Prescribed Displacement"/>
        <Parameter name="X" type="double" value="0.1"/>
        <Parameter name="X History" type="string" value="way"/>
      </ParameterList></ParameterList>
  </ParameterList>
  <ParameterList name="Steps"><ParameterList name="press"/>
    <ParameterList name="move"><Parameter name="Duration" type="double" value="4"/>
      <Parameter name="Increments" type="int" value="12"/></ParameterList></ParameterList>
  <ParameterList name="Histories"><ParameterList name="way">
    <Parameter name="Type" type="string" value="Table"/>
    <Parameter name="Times" type="Array(double)" value="{1, 2, 3, 4, 5}"/>
    <Parameter name="Values" type="Array(double)" value="{0, 1, -1, 0.5, 1}"/>
  </ParameterList></ParameterList>
  <ParameterList name="Solver">
    <Parameter name="Accuracy" type="double" value="1e-6"/>
  </ParameterList>
  <ParameterList name="Responses"><ParameterList name="force">
    <Parameter name="Type" type="string" value="Interface Force"/>
    <Parameter name="Interface" type="string" value="moved"/>
    <Parameter name="Direction" type="Array(double)" value="{1, 0, 0}"/>
  </ParameterList></ParameterList>
</ParameterList>)xml";
  }

  harmos::laws::LawRegistry laws_ = harmos::laws::builtInLaws();
  std::unique_ptr<harmos::scene::Problem> problem_;
  std::unique_ptr<harmos::scene::LawParameters> numbers_;
  std::unique_ptr<harmos::thyra::ResponseModel> model_;
};
