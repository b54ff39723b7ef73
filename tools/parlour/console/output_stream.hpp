// OutputStream: a std::ostream on a C stream, such as stdout, that remembers
// why a write failed. A std::ofstream does not tell.
#pragma once

#include <atomic>
#include <cstdio>
#include <ostream>
#include <streambuf>

namespace parlour::tools {

class OutputStream : public std::ostream {
public:
  // `file` must outlive the stream and stays the caller's. Output is buffered
  // by `file`, so other code may write to it as well.
  explicit OutputStream(std::FILE* file);

  // The errno of the first failed write, 0 if there was none. From any thread.
  int trouble() const {
    return buffer_.trouble;
  }

private:
  class Buffer : public std::streambuf {
  public:
    explicit Buffer(std::FILE* file) : file_(file) {}
    std::atomic<int> trouble = 0;

  protected:
    int_type overflow(int_type character) override;
    std::streamsize xsputn(const char* text, std::streamsize size) override;
    int sync() override;

  private:
    // Remembers errno if `written` is false; returns `written`.
    bool note(bool written);

    std::FILE* file_;
  };

  Buffer buffer_;
};

} // namespace parlour::tools
