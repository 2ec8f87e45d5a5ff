#pragma once

#include <string>
#include <vector>

#include <harmos/study/Study.hpp>

namespace harmos::study {

/// Whether the file is a study and not a scene. Throws base::Error (input) when it is no parameter list in XML.
bool isStudyFile(const std::string& path);

/// Reads a study and its scene and checks both. Each of `overrides` is "List/Sublist/Name=value" for an entry of the
/// study, or "Scene/List/Sublist/Name=value" for one of its scene. `pointsFile`, if not empty, replaces the design by
/// the rows of a CSV file. Throws one base::Error (input) that lists all errors. Not collective: every rank reads
/// the files. Keeps nothing of `laws`.
Study readStudy(const std::string& path, const std::vector<std::string>& overrides, const std::string& pointsFile,
                const laws::LawRegistry& laws);

/// readStudy() of an input in memory; `path` is where it comes from: relative names of files start at its folder.
/// `scene`, if not null, is its scene, which the entry Scene only names. Throws as readStudy().
Study makeStudy(input::InputTree input, const input::InputTree* scene, const std::string& path,
                const std::vector<std::string>& overrides, const std::string& pointsFile,
                const laws::LawRegistry& laws);

}  // namespace harmos::study
