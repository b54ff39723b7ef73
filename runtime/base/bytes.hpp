// Reading and writing bytes: the primitives that every binary format of the
// project is made of.
//
//   number   unsigned, 7 bits per byte, lowest bits first, as short as possible
//   signed   the same encoding of 2n for n >= 0 and of -2n-1 for n < 0
//   fixed    8 bytes, lowest byte first
//   text     the length as a number, then the bytes in UTF-8
//   block    the length as a number, then any bytes
//
// A reader trusts nothing that it reads: bytes that are missing, numbers that
// are not in their shortest form and texts that are not UTF-8 make it fail.
// After the first failure every read returns zero or an empty text. Callers
// therefore need to check ok() only before they allocate or loop by what was
// read.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "runtime/base/error.hpp"

namespace parlour {

// Appends to a buffer that it owns; take() hands the buffer over. Not
// thread-safe.
class ByteWriter {
public:
  void byte(std::uint8_t value) {
    bytes_ += static_cast<char>(value);
  }
  void number(std::uint64_t value);
  void signed_number(std::int64_t value);
  void fixed(std::uint64_t value);
  void text(std::string_view value); // also writes a block
  void add(const ByteWriter& other) {
    bytes_ += other.bytes_;
  }

  std::string take() {
    return std::move(bytes_);
  }

private:
  std::string bytes_;
};

// Reads from a buffer that the caller owns. Not thread-safe. An example:
//
//   ByteReader reader(bytes);
//   const auto count = reader.count("timers");
//   for (std::size_t i = 0; i < count && reader.ok(); ++i)
//     timers.push_back(read_timer(reader));
//   if (!reader.ok())
//     return tl::make_unexpected(reader.error());
class ByteReader {
public:
  // The bytes must outlive the reader and every view that it returns.
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  std::uint8_t byte();
  std::uint64_t number();
  std::int64_t signed_number();
  std::uint64_t fixed();
  std::string_view text();
  std::string_view block();

  // Reads a number below `end`, such as an index into a table of that size. A
  // larger one is a failure that names `what`.
  std::uint64_t below(std::uint64_t end, const char* what);
  // Reads how many elements follow. Each takes at least one byte, so a count
  // larger than the number of remaining bytes is a failure. This bounds what a
  // corrupt file can make its reader allocate.
  std::size_t count(const char* what);

  // Records a failure at the current position and skips to the end.
  void fail(std::string what); // only the first failure is kept
  bool ok() const {
    return what_.empty();
  }
  bool at_end() const {
    return at_ == bytes_.size();
  }
  // The first failure, of kind File: "byte 17: …". Call it only if !ok().
  Error error() const;

private:
  std::string_view bytes_;
  std::size_t at_ = 0;
  std::size_t failed_at_ = 0;
  std::string what_;
};

} // namespace parlour
