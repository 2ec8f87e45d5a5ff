#include <harmos/files/detail/SolutionJson.hpp>

namespace harmos::files {
namespace {

using Json = nlohmann::ordered_json;

Json vectorOf(const base::Vector3& v) {
  return {v[0], v[1], v[2]};
}

Json safetyOf(const std::optional<SafetyRecord>& safety, bool isNamed) {
  if (!safety) return nullptr;
  Json json = Json::object();
  if (isNamed) json["interface"] = safety->worst.of;
  json["whole"] = safety->whole;
  json["worst_point"] = {{"value", safety->worst.value}, {"position", vectorOf(safety->worst.position)}};
  return json;
}

}  // namespace

nlohmann::ordered_json toJson(const SolutionRecord& record) {
  Json json = Json::object();
  json["largest_von_mises"] = nullptr;
  if (const auto& peak = record.largestVonMises) {
    json["largest_von_mises"] = {{"value", peak->point.value},
                                 {"part", peak->point.of},
                                 {"position", vectorOf(peak->point.position)},
                                 {"at", peak->at}};
  }
  json["least_safety_against_slip"] = safetyOf(record.slip, true);
  json["least_safety_against_gaping"] = safetyOf(record.gaping, true);
  json["interfaces"] = Json::object();
  for (const InterfaceRecord& each : record.interfaces) {
    json["interfaces"][each.name] = {{"centre", vectorOf(each.centre)},
                                     {"normal", vectorOf(each.normal)},
                                     {"force", vectorOf(each.force)},
                                     {"moment", vectorOf(each.moment)},
                                     {"axial_force", each.axial},
                                     {"shear_force", each.shear},
                                     {"bending_moment", each.bending},
                                     {"torque", each.torque},
                                     {"dissipated_energy", each.dissipated},
                                     {"stored_energy", each.stored},
                                     {"safety_against_slip", safetyOf(each.slip, false)},
                                     {"safety_against_gaping", safetyOf(each.gaping, false)}};
  }
  json["parts"] = Json::object();
  for (const PartRecord& each : record.parts) {
    json["parts"][each.name] = {{"centre", vectorOf(each.centre)},
                                {"sum_of_forces", vectorOf(each.force)},
                                {"sum_of_moments", vectorOf(each.moment)},
                                {"largest_force", each.largestForce}};
  }
  return json;
}

}  // namespace harmos::files
