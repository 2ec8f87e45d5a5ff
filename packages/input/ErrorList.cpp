#include <harmos/input/ErrorList.hpp>

namespace harmos::input {

void ErrorList::add(const std::string& where, const std::string& what, const std::string& repair) {
  text_ += where + ": " + what + "\n";
  if (!repair.empty()) text_ += "  " + repair + "\n";
  ++count_;
}

bool ErrorList::collect(const std::string& where, const std::function<void()>& action) {
  try {
    action();
    return true;
  } catch (const base::Error& error) {
    if (error.code() != base::ExitCode::input) throw;
    const std::string message = error.what();
    if (message.rfind(where.substr(0, where.find(':') + 1), 0) == 0 || message.rfind("--set", 0) == 0) {
      text_ += message + "\n";
      ++count_;
    } else {
      add(where, message);
    }
    return false;
  }
}

std::string ErrorList::closing() const {
  return std::to_string(count_) + (count_ == 1 ? " error" : " errors") + "; nothing was run.";
}

std::string ErrorList::message() const {
  return count_ == 0 ? "" : text_ + closing();
}

void ErrorList::throwIfAny() const {
  if (count_ > 0) throw InputErrors(text_.substr(0, text_.size() - 1), closing());
}

}  // namespace harmos::input
