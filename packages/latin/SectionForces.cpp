#include <harmos/latin/SectionForces.hpp>

#include <algorithm>

#include <harmos/latin/InterfaceMass.hpp>

namespace harmos::latin {
namespace {

// Of the sum of h, below which the sum of h n is round-off: the normals cancel.
constexpr double noNormal = 1e-6;

}  // namespace

Section sectionOf(const assembly::Assembly& assembly, const std::vector<int>& interfaces, bool isAxisymmetric) {
  base::Vector3 centre{}, normal{};
  double area = 0.0;
  for (const int i : interfaces) {
    const assembly::Interface& interface = assembly.interfaces[i];
    for (int p = 0; p < interface.pairs(); ++p) {
      const double h = interface.area[p];
      area += h;
      centre = centre + h * interface.position[p];
      normal = normal + h * interface.frame[p][0];
    }
  }
  Section section;
  section.isAxisymmetric = isAxisymmetric;
  if (area == 0.0) return section;
  section.centre = (1.0 / area) * centre;
  if (isAxisymmetric) {
    section.centre[0] = 0.0;
    normal[0] = 0.0;
  }
  const double length = base::norm(normal);
  if (length > noNormal * area) section.normal = (1.0 / length) * normal;
  return section;
}

void SectionForces::add(const Section& section, const base::Vector3& position, const base::Vector3& f) {
  const base::Vector3 m = base::cross(position - section.centre, f);
  if (section.isAxisymmetric) {
    force[1] += f[1];
    moment[1] += m[1];
    return;
  }
  force = force + f;
  moment = moment + m;
}

SectionForces forcesOf(const assembly::Interface& interface, const PairFields& fields, int step,
                       const Section& section) {
  SectionForces forces;
  const std::vector<base::Vector3> places = placesOfForces(interface, interface.position);
  for (int p = 0; p < fields.pairs; ++p) {
    const base::Vector3 t = base::toGlobal(interface.frame[p], fields.traction[fields.at(step, p)]);
    forces.add(section, places[p], interface.area[p] * t);
  }
  return forces;
}

void SectionResponse::include(const assembly::Interface& interface, const PairFields& fields,
                              std::vector<double>& values) const {
  for (int t = 0; t < fields.steps; ++t) {
    const SectionForces forces = forcesOf(interface, fields, t, section_);
    double* sums = values.data() + static_cast<std::ptrdiff_t>(6) * t;
    for (std::size_t c = 0; c < 3; ++c) {
      sums[c] += forces.force[c];
      sums[3 + c] += forces.moment[c];
    }
  }
}

std::vector<double> SectionResponse::finish(std::vector<double> values) const {
  std::vector<double> result;
  for (auto from = values.begin(); from != values.end(); from += 6) {
    SectionForces forces;
    std::copy_n(from, 3, forces.force.begin());
    std::copy_n(from + 3, 3, forces.moment.begin());
    switch (component_) {
      case Component::axial:
        result.push_back(forces.axial(section_));
        break;
      case Component::shear:
        result.push_back(forces.shear(section_));
        break;
      case Component::bending:
        result.push_back(forces.bending(section_));
        break;
      case Component::torque:
        result.push_back(forces.torque(section_));
        break;
    }
  }
  return result;
}

}  // namespace harmos::latin
