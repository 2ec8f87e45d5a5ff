#include <harmos/input/ErrorList.hpp>

#include <harmos/base/Error.hpp>

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

std::string ErrorList::message() const {
  if (count_ == 0) return "";
  return text_ + std::to_string(count_) + (count_ == 1 ? " error" : " errors") + "; nothing was run.";
}

void ErrorList::throwIfAny() const {
  if (count_ > 0) throw base::Error(message(), base::ExitCode::input);
}

}  // namespace harmos::input
