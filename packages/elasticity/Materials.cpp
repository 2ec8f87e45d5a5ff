#include <harmos/elasticity/Materials.hpp>

#include <harmos/elasticity/Isotropic.hpp>
#include <harmos/elasticity/Orthotropic.hpp>

namespace harmos::elasticity {
namespace {

template <class M>
void add(MaterialRegistry& materials) {
  base::ParameterSpec spec(M::name);
  M::describe(spec);
  materials.add(std::move(spec),
                [](const base::Parameters& p) -> std::unique_ptr<Material> { return std::make_unique<M>(p); });
}

}  // namespace

MaterialRegistry builtInMaterials() {
  MaterialRegistry materials;
  add<Isotropic>(materials);
  add<Orthotropic>(materials);
  return materials;
}

}  // namespace harmos::elasticity
