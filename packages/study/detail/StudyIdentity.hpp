#pragma once

#include <harmos/results/StudyDescription.hpp>
#include <harmos/study/Study.hpp>

namespace harmos::study {

/// What makes a study this one and no other: all entries of its input and of its scene, with defaults and in their
/// order, except titles; and checksums of the mesh and of the listed points. Reads these files.
results::Identity identityOf(const Study& study);

/// All that the files of a study say besides its results.
results::StudyDescription describe(const Study& study);

}  // namespace harmos::study
