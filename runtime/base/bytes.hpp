// Writing and reading of bytes: what every binary format here is made of.
//
//   number   unsigned, 7 bits a byte, the lowest first, in as few as possible
//   signed   the same of 2n or -2n-1
//   fixed    8 bytes, the lowest first
//   text     its size as a number, then its bytes in UTF-8
//   block    its size as a number, then any bytes
//
// A reader trusts nothing: what is not there, not in its shortest form or not
// UTF-8 fails it. After its first failure it gives zeros and empty texts, so
// that only those who allocate or loop by what they read look in between.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "runtime/base/error.hpp"

namespace parlour {

class ByteWriter {
public:
  void byte(std::uint8_t value) {
    bytes_ += static_cast<char>(value);
  }
  void number(std::uint64_t value);
  void signed_number(std::int64_t value);
  void fixed(std::uint64_t value);
  void text(std::string_view value); // also for a block
  void add(const ByteWriter& other) {
    bytes_ += other.bytes_;
  }

  std::string take() {
    return std::move(bytes_);
  }

private:
  std::string bytes_;
};

class ByteReader {
public:
  // The bytes outlive the reader and what it gives.
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  std::uint8_t byte();
  std::uint64_t number();
  std::int64_t signed_number();
  std::uint64_t fixed();
  std::string_view text();
  std::string_view block();

  // Below `end`, such as an index; `what` is named where it is not.
  std::uint64_t below(std::uint64_t end, const char* what);
  // How many follow: not more than there are bytes left for.
  std::size_t count(const char* what);

  void fail(std::string what); // only the first failure is kept
  bool ok() const {
    return what_.empty();
  }
  bool at_end() const {
    return at_ == bytes_.size();
  }
  // Of kind File: "byte 17: …".
  Error error() const;

private:
  std::string_view bytes_;
  std::size_t at_ = 0;
  std::size_t failed_at_ = 0;
  std::string what_;
};

} // namespace parlour
