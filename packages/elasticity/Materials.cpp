#include <harmos/elasticity/Materials.hpp>

#include <harmos/elasticity/detail/Isotropic.hpp>
#include <harmos/elasticity/detail/Orthotropic.hpp>

namespace harmos::elasticity {
namespace {

template <class M>
void add(MaterialRegistry& materials) {
  input::ParameterSpec spec(M::name);
  M::describe(spec);
  materials.add(std::move(spec),
                [](const input::Parameters& p) -> std::unique_ptr<Material> { return std::make_unique<M>(p); });
}

}  // namespace

MaterialRegistry builtInMaterials() {
  MaterialRegistry materials;
  add<Isotropic>(materials);
  add<Orthotropic>(materials);
  return materials;
}

}  // namespace harmos::elasticity
