#include <chrono>
#include <filesystem>

#include <gtest/gtest.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "tests/support/temporary_folder.hpp"
#include "tools/parlour/console/folder_watch.hpp"

namespace parlour::tools {
namespace {

using namespace std::chrono_literals;

class FolderWatchTest : public testing::Test {
protected:
  ~FolderWatchTest() override {
    close(stop_);
  }

  test::TemporaryFolder folder_;
  FolderWatch watch_ = FolderWatch::open().value();
  int stop_ = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
};

TEST_F(FolderWatchTest, sees_files_written_made_and_deleted) {
  folder_.write("deep/er/a.xml", "1");
  watch_.add(folder_.path());
  folder_.write("deep/er/a.xml", "2");
  EXPECT_TRUE(watch_.wait(stop_, 0ms));
  folder_.write("b.xml", "");
  EXPECT_TRUE(watch_.wait(stop_, 0ms));
  std::filesystem::remove(folder_.path() / "b.xml");
  EXPECT_TRUE(watch_.wait(stop_, 0ms));
}

TEST_F(FolderWatchTest, sees_what_is_in_new_folders) {
  watch_.add(folder_.path());
  std::filesystem::create_directory(folder_.path() / "new");
  EXPECT_TRUE(watch_.wait(stop_, 0ms));
  folder_.write("new/a.xml", "");
  EXPECT_TRUE(watch_.wait(stop_, 0ms));
}

TEST_F(FolderWatchTest, sees_a_file_that_is_replaced) {
  folder_.write("a.txt", "1");
  watch_.add(folder_.path() / "a.txt");
  for (const auto* text : {"2", "3"}) {
    folder_.write("a.new", text);
    std::filesystem::rename(folder_.path() / "a.new", folder_.path() / "a.txt");
    EXPECT_TRUE(watch_.wait(stop_, 0ms));
  }
}

// A version control system deletes a folder and makes it again.
TEST_F(FolderWatchTest, sees_a_folder_that_is_deleted_and_made_again) {
  folder_.write("apps/lab/deep/a.xml", "1");
  watch_.add(folder_.path() / "apps/lab");
  for (const auto* deleted : {"apps/lab", "apps"}) {
    std::filesystem::remove_all(folder_.path() / deleted);
    EXPECT_TRUE(watch_.wait(stop_, 0ms));
    while (watch_.changed()) {
    }
    std::filesystem::create_directories(folder_.path() / "apps/lab/deep");
    EXPECT_TRUE(watch_.wait(stop_, 0ms));
    while (watch_.changed()) {
    }
    folder_.write("apps/lab/deep/a.xml", "2");
    EXPECT_TRUE(watch_.wait(stop_, 0ms));
  }
}

TEST_F(FolderWatchTest, follows_the_name_and_not_the_folder) {
  folder_.write("lab/deep/a.xml", "1");
  watch_.add(folder_.path() / "lab");
  std::filesystem::rename(folder_.path() / "lab", folder_.path() / "old");
  watch_.changed();
  folder_.write("old/deep/a.xml", "2");
  EXPECT_FALSE(watch_.changed());
  folder_.write("lab/b.xml", "1");
  EXPECT_TRUE(watch_.changed());
  folder_.write("lab/b.xml", "2");
  EXPECT_TRUE(watch_.changed());
}

TEST_F(FolderWatchTest, follows_a_subfolder_with_a_new_name) {
  folder_.write("one/deep/a.xml", "1");
  watch_.add(folder_.path());
  std::filesystem::rename(folder_.path() / "one", folder_.path() / "two");
  EXPECT_TRUE(watch_.changed());
  std::filesystem::create_directory(folder_.path() / "two/deep/new");
  EXPECT_TRUE(watch_.changed());
  folder_.write("two/deep/new/a.xml", "1");
  EXPECT_TRUE(watch_.changed());
}

TEST_F(FolderWatchTest, sees_a_file_whose_folder_comes_later) {
  watch_.add(folder_.path() / "later/a.txt");
  folder_.write("later/b.txt", "");
  watch_.changed();
  EXPECT_FALSE(watch_.changed());
  folder_.write("later/a.txt", "");
  EXPECT_TRUE(watch_.changed());
}

TEST_F(FolderWatchTest, ends_when_it_is_to_stop) {
  watch_.add(folder_.path());
  eventfd_write(stop_, 1);
  EXPECT_FALSE(watch_.wait(stop_));
}

// Changes that do not matter are not reported, in whatever order they come.
TEST_F(FolderWatchTest, hears_nothing_of_other_files_and_of_editors_own) {
  folder_.write("a.txt", "1");
  watch_.add(folder_.path() / "a.txt");
  watch_.add(folder_.path() / "missing/b.txt");
  folder_.write("c.txt", "");
  EXPECT_FALSE(watch_.changed());
  watch_.add(folder_.path());
  folder_.write(".a.txt.swp", "");
  folder_.write("a.txt~", "");
  EXPECT_FALSE(watch_.changed());
  folder_.write("c.txt", "");
  EXPECT_TRUE(watch_.changed());
}

} // namespace
} // namespace parlour::tools
