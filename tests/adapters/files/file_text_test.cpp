#include <csignal>

#include <sys/resource.h>

#include "adapters/files/file_text.hpp"
#include "tests/adapters/files/files_fixture.hpp"

namespace parlour::adapters {
namespace {

class FileTextTest : public FilesTest {
protected:
  Folder folder = *Folder::open(data(), Missing::refuse);
};

// As a full disk does it: files of this process end at so many bytes.
class FileSizeLimit {
public:
  explicit FileSizeLimit(rlim_t bytes) {
    previous_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &limit_);
    auto lower = limit_;
    lower.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &lower);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &limit_);
    std::signal(SIGXFSZ, previous_);
  }

private:
  rlimit limit_{};
  void (*previous_)(int) = nullptr;
};

TEST_F(FileTextTest, ReadsWhatWasWritten) {
  const std::string text(200'000, 'x');
  ASSERT_TRUE(write_text(folder, "a", text, 1 << 20));
  EXPECT_EQ(*read_text(folder, "a", 1 << 20), text);
}

TEST_F(FileTextTest, OnAFullDiskTheOldTextStays) {
  ASSERT_TRUE(write_text(folder, "a", "old", 100));
  {
    FileSizeLimit limit(1'000);
    EXPECT_FALSE(write_text(folder, "a", std::string(2'000, 'x'), 1 << 20));
    EXPECT_FALSE(append_text(folder, "a", std::string(2'000, 'x'), 1 << 20));
  }
  EXPECT_EQ(*read_text(folder, "a", 100), "old");
  EXPECT_EQ(folder.names(10)->size(), 3u); // . .. a
}

TEST_F(FileTextTest, RemovesFilesOnly) {
  ASSERT_TRUE(write_text(folder, "a", "x", 10));
  EXPECT_TRUE(remove_file(folder, "a"));
  EXPECT_FALSE(remove_file(folder, "a"));
  link("../secret.txt", "l");
  EXPECT_FALSE(remove_file(folder, "l"));
}

} // namespace
} // namespace parlour::adapters
