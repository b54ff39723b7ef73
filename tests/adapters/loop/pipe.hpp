// Pipe: two descriptors, whose ends a test closes as it likes.
#pragma once

#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace parlour::test {

class Pipe {
public:
  Pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC | O_NONBLOCK) == 0) {
      read_ = ends[0];
      write_ = ends[1];
    }
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close_read();
    close_write();
  }

  int read_end() const {
    return read_;
  }
  int write_end() const {
    return write_;
  }
  void say() {
    (void)!write(write_, "x", 1);
  }
  void hear() {
    char byte = 0;
    (void)!read(read_, &byte, 1);
  }
  // Until it takes no more.
  void fill() {
    const char bytes[4096] = {};
    while (write(write_, bytes, sizeof bytes) > 0) {
    }
  }
  void close_read() {
    if (read_ >= 0)
      close(std::exchange(read_, -1));
  }
  void close_write() {
    if (write_ >= 0)
      close(std::exchange(write_, -1));
  }

private:
  int read_ = -1;
  int write_ = -1;
};

} // namespace parlour::test
