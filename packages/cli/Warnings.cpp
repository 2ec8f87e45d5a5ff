#include <harmos/cli/detail/Warnings.hpp>

#include <ostream>

namespace harmos::cli {

void printWarnings(std::ostream& out, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) out << "warning: " << warning << "\n";
  if (!warnings.empty()) out << warnings.size() << (warnings.size() == 1 ? " warning\n" : " warnings\n");
}

}  // namespace harmos::cli
