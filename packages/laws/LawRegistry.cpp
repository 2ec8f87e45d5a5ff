#include <harmos/laws/LawRegistry.hpp>

#include <harmos/laws/FieldLaw.hpp>

namespace harmos::laws {

void addPointwise(LawRegistry& laws, input::ParameterSpec spec, LawRegistry::Factory make, LawRegistry::Check check) {
  FieldLaw::describe(spec);
  const auto orField = [declared = spec,
                        make = std::move(make)](const input::Parameters& p) -> std::unique_ptr<InterfaceLaw> {
    if (FieldLaw::isAskedFor(p)) return std::make_unique<FieldLaw>(declared, p, make);
    return make(p);
  };
  laws.add(std::move(spec), orField, std::move(check));
}

}  // namespace harmos::laws
