// OutputStream: a stream of the process, such as standard output, that
// remembers why it could not be written.
#pragma once

#include <atomic>
#include <cstdio>
#include <ostream>
#include <streambuf>

namespace parlour::tools {

class OutputStream : public std::ostream {
public:
  // `file` has to outlive it and may be written by others at the same time.
  explicit OutputStream(std::FILE* file);

  // The errno of the first write that failed; 0: none did.
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
    bool note(bool written);

    std::FILE* file_;
  };

  Buffer buffer_;
};

} // namespace parlour::tools
