#pragma once

#include <vector>

#include <harmos/assembly/Assembly.hpp>

namespace harmos::latin {

/// Patches of every interface, as lists of its pairs: all pairs in one, or of a slender face several that are not.
///
/// A part that is far longer than wide bends and twists so much more softly than the search direction k is stiff that
/// the iteration takes hundreds of linear stages to find how. The rigid motion of a whole face along it has nothing of
/// that, those of patches have. So faces in space whose law bonds are halved across their longest direction until they
/// are no longer slender. Lengths are from second moments: of a rectangle its length and its width. Faces with a
/// consistent mass, which couples patches, remain whole; so do all where patches would make the macro problem large.
std::vector<std::vector<std::vector<int>>> interfacePatches(const assembly::Assembly& assembly);

}  // namespace harmos::latin
