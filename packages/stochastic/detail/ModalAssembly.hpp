#pragma once

#include <memory>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/stochastic/Projection.hpp>
#include <harmos/stochastic/Realisations.hpp>

namespace harmos::stochastic {

/// The laws of an assembly at all points: nothing is random.
Realisations constantLaws(const assembly::Assembly& assembly, const Projection& projection);

/// The assembly whose "load steps" are the coefficients of its fields: column = (load step) * terms + polynomial.
///
/// Bodies share their stiffness matrices with `assembly`; loads of bodies are not random and stand in polynomial 0. The
/// laws are those of `assembly` at all points.
assembly::Assembly modalAssembly(const assembly::Assembly& assembly,
                                 const std::shared_ptr<const Projection>& projection);

/// Puts the laws at the first point in their places, and projected ones where tractions are prescribed. Throws
/// base::Error (input) naming the interface when their number is wrong or the laws of one interface are not of one
/// kind, or not of the kind that was there.
void setLaws(assembly::Assembly& modal, const Realisations& laws, const std::shared_ptr<const Projection>& projection);

}  // namespace harmos::stochastic
