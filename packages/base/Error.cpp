#include <harmos/base/Error.hpp>

#include <new>

namespace harmos::base {

namespace {

bool isWantOfMemory(const std::exception& error) {
  // What is longer than any memory is a length_error.
  if (dynamic_cast<const std::bad_alloc*>(&error) || dynamic_cast<const std::length_error*>(&error)) return true;
  // Kokkos makes a runtime_error of it; nothing but the text tells it apart.
  return std::string(error.what()).find("Kokkos failed to allocate memory") != std::string::npos;
}

}  // namespace

std::string messageOf(const std::exception& error) {
  if (!isWantOfMemory(error)) return error.what();
  return "There is not enough memory. \"harmos check\" tells what a scene or a study takes.\n  Take a coarser mesh, "
         "fewer time steps or more machines (mpirun).";
}

ExitCode exitCodeOf(const std::exception& error) {
  const auto* known = dynamic_cast<const Error*>(&error);
  return known ? known->code() : ExitCode::failure;
}

}  // namespace harmos::base
