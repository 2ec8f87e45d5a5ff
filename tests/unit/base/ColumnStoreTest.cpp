#include <csignal>
#include <filesystem>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <harmos/base/ColumnStore.hpp>
#include <harmos/base/Error.hpp>

namespace harmos::base {
namespace {

namespace fs = std::filesystem;

/// An empty folder of this process.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("harmos_column_store_" + std::to_string(::getpid()))) {
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string path() const { return path_.string(); }

 private:
  fs::path path_;
};

std::vector<double> read(const ColumnStore& store, int column) {
  const double* values = store.read(column);
  return {values, values + store.rows()};
}

void expectKept(ColumnStore store) {
  const std::vector<double> zero(3, 0.0), first{1.0, -2.0, 3.5}, last{1e300, 1e-300, 0.1};
  store.write(4, last.data());
  store.write(0, first.data());
  EXPECT_EQ(read(store, 0), first);
  EXPECT_EQ(read(store, 1), zero);
  EXPECT_EQ(read(store, 4), last);
  store.write(4, first.data());
  ColumnStore other;
  EXPECT_EQ(other.columns(), 0);
  other = std::move(store);
  EXPECT_EQ(read(other, 4), first);
  EXPECT_EQ(other.rows(), 3);
  EXPECT_EQ(other.columns(), 5);
}

TEST(ColumnStore, KeepsColumnsInMemory) {
  expectKept(ColumnStore(3, 5, ""));
}

TEST(ColumnStore, KeepsColumnsInAFileThatNobodySees) {
  const Folder folder;
  ColumnStore store(3, 5, folder.path());
  EXPECT_TRUE(fs::is_empty(folder.path()));
  expectKept(std::move(store));
}

TEST(ColumnStore, NamesTheFolderThatIsNotThere) {
  try {
    const ColumnStore store(3, 5, "/no/such/folder");
    ADD_FAILURE() << "a file in a folder that is not there";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("/no/such/folder: No such file"), std::string::npos) << error.what();
  }
}

TEST(ColumnStore, SaysThatThereIsNoRoom) {
  const Folder folder;
  const auto before = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
  const rlimit small{64, limit.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  EXPECT_THROW(ColumnStore(3, 5, folder.path()), Error);
  ::setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, before);
}

}  // namespace
}  // namespace harmos::base
