#include <harmos/laws/LawRegistry.hpp>

#include <harmos/laws/FieldLaw.hpp>

namespace harmos::laws {

void addVarying(LawRegistry& laws, input::ParameterSpec spec, LawRegistry::Factory make, LawRegistry::Check check) {
  FieldLaw::describe(spec);
  const auto orField = [declared = spec, make = std::move(make),
                        check](const input::Parameters& p) -> std::unique_ptr<InterfaceLaw> {
    if (FieldLaw::isAskedFor(p)) return std::make_unique<FieldLaw>(declared, p, make, check);
    return make(p);
  };
  const auto both = [declared = spec, check = std::move(check)](const input::Parameters& p, input::ErrorList& errors) {
    FieldLaw::check(declared, p, errors);
    if (check) check(p, errors);
  };
  laws.add(std::move(spec), orField, both);
}

void addPointwise(LawRegistry& laws, input::ParameterSpec spec, LawRegistry::Factory make, LawRegistry::Check check) {
  for (const auto& entry : spec.entries()) {
    if (entry->type == input::ParameterType::number) entry->overSurface();
  }
  addVarying(laws, std::move(spec), std::move(make), std::move(check));
}

}  // namespace harmos::laws
