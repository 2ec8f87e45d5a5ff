#pragma once

#include <cstddef>
#include <string>

#include <harmos/base/Vector3.hpp>

/// How messages about places and values of a scene are put.
namespace harmos::scene {

/// "(1, 0, 0.5)", with six digits.
std::string text(const base::Vector3& v);

/// Shortest text of a number, without the sign of a zero.
std::string number(double value);

/// The same of a number that is computed, with nine digits.
std::string rounded(double value);

/// "1 node", "2 nodes".
std::string counted(std::size_t count, const std::string& what);

}  // namespace harmos::scene
