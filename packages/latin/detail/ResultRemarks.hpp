#pragma once

#include <memory>
#include <string>
#include <vector>

#include <harmos/latin/FixedPoint.hpp>
#include <harmos/latin/LatinResult.hpp>

namespace harmos::latin {

/// The responses at a state with the estimates of their errors, those of the fields last, see Snapshot::distance();
/// empty: not known. Collective.
void addResponses(const Iterate& state, const std::vector<std::shared_ptr<const Response>>& responses,
                  const std::vector<double>& estimates, LatinResult& result);

/// What the problem does not determine: ranges of responses wider than `accuracy` times their size, with a remark on
/// each, and interfaces whose pressures are free.
void addIndeterminacy(const Indeterminacy& found, double accuracy, LatinResult& result);

/// The interfaces whose laws soften, quoted, for the user.
std::string namesOfSoftening(const assembly::Assembly& assembly);

/// Remarks on laws that soften: that other solutions may exist, and how this one was reached. `isSofter`: the search
/// direction has become softer than the options want it.
void addSoftening(const FixedPoint& fixedPoint, bool isSofter, LatinResult& result);

}  // namespace harmos::latin
