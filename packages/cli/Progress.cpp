#include <harmos/cli/detail/Progress.hpp>

#include <iomanip>
#include <ostream>
#include <sstream>

namespace harmos::cli {

Progress::Progress(std::ostream& stream, Detail detail, bool isTerminal)
    : stream_(stream), detail_(detail), isTerminal_(isTerminal) {}

void Progress::report(const latin::IterationReport& report) {
  if (detail_ == Detail::none) return;
  const auto now = std::chrono::steady_clock::now();
  const double interval = isTerminal_ ? 0.2 : 5.0;  // [s]: smooth for the eye, and few lines in a log
  if (detail_ == Detail::sparse && std::chrono::duration<double>(now - last_).count() < interval) return;
  last_ = now;

  std::ostringstream line;
  if (report.loadStep >= 0) line << "load step " << report.loadStep + 1 << ", ";
  line << "iteration " << report.iteration << ", " << report.linearStages << " linear stages" << std::scientific
       << std::setprecision(2);
  if (report.change > 0.0) line << ", change " << report.change;
  if (detail_ == Detail::everyIteration && report.loadStep < 0) line << ", indicator " << report.indicator;
  if (isTerminal_ && detail_ == Detail::sparse) {
    stream_ << "\r\033[K" << line.str() << std::flush;
  } else {
    stream_ << line.str() << std::endl;
  }
}

void Progress::finish() {
  if (isTerminal_ && detail_ == Detail::sparse) stream_ << "\r\033[K" << std::flush;
}

}  // namespace harmos::cli
