#include <harmos/stochastic/detail/ModalAssembly.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/stochastic/detail/ProjectedLaw.hpp>

namespace harmos::stochastic {
namespace {

bool areOfOneKind(const laws::InterfaceLaw& a, const laws::InterfaceLaw& b) {
  return a.historySize() == b.historySize() && a.frame() == b.frame() &&
         a.prescribesTraction() == b.prescribesTraction() && a.isAffine() == b.isAffine();
}

}  // namespace

Realisations constantLaws(const assembly::Assembly& assembly, const Projection& projection) {
  std::vector<std::shared_ptr<const laws::InterfaceLaw>> laws;
  for (const assembly::Interface& interface : assembly.interfaces) laws.push_back(interface.law);
  return Realisations(static_cast<std::size_t>(projection.points()), laws);
}

assembly::Assembly modalAssembly(const assembly::Assembly& assembly,
                                 const std::shared_ptr<const Projection>& projection) {
  if (assembly.path) {
    throw base::Error("random interfaces need loads whose size is given", base::ExitCode::input);
  }
  const int terms = projection->terms();
  assembly::Assembly modal = assembly;
  modal.times.clear();
  for (const double time : assembly.times) modal.times.insert(modal.times.end(), terms, time);
  for (substructure::Substructure& body : modal.bodies) {
    if (body.loads.numRows() == 0) continue;
    const base::Matrix loads = body.loads;
    body.loads.shape(loads.numRows(), modal.steps());
    for (int t = 0; t < loads.numCols(); ++t) std::copy_n(loads[t], loads.numRows(), body.loads[t * terms]);
  }
  setLaws(modal, constantLaws(assembly, *projection), projection);
  return modal;
}

void setLaws(assembly::Assembly& modal, const Realisations& laws, const std::shared_ptr<const Projection>& projection) {
  const std::size_t interfaces = modal.interfaces.size();
  bool fits = static_cast<int>(laws.size()) == projection->points();
  for (const auto& point : laws) fits = fits && point.size() == interfaces;
  if (!fits) {
    throw base::Error("random laws are needed at all " + std::to_string(projection->points()) +
                          " points of the quadrature, each for all " + std::to_string(interfaces) + " interfaces",
                      base::ExitCode::input);
  }
  for (std::size_t i = 0; i < interfaces; ++i) {
    assembly::Interface& interface = modal.interfaces[i];
    std::vector<std::shared_ptr<const laws::InterfaceLaw>> realisations;
    for (const auto& point : laws) {
      realisations.push_back(point[i]);
      if (!areOfOneKind(*interface.law, *point[i])) {
        throw base::Error("interface \"" + interface.name + "\": the law \"" + point[i]->name() +
                              "\" of a realisation is of another kind than \"" + interface.law->name() + "\"",
                          base::ExitCode::input);
      }
    }
    interface.law = realisations[0]->prescribesTraction()
                        ? std::make_shared<ProjectedLaw>(std::move(realisations), projection)
                        : realisations[0];
  }
}

}  // namespace harmos::stochastic
