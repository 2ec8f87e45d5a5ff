#include "RandomGlue.hpp"

#include <Tpetra_Core.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/latin/LatinOptions.hpp>
#include <harmos/probability/Normal.hpp>
#include <harmos/stochastic/AffineComponents.hpp>

#include "../unit/laws/MakeLaw.hpp"

namespace harmos::benchmarks {
namespace {

scene::Problem make(const scene::Scene& scene) {
  base::Timers timers;
  return scene::makeProblem(scene, *Tpetra::getDefaultComm(), timers);
}

std::shared_ptr<const probability::RandomVector> variables() {
  return std::make_shared<probability::RandomVector>(
      std::vector<probability::Variable>{{"I", std::make_shared<probability::Normal>(1.0, 0.2)},
                                         {"II", std::make_shared<probability::Normal>(1.0, 0.25)}});
}

}  // namespace

RandomGlue::RandomGlue(const std::string& path)
    : scene_(scene::readScene(path, {}, laws::builtInLaws())),
      problem_(make(scene_)),
      stages_(latin::LatinOptions(scene_.input.list("Solver")).stages),
      variables_(variables()) {
  for (const char* name : {"u_x", "u_y"}) {
    for (const auto& response : problem_.responses) {
      if (response->name() == name) responses_.push_back(response);
    }
  }
  for (const char* name : {"glue_1", "glue_2"}) {
    for (std::size_t i = 0; i < assembly().interfaces.size(); ++i) {
      const assembly::Interface& interface = assembly().interfaces[i];
      if (interface.name != name) continue;
      const auto components = stochastic::affineComponents(*interface.law, 0, 1.0, name);
      glues_.push_back({static_cast<int>(i), components[0].stiffness, components[1].stiffness});
    }
  }
  if (responses_.size() != 2 || glues_.size() != 2) {
    throw base::Error(path + " is not the glued assembly: it has no responses u_x and u_y or no glues 1 and 2");
  }
}

std::shared_ptr<const stochastic::Projection> RandomGlue::projection(int order, int points) const {
  return std::make_shared<stochastic::Projection>(std::make_shared<probability::Basis>(variables_, order),
                                                  probability::tensorQuadrature(*variables_, points));
}

std::vector<std::shared_ptr<const laws::InterfaceLaw>> RandomGlue::laws(const std::vector<double>& factors) const {
  std::vector<std::shared_ptr<const laws::InterfaceLaw>> result;
  for (const assembly::Interface& interface : assembly().interfaces) result.push_back(interface.law);
  for (std::size_t g = 0; g < glues_.size(); ++g) {
    result[glues_[g].interface] =
        laws::makeLaw("Linear Elastic", {{"Normal Stiffness", factors[g] * glues_[g].normal},
                                         {"Tangential Stiffness", factors[g] * glues_[g].tangential}});
  }
  return result;
}

stochastic::Realisations RandomGlue::realisations(const stochastic::Projection& projection) const {
  stochastic::Realisations result;
  for (const auto& germs : projection.quadrature().points) result.push_back(laws(factors(germs)));
  return result;
}

}  // namespace harmos::benchmarks
