// Gives readers damaged files: each must be read or refused as bad input, soon, and without a signal.
//
//   fuzz KIND SOURCES FOLDER SECONDS [SEED]
//
// KIND: xml (the scenes and studies in SOURCES), exodus, study. Environment: HARMOS_FUZZ_SECONDS, HARMOS_FUZZ_CASES and
// HARMOS_FUZZ_SEED go before what the command line says. Prints how many files were read and refused. A file that does
// worse stays as FOLDER/current, and the program ends with 1 or by the signal.

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <new>
#include <stdexcept>

#include <sys/resource.h>
#include <unistd.h>

#include <harmos/base/Error.hpp>

#include "Mutator.hpp"
#include "Targets.hpp"

namespace {

using Clock = std::chrono::steady_clock;

constexpr unsigned longest = 60;       // [s] for one file, on a machine that does much else
constexpr rlim_t memory = 4ull << 30;  // [byte]: what is larger must be refused, or fail as such

double setting(const char* variable, double otherwise) {
  const char* text = std::getenv(variable);
  return text && *text ? std::atof(text) : otherwise;
}

extern "C" void giveUp(int) {
  const char text[] = "a file takes too long; it stays as FOLDER/current\n";
  if (::write(STDERR_FILENO, text, sizeof text - 1) < 0) ::_exit(2);
  ::_exit(1);
}

struct Counts {
  long read = 0, refused = 0, tooLarge = 0;
};

/// Whether the file was treated as it should be.
bool tryFile(const Target& target, const std::string& content, Counts& counts) {
  try {
    target.read(content);
    ++counts.read;
    return true;
  } catch (const harmos::base::Error& error) {
    if (error.code() == harmos::base::ExitCode::input) {
      ++counts.refused;
      return true;
    }
    std::cerr << "not refused as bad input: " << error.what() << "\n";
  } catch (const std::bad_alloc&) {
    ++counts.tooLarge;
    return true;
  } catch (const std::exception& error) {
    std::cerr << "an exception that is no message: " << error.what() << "\n";
  }
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) {
    std::cerr << "usage: fuzz KIND SOURCES FOLDER SECONDS [SEED]\n";
    return 2;
  }
  const std::string folder = argv[3];
  std::filesystem::create_directories(folder);
  const double seconds = setting("HARMOS_FUZZ_SECONDS", std::atof(argv[4]));
  const double cases = setting("HARMOS_FUZZ_CASES", std::numeric_limits<double>::infinity());
  const auto seed = static_cast<std::uint32_t>(setting("HARMOS_FUZZ_SEED", argc > 5 ? std::atof(argv[5]) : 1.0));
  const Target target = makeTarget(argv[1], argv[2], folder);
  std::signal(SIGALRM, giveUp);
#ifndef __SANITIZE_ADDRESS__
  const struct ::rlimit limit { memory, memory };
  ::setrlimit(RLIMIT_AS, &limit);
#endif
  Counts counts;
  for (const std::string& sound : target.seeds) {
    if (!tryFile(target, sound, counts)) return 1;
  }
  if (counts.refused > 0) {
    std::cerr << "sound files are refused\n";
    return 1;
  }
  Mutator mutator(seed);
  const auto begin = Clock::now();
  long count = 0;
  for (; static_cast<double>(count) < cases; ++count) {
    if (std::chrono::duration<double>(Clock::now() - begin).count() > seconds) break;
    const std::string content = mutator.damaged(target.seeds[mutator.below(target.seeds.size())], target.isText);
    std::ofstream(folder + "/current", std::ios::binary) << content;
    ::alarm(longest);
    if (!tryFile(target, content, counts)) {
      std::cerr << "case " << count << " of seed " << seed << " stays as " << folder << "/current\n";
      return 1;
    }
    ::alarm(0);
  }
  std::cout << argv[1] << ": " << count << " damaged files, " << counts.read << " read, " << counts.refused
            << " refused, " << counts.tooLarge << " too large\n";
  return 0;
}
