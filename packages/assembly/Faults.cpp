#include <harmos/assembly/detail/Faults.hpp>

namespace harmos::assembly {
namespace {

// That many lines still fit on a page; faults of one cause are many.
constexpr int mostLines = 20;

}  // namespace

void Faults::add(const std::string& where, const std::string& what) {
  if (++count_ <= mostLines) lines_ += "\n  " + where + ": " + what + ".";
}

std::string Faults::text() const {
  if (count_ <= mostLines) return lines_;
  return lines_ + "\n  and " + std::to_string(count_ - mostLines) + " more.";
}

}  // namespace harmos::assembly
