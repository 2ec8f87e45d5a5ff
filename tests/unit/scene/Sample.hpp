#pragma once

#include <string>

#include <harmos/scene/Problem.hpp>
#include <harmos/scene/Scene.hpp>

namespace harmos::scene {

/// Two boxes of equal size, one on the other, joined by friction, pressed in two steps.
inline const char* sampleScene() {
  return R"xml(<ParameterList name="Harmos">
  <ParameterList name="Mesh">
    <Parameter name="Type" type="string" value="Boxes"/>
    <ParameterList name="Boxes">
      <ParameterList name="lower">
        <Parameter name="Lower Corner" type="Array(double)" value="{0, 0, 0}"/>
        <Parameter name="Upper Corner" type="Array(double)" value="{2, 2, 1}"/>
        <Parameter name="Cells" type="Array(double)" value="{2, 2, 2}"/>
      </ParameterList>
      <ParameterList name="upper">
        <Parameter name="Lower Corner" type="Array(double)" value="{0, 0, 1}"/>
        <Parameter name="Upper Corner" type="Array(double)" value="{2, 2, 2}"/>
        <Parameter name="Cells" type="Array(double)" value="{2, 2, 2}"/>
      </ParameterList>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Materials">
    <ParameterList name="steel">
      <Parameter name="Type" type="string" value="Isotropic"/>
      <Parameter name="Young's Modulus" type="double" value="1000"/>
      <Parameter name="Poisson's Ratio" type="double" value="0"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Parts">
    <ParameterList name="lower"><Parameter name="Material" type="string" value="steel"/></ParameterList>
    <ParameterList name="upper">
      <Parameter name="Material" type="string" value="steel"/>
      <ParameterList name="Body Force">
        <Parameter name="Z" type="double" value="-3"/>
        <Parameter name="Z History" type="string" value="ramp"/>
      </ParameterList>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Interfaces">
    <ParameterList name="seal">
      <Parameter name="Part 1" type="string" value="lower"/>
      <Parameter name="Part 2" type="string" value="upper"/>
      <ParameterList name="Law">
        <Parameter name="Type" type="string" value="Coulomb Friction"/>
        <Parameter name="Friction Coefficient" type="double" value="0.3"/>
      </ParameterList>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Boundaries">
    <ParameterList name="fixed">
      <Parameter name="Side Set" type="string" value="lower_zmin"/>
      <ParameterList name="Law">
        <Parameter name="Type" type="string" value="Prescribed Displacement"/>
        <Parameter name="X" type="double" value="0"/>
        <Parameter name="Y" type="double" value="0"/>
        <Parameter name="Z" type="double" value="0"/>
      </ParameterList>
    </ParameterList>
    <ParameterList name="pressed">
      <Parameter name="Side Set" type="string" value="upper_zmax"/>
      <ParameterList name="Law">
        <Parameter name="Type" type="string" value="Pressure"/>
        <Parameter name="Pressure" type="double" value="10"/>
        <Parameter name="Pressure History" type="string" value="ramp"/>
      </ParameterList>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Steps">
    <ParameterList name="press"/>
    <ParameterList name="wait">
      <Parameter name="Duration" type="double" value="2"/>
      <Parameter name="Increments" type="int" value="4"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Histories">
    <ParameterList name="ramp">
      <Parameter name="Type" type="string" value="Ramp"/>
      <Parameter name="End" type="double" value="2"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Responses">
    <ParameterList name="force">
      <Parameter name="Type" type="string" value="Bolt Force"/>
      <Parameter name="Interface" type="string" value="seal"/>
    </ParameterList>
    <ParameterList name="sink">
      <Parameter name="Type" type="string" value="Mean Displacement"/>
      <Parameter name="Side Set" type="string" value="upper_zmax"/>
      <Parameter name="Direction" type="Array(double)" value="{0, 0, -2}"/>
    </ParameterList>
    <ParameterList name="corner">
      <Parameter name="Type" type="string" value="Point Displacement"/>
      <Parameter name="Point" type="Array(double)" value="{2, 0, 2}"/>
      <Parameter name="Direction" type="Array(double)" value="{0, 0, -1}"/>
    </ParameterList>
  </ParameterList>
</ParameterList>
)xml";
}

inline Scene sample(const std::vector<std::string>& overrides = {}) {
  return makeScene(input::InputTree::fromText(sampleScene(), "sample.xml"), "sample.xml", overrides,
                   laws::builtInLaws());
}

}  // namespace harmos::scene
