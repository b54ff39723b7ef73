#include "runtime/base/bytes.hpp"

#include <utility>

#include "runtime/base/text/utf8.hpp"

namespace parlour {

void ByteWriter::number(std::uint64_t value) {
  for (; value >= 0x80; value >>= 7)
    byte(static_cast<std::uint8_t>(value | 0x80));
  byte(static_cast<std::uint8_t>(value));
}

// Zigzag encoding: small numbers of either sign stay short.
void ByteWriter::signed_number(std::int64_t value) {
  const auto doubled = static_cast<std::uint64_t>(value) << 1;
  number(value < 0 ? ~doubled : doubled);
}

void ByteWriter::fixed(std::uint64_t value) {
  for (int shift = 0; shift < 64; shift += 8)
    byte(static_cast<std::uint8_t>(value >> shift));
}

void ByteWriter::text(std::string_view value) {
  number(value.size());
  bytes_ += value;
}

// Moving to the end makes every later read fail as well, so loops stop.
void ByteReader::fail(std::string what) {
  if (!ok())
    return;
  failed_at_ = at_;
  what_ = std::move(what);
  at_ = bytes_.size();
}

Error ByteReader::error() const {
  return {
      ErrorKind::file, "byte " + std::to_string(failed_at_) + ": " + what_, {}};
}

std::uint8_t ByteReader::byte() {
  if (at_end()) {
    fail("the bytes end too early");
    return 0;
  }
  return static_cast<std::uint8_t>(bytes_[at_++]);
}

// Stops at the first byte whose highest bit is clear. The tenth byte may hold
// one bit only, and a last byte of zero would mean that the number has a
// shorter form.
std::uint64_t ByteReader::number() {
  std::uint64_t value = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    const auto part = byte();
    const bool too_large = shift == 63 && part > 1;
    const bool too_long = shift > 0 && part == 0;
    if (ok() && (too_large || too_long))
      fail("a number is not in its shortest form");
    if (!ok())
      return 0;
    value |= static_cast<std::uint64_t>(part & 0x7f) << shift;
    if (part < 0x80)
      break;
  }
  return value;
}

std::int64_t ByteReader::signed_number() {
  const auto value = number();
  const auto half = value >> 1;
  return static_cast<std::int64_t>(value & 1 ? ~half : half);
}

// Reads all eight bytes even after a failure, which are then zero.
std::uint64_t ByteReader::fixed() {
  std::uint64_t value = 0;
  for (int shift = 0; shift < 64; shift += 8)
    value |= static_cast<std::uint64_t>(byte()) << shift;
  return ok() ? value : 0;
}

std::string_view ByteReader::block() {
  const auto size = count("bytes");
  const auto value = bytes_.substr(at_, size);
  at_ += size;
  return value;
}

std::string_view ByteReader::text() {
  const auto value = block();
  if (!find_invalid_utf8(value))
    return value;
  fail("a text is not UTF-8");
  return {};
}

std::uint64_t ByteReader::below(std::uint64_t end, const char* what) {
  const auto value = number();
  if (ok() && value >= end)
    fail(std::string(what) + " " + std::to_string(value) +
         " is not there, of " + std::to_string(end) + " in all");
  return ok() ? value : 0;
}

std::size_t ByteReader::count(const char* what) {
  const auto value = number();
  const auto left = bytes_.size() - at_;
  if (value > left)
    fail(std::to_string(value) + " " + what + " are told, but only " +
         std::to_string(left) + " bytes are left");
  return ok() ? value : 0;
}

} // namespace parlour
