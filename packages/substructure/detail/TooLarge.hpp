#pragma once

#include <stdexcept>

namespace harmos::substructure {

/// A solver cannot factor a matrix for its size; the message says what is exhausted.
class TooLarge : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace harmos::substructure
