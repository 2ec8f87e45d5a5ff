#pragma once

#include <harmos/base/Error.hpp>

namespace harmos::laws {

/// A law has no answer at some pair: its message is a clause that follows the name of the law, `law "X" ...`. The
/// solver says at which interface and load step.
class LawFailure : public base::Error {
 public:
  using base::Error::Error;
};

}  // namespace harmos::laws
