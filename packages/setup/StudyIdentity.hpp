#pragma once

#include <harmos/output/StudyDescription.hpp>
#include <harmos/setup/Study.hpp>

namespace harmos::setup {

/// What makes a study this one and no other: all entries of its input and of its scene, with defaults, except titles;
/// and checksums of the mesh and of the listed points. Reads these files.
output::Identity identityOf(const Study& study);

/// All that the files of a study say besides its results.
output::StudyDescription describe(const Study& study);

}  // namespace harmos::setup
