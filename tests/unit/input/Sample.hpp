#pragma once

#include <string>

#include <harmos/base/Error.hpp>
#include <harmos/input/Check.hpp>

namespace harmos::input {

/// A small input with one of everything that a ParameterSpec can declare.
inline ParameterSpec sampleSpec() {
  ParameterSpec spec("Sample");
  spec.summary("An input for tests.");
  spec.text("Title").defaultValue("").doc("Free text.");
  spec.namedNumbers("Values").summary("Numbers to share.");
  spec.namedLists("Histories").numbers("Times").doc("Times.");
  auto& solver = spec.list("Solver");
  solver.number("Accuracy").defaultValue(1e-3).above(0).below(1).doc("Relative error asked for.");
  solver.integer("Iterations").unit("count").defaultValue(100).atLeast(1).doc("Limit.");
  solver.flag("Verbose").defaultValue(false).doc("Print more.");
  solver.text("Method").defaultValue("Plain").oneOf({"Plain", "Relaxed"}).doc("Algorithm.");
  solver.list("Scaling").number("Factor").defaultValue(1.0).doc("Scale.");
  auto& joints = spec.namedLists("Joints", true).summary("The joints.");
  joints.numbers("Axis").unit("length").optional().doc("Direction.");
  joints.texts("Sides").optional().doc("Side sets.");
  ParameterSpec friction("Friction"), glue("Glue");
  friction.summary("Sliding.").source("Coulomb (1785)");
  friction.number("Coefficient").unit("-").required().atLeast(0).varying().doc("Ratio of tractions.");
  glue.number("Stiffness").unit("stress/length").required().above(0).doc("Per area.");
  glue.number("Gap").unit("length").optional().varying().doc("Opening.");
  joints.alternatives("Law", {friction, glue}, true);
  return spec;
}

inline const char* sampleText() {
  return R"xml(<ParameterList name="Sample">
  <ParameterList name="Values">
    <Parameter name="mu" type="double" value="0.3"/>
  </ParameterList>
  <ParameterList name="Histories">
    <ParameterList name="ramp"><Parameter name="Times" type="Array(double)" value="{0, 1}"/></ParameterList>
  </ParameterList>
  <ParameterList name="Joints">
    <ParameterList name="seal">
      <Parameter name="Axis" type="Array(double)" value="{0, 0, $mu}"/>
      <ParameterList name="Law">
        <Parameter name="Type" type="string" value="Friction"/>
        <Parameter name="Coefficient" type="double" value="$mu"/>
        <Parameter name="Coefficient History" type="string" value="ramp"/>
      </ParameterList>
    </ParameterList>
  </ParameterList>
</ParameterList>
)xml";
}

/// The input that stands inside <ParameterList name="Sample">, from line 2 on.
inline InputTree sampleTree(const std::string& inside) {
  return InputTree::fromText("<ParameterList name=\"Sample\">\n" + inside + "\n</ParameterList>", "s.xml");
}

template <class Function>
std::string messageOf(Function function) {
  try {
    function();
  } catch (const base::Error& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace harmos::input
