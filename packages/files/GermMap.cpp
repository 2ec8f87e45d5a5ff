#include <harmos/files/GermMap.hpp>

#include <cmath>

#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/files/detail/Hdf5Source.hpp>

namespace harmos::files {

GermMap GermMap::read(const Hdf5Source& group, const std::string& name) {
  const std::string map = group.text("map");
  if (map == "none") {
    throw base::Error("\"" + name +
                          "\" is correlated with other parameters, and its value alone does not tell the germ that "
                          "the expansions or the interpolation depend on.\n  Evaluate them in germs from Python: "
                          "study.statistics.expansion(\"RESPONSE\").evaluate(germs), or "
                          "study.statistics.interpolant.evaluate(germs).",
                      base::ExitCode::input);
  }
  return {name, group.number("shift"), group.number("scale"), map == "exponential"};
}

double GermMap::germ(double value) const {
  if (isExponential && !(value > 0.0)) {
    throw base::Error("\"" + name + "\" is lognormal and never " + base::toText(value) + ".", base::ExitCode::input);
  }
  return scale == 0.0 ? 0.0 : ((isExponential ? std::log(value) : value) - shift) / scale;
}

}  // namespace harmos::files
