#include <harmos/scene/ResultFields.hpp>

#include <harmos/scene/FieldFile.hpp>

namespace harmos::scene {

namespace {

/// The stress components that can differ from 0 in the plane, and those in space only.
const char* const planeStresses[] = {"xx", "yy", "zz", "xy"};
const char* const spaceStresses[] = {"yz", "zx"};

void addStresses(const std::string& prefix, std::vector<ResultField>& fields) {
  for (const char* c : planeStresses) fields.push_back({prefix + "stress_" + c, "[stress]", "component of the stress"});
  for (const char* c : spaceStresses) {
    fields.push_back({prefix + "stress_" + c, "[stress]", "component of the stress, in space only"});
  }
}

}  // namespace

std::vector<ResultField> nodalPartFields() {
  return {{"disp", "[length]", "displacement", true}};
}

std::vector<ResultField> nodalStressFields() {
  std::vector<ResultField> fields;
  addStresses("nodal_", fields);
  fields.push_back({"nodal_von_mises", "[stress]", "von Mises stress"});
  for (const char* number : {"1", "2", "3"}) {
    fields.push_back({std::string("principal_") + number, "[stress]", "principal stress, the largest first"});
  }
  return fields;
}

std::vector<ResultField> elementFields() {
  std::vector<ResultField> fields;
  addStresses("", fields);
  fields.push_back({"von_mises", "[stress]", "von Mises stress"});
  return fields;
}

std::vector<ResultField> interfaceFields() {
  return {{"disp", "[length]", "displacement of side 1", true},
          {"contact_pressure", "[stress]", "-t_n, negative in tension"},
          {"traction", "[stress]", "on side 1, on a boundary on the part", true},
          {"contact_status", "[-]", "0 open, 1 stick, 2 slip, 3 bonded, 4 broken"},
          {"opening", "[length]", "gap that is left"},
          {"slip", "[length]", "jump along the surface, side 2 less side 1", true},
          {"slip_magnitude", "[length]", "its length"},
          {"dissipation", "[energy/area]", "lost since the start"},
          {"safety_slip", "[-]", "mu p / |t_t|; 1000: no demand, or cannot slip"},
          {"safety_gaping", "[-]", "p_max / (p_max - p), p_max the largest pressure so far; 1000: no demand"},
          {"area", "[area]", "that the point stands for; sums of area times traction are the forces of the record"}};
}

std::vector<std::string> namesOf(const std::vector<ResultField>& fields, int dimension) {
  std::vector<std::string> names;
  for (const ResultField& field : fields) {
    if (field.isVector) {
      addVector(names, field.name, dimension);
    } else {
      names.push_back(field.name);
    }
  }
  return names;
}

}  // namespace harmos::scene
