#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <vector>

#include <Kokkos_Core.hpp>

#include <harmos/base/Error.hpp>

namespace harmos::base {
namespace {

template <class Action>
std::string messageAfter(Action action) {
  try {
    action();
  } catch (const std::exception& error) {
    EXPECT_EQ(exitCodeOf(error), ExitCode::failure);
    return messageOf(error);
  }
  return "nothing thrown";
}

TEST(Error, WantOfMemoryIsSaidInWordsWhoeverMeetsIt) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer ends a program that asks for so much";
#endif
  const std::string expected = messageOf(std::bad_alloc());
  EXPECT_EQ(expected.rfind("There is not enough memory.", 0), 0u);
  EXPECT_EQ(messageAfter([] { std::vector<char>(std::size_t{1} << 46, 'x'); }), expected);
  EXPECT_EQ(messageAfter([] { std::vector<double>().resize(~std::size_t{0}); }), expected);
  EXPECT_EQ(messageAfter([] { Kokkos::View<double*, Kokkos::HostSpace>("values", std::size_t{1} << 46); }), expected);
}

TEST(Error, OthersKeepTheirMessageAndCode) {
  const Error error("wrong", ExitCode::input);
  EXPECT_EQ(messageOf(error), "wrong");
  EXPECT_EQ(exitCodeOf(error), ExitCode::input);
  EXPECT_EQ(messageOf(std::runtime_error("other")), "other");
  EXPECT_EQ(exitCodeOf(std::runtime_error("other")), ExitCode::failure);
}

}  // namespace
}  // namespace harmos::base
