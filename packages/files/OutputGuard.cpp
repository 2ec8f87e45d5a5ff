#include <harmos/files/OutputGuard.hpp>

#include <filesystem>
#include <system_error>

#include <harmos/base/Error.hpp>

namespace harmos::files {

void demandDistinct(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs) {
  std::string text;
  for (const std::string& output : outputs) {
    for (const std::string& input : inputs) {
      std::error_code isMissing;
      if (!std::filesystem::equivalent(output, input, isMissing)) continue;
      text += "The result " + output + " would replace the input " + input +
              (output == input ? ".\n" : ", which is the same file.\n");
      break;
    }
  }
  if (text.empty()) return;
  throw base::Error(text + "  Write into another folder or under another name (--output). Nothing was written.",
                    base::ExitCode::input);
}

}  // namespace harmos::files
