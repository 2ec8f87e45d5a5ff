#include "TestedLaws.hpp"

namespace harmos::laws {

LawRegistry testedLaws() {
  return builtInLaws();
}

std::vector<std::string> untestedLaws() {
  // Of whole faces, not of pairs: FaceLawTest and CoupledLawTest. With axes of their own: CylindricalTest and ToolsTest
  // in tests/verification. Of texts: FormulaLawTest.
  return {"Cylindrical Displacement", "Cylindrical Traction", "Face Spring",    "Formula",     "Pretension",
          "Remote Displacement",      "Remote Force",         "Rigid Cylinder", "Rigid Plane", "Rigid Sphere"};
}

}  // namespace harmos::laws
