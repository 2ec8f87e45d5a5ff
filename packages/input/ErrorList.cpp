#include <harmos/input/ErrorList.hpp>

namespace harmos::input {

namespace {

constexpr int mostShown = 100;             // errors: whoever has more has made one of them many times
constexpr std::size_t longestText = 2000;  // characters of one sentence, which may quote an entry of any length

std::string shortened(const std::string& text) {
  if (text.size() <= longestText) return text;
  std::size_t end = longestText;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // not inside of a letter of UTF-8
  return text.substr(0, end) + " ...";
}

}  // namespace

void ErrorList::add(const std::string& where, const std::string& what, const std::string& repair) {
  if (++count_ > mostShown) return;
  text_ += shortened(where) + ": " + shortened(what) + "\n";
  if (!repair.empty()) text_ += "  " + shortened(repair) + "\n";
}

bool ErrorList::collect(const std::string& where, const std::function<void()>& action) {
  try {
    action();
    return true;
  } catch (const base::Error& error) {
    if (error.code() != base::ExitCode::input) throw;
    const std::string message = error.what();
    if (message.rfind(where.substr(0, where.find(':') + 1), 0) == 0 || message.rfind("--set", 0) == 0) {
      if (++count_ <= mostShown) text_ += message + "\n";
    } else {
      add(where, message);
    }
    return false;
  }
}

std::string ErrorList::closing() const {
  return std::to_string(count_) + (count_ == 1 ? " error" : " errors") + "; nothing was run." +
         (count_ > mostShown ? " The first " + std::to_string(mostShown) + " are shown." : "");
}

std::string ErrorList::message() const {
  return count_ == 0 ? "" : text_ + closing();
}

void ErrorList::throwIfAny() const {
  if (count_ > 0) throw InputErrors(text_.substr(0, text_.size() - 1), closing());
}

}  // namespace harmos::input
