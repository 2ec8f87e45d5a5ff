#include <harmos/files/DerivativesFile.hpp>

#include <filesystem>
#include <system_error>

#include <harmos/base/Numerals.hpp>
#include <harmos/files/AtomicFile.hpp>
#include <harmos/files/detail/CsvText.hpp>

namespace harmos::files {

void writeDerivatives(const std::string& path, const std::vector<double>& times,
                      const std::vector<ResponseDerivative>& derivatives) {
  if (derivatives.empty()) {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
    return;
  }
  std::string text = "response,parameter,step,time,derivative,residual\n";
  for (const ResponseDerivative& one : derivatives) {
    for (std::size_t t = 0; t < one.values.size(); ++t) {
      text += quoted(one.response) + "," + quoted(one.parameter) + "," + std::to_string(t + 1) + "," +
              base::toText(times[t]) + "," + base::toText(one.values[t]) + "," + base::toText(one.residuals[t]) + "\n";
    }
  }
  replaceFile(path, text);
}

}  // namespace harmos::files
