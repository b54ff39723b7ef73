#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "runtime/base/outside/file_bytes.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour {
namespace {

class FileBytesTest : public testing::Test {
protected:
  std::string error_of(const std::string& name) const {
    const auto read = read_file(folder_.path() / name);
    return read ? "" : read.error().message;
  }
  test::TemporaryFolder folder_;
};

TEST_F(FileBytesTest, are_all_there_whatever_they_are) {
  std::string bytes(200'000, '\0');
  bytes += "\xff\n\r\n";
  folder_.write("file", bytes);
  EXPECT_EQ(read_file(folder_.path() / "file"), bytes);
  folder_.write("empty", "");
  EXPECT_EQ(read_file(folder_.path() / "empty"), "");
}

TEST_F(FileBytesTest, are_not_read_of_what_is_too_large) {
  folder_.write("file", std::string(1 << 20, 'x'));
  EXPECT_EQ(read_file(folder_.path() / "file", 1 << 20)->size(), 1u << 20);
  folder_.write("file", std::string((1 << 20) + 1, 'x'));
  EXPECT_EQ(read_file(folder_.path() / "file", 1 << 20).error().message,
            "this file is larger than 1 MB");
}

TEST_F(FileBytesTest, follow_a_link) {
  folder_.write("file", "x");
  std::filesystem::create_symlink("file", folder_.path() / "link");
  EXPECT_EQ(read_file(folder_.path() / "link"), "x");
}

TEST_F(FileBytesTest, are_of_regular_files_only) {
  std::filesystem::create_directory(folder_.path() / "folder");
  mkfifo((folder_.path() / "pipe").c_str(), 0600);
  sockaddr_un address{AF_UNIX, {}};
  const auto name = (folder_.path() / "socket").string();
  ASSERT_LT(name.size(), sizeof address.sun_path);
  name.copy(address.sun_path, name.size());
  const auto socket_number = socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(bind(socket_number, reinterpret_cast<const sockaddr*>(&address),
                 sizeof address),
            0);
  close(socket_number);
  EXPECT_EQ(error_of("folder"), "this is a folder, not a file");
  EXPECT_EQ(error_of("pipe"), "this is a named pipe, not a file");
  EXPECT_EQ(error_of("socket"), "this is a socket, not a file");
  EXPECT_EQ(read_file("/dev/null").error().message,
            "this is a device, not a file");
}

TEST_F(FileBytesTest, may_be_written_where_nothing_or_a_file_is) {
  folder_.write("file", "x");
  std::filesystem::create_directory(folder_.path() / "folder");
  EXPECT_TRUE(check_may_be_file(folder_.path() / "file"));
  EXPECT_TRUE(check_may_be_file(folder_.path() / "new"));
  EXPECT_FALSE(check_may_be_file(folder_.path() / "folder"));
}

TEST_F(FileBytesTest, name_the_systems_reason) {
  std::filesystem::create_symlink("loop", folder_.path() / "loop");
  EXPECT_EQ(error_of("nothing"),
            "this file cannot be read: No such file or directory");
  EXPECT_EQ(error_of("loop"),
            "this file cannot be read: Too many levels of symbolic links");
  EXPECT_EQ(error_of(std::string(300, 'x')),
            "this file cannot be read: File name too long");
}

} // namespace
} // namespace parlour
