#include "Interrupt.hpp"

#include <csignal>

namespace {

volatile std::sig_atomic_t interrupted = 0;

extern "C" void rememberInterrupt(int number) {
  interrupted = 1;
  std::signal(number, SIG_DFL);
}

}  // namespace

void catchInterrupts() {
  std::signal(SIGINT, rememberInterrupt);
  std::signal(SIGTERM, rememberInterrupt);
}

bool wasInterrupted() {
  return interrupted != 0;
}
