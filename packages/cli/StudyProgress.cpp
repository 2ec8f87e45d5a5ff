#include <harmos/cli/detail/StudyProgress.hpp>

#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace harmos::cli {

namespace {

std::string duration(double seconds) {
  std::ostringstream text;
  if (seconds < 90.0) {
    text << std::lround(seconds) << " s";
  } else if (seconds < 5400.0) {
    text << std::lround(seconds / 60.0) << " min";
  } else {
    text << std::fixed << std::setprecision(1) << seconds / 3600.0 << " h";
  }
  return text.str();
}

}  // namespace

StudyProgress::StudyProgress(std::ostream& stream, bool isTerminal) : stream_(stream), isTerminal_(isTerminal) {}

void StudyProgress::begin(const results::StudyResults& results) {
  before_ = results.count();
  start_ = last_ = Clock::now();
}

void StudyProgress::report(const results::StudyResults& results) {
  const auto now = Clock::now();
  const double interval = isTerminal_ ? 0.2 : 10.0;  // [s]: smooth for the eye, and few lines in a log
  if (std::chrono::duration<double>(now - last_).count() < interval) return;
  last_ = now;
  const int all = static_cast<int>(results.configurations().size());
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double rate = (results.count() - before_) / seconds;
  std::ostringstream line;
  line << results.count() << " of " << all << " configurations";
  if (rate > 0.0) {
    line << std::fixed << std::setprecision(rate < 10.0 ? 1 : 0);
    if (rate >= 0.5) line << ", " << rate << " per second";
    if (rate < 0.5) line << ", " << 60.0 * rate << " per minute";
    if (results.count() < all) line << ", " << duration((all - results.count()) / rate) << " left";
  }
  const int solved = results.solved();
  if (solved < results.count()) line << ", " << results.count() - solved << " without solution";
  if (isTerminal_) {
    stream_ << "\r\033[K" << line.str() << std::flush;
  } else {
    stream_ << line.str() << std::endl;
  }
}

void StudyProgress::finish() {
  if (isTerminal_) stream_ << "\r\033[K" << std::flush;
}

}  // namespace harmos::cli
