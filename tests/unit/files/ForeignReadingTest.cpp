#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <new>
#include <stdexcept>
#include <vector>

#include <harmos/base/Error.hpp>
#include <harmos/files/detail/ForeignReading.hpp>

#include "TwoBoxes.hpp"

namespace harmos::files {
namespace {

class ForeignReading : public ::testing::Test {
 protected:
  void SetUp() override {
    path_ = temporaryFile("foreign");
    std::ofstream(path_) << "content";
  }

  /// What is said about a file that makes the reader do this.
  std::string messageOf(const std::function<void()>& action, base::ExitCode code = base::ExitCode::input) const {
    try {
      readForeign(
          {path_}, [&](ByteWriter&) { action(); }, [](ByteReader&) {});
    } catch (const base::Error& error) {
      EXPECT_EQ(error.code(), code);
      const std::string message = error.what(), beginning = "Cannot read " + path_ + ": it is damaged: ";
      return message.rfind(beginning, 0) == 0 ? message.substr(beginning.size()) : message;
    }
    return "accepted";
  }

  std::string path_;
};

TEST_F(ForeignReading, HandsOnWhatWasRead) {
  const std::vector<double> numbers(300000, 1.0 / 3.0);  // more than any buffer
  const std::vector<std::string> texts{"", "a", std::string(3000000, 'x')};
  readForeign(
      {path_},
      [&](ByteWriter& writer) {
        writer.put(7);
        writer.put(numbers);
        writer.put(texts);
        writer.put(std::vector<std::vector<int>>{{}, {1, 2}});
      },
      [&](ByteReader& reader) {
        EXPECT_EQ(reader.get<int>(), 7);
        EXPECT_EQ(reader.get<std::vector<double>>(), numbers);
        EXPECT_EQ(reader.get<std::vector<std::string>>(), texts);
        EXPECT_EQ(reader.get<std::vector<std::vector<int>>>(), (std::vector<std::vector<int>>{{}, {1, 2}}));
        EXPECT_THROW(reader.get<int>(), base::Error);
      });
}

TEST_F(ForeignReading, AnErrorIsThatOfTheReader) {
  EXPECT_EQ(messageOf([] { throw base::Error("no mesh", base::ExitCode::input); }), "no mesh");
  EXPECT_EQ(messageOf([] { throw base::Error("broken"); }, base::ExitCode::failure), "broken");
}

TEST_F(ForeignReading, ACrashIsTheFaultOfTheFile) {
  EXPECT_EQ(messageOf([] { std::abort(); }), "reading it fails (Aborted).");
  EXPECT_EQ(messageOf([] { std::raise(SIGSEGV); }), "reading it fails (Segmentation fault).");
  EXPECT_EQ(messageOf([] { throw std::out_of_range("map::at"); }), "what stands in it does not fit together.");
}

TEST_F(ForeignReading, WantOfMemoryIsTheFaultOfTheFile) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer ends a program that asks for so much";
#endif
  EXPECT_EQ(messageOf([] { std::vector<char>(std::size_t{1} << 45, 'x'); }),
            "it asks for more memory than a sound file of its size.");
}

TEST_F(ForeignReading, AnEndlessLoopEnds) {
  volatile bool isEndless = true;
  EXPECT_EQ(messageOf([&] {
              while (isEndless) {
              }
            }),
            "reading it does not end.");
}

TEST_F(ForeignReading, AnInterruptionIsNoFault) {
  EXPECT_EQ(messageOf([] {
              std::raise(SIGTERM);
              std::raise(SIGINT);
            }),
            "accepted");
}

}  // namespace
}  // namespace harmos::files
