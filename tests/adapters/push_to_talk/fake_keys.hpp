// A named pipe in the place of an input device of the kernel.
#pragma once

#include <cstring>
#include <string>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/input.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/support/temporary_folder.hpp"

namespace parlour::test {

class FakeKeys {
public:
  FakeKeys() {
    plug_in();
  }
  FakeKeys(const FakeKeys&) = delete;
  FakeKeys& operator=(const FakeKeys&) = delete;
  ~FakeKeys() {
    unplug();
  }

  std::string path() const {
    return (folder_.path() / "event3").string();
  }
  // The other side must have opened it before an event is written.
  void plug_in() {
    ASSERT_EQ(mkfifo(path().c_str(), 0600), 0);
  }
  void unplug() {
    std::filesystem::remove(path());
    if (pipe_ >= 0)
      close(pipe_);
    pipe_ = -1;
  }

  static std::string event(int type, int code, int value) {
    input_event made{};
    made.type = static_cast<decltype(made.type)>(type);
    made.code = static_cast<decltype(made.code)>(code);
    made.value = value;
    std::string bytes(sizeof made, '\0');
    std::memcpy(bytes.data(), &made, sizeof made);
    return bytes;
  }
  static std::string key(int code, int value) {
    return event(EV_MSC, MSC_SCAN, code) + event(EV_KEY, code, value) +
           event(EV_SYN, SYN_REPORT, 0);
  }
  void write(const std::string& bytes) {
    if (pipe_ < 0)
      pipe_ = open(path().c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    EXPECT_EQ(::write(pipe_, bytes.data(), bytes.size()),
              static_cast<ssize_t>(bytes.size()));
  }
  void press(int code = KEY_SPACE) {
    write(key(code, 1));
  }
  void repeat(int code = KEY_SPACE) {
    write(key(code, 2));
  }
  void release(int code = KEY_SPACE) {
    write(key(code, 0));
  }

private:
  TemporaryFolder folder_;
  int pipe_ = -1;
};

} // namespace parlour::test
