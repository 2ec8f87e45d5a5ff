#include <harmos/base/ErrorList.hpp>

#include <harmos/base/Error.hpp>

namespace harmos::base {

void ErrorList::add(const std::string& where, const std::string& what, const std::string& repair) {
  text_ += where + ": " + what + "\n";
  if (!repair.empty()) text_ += "  " + repair + "\n";
  ++count_;
}

void ErrorList::throwIfAny() const {
  if (count_ == 0) return;
  throw Error(text_ + std::to_string(count_) + (count_ == 1 ? " error" : " errors") + "; nothing was run.",
              ExitCode::input);
}

}  // namespace harmos::base
