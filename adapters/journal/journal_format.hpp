// The form of a journal's file:
//
//   "parlour journal 1\n"
//   then for each record
//     size      4 bytes, lowest first: of the record
//     checksum  4 bytes, lowest first: the low half of its WordHash
//     record    any bytes
//
// What a crash left unfinished at the end is no damage; anything else that is
// wrong is.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "runtime/base/error.hpp"

namespace parlour::adapters {

inline constexpr std::string_view journal_magic = "parlour journal 1\n";
// More cannot be one record of a session.
inline constexpr std::size_t max_record_bytes = std::size_t{64} << 20;

// Larger files are not read.
inline constexpr std::size_t max_journal_bytes = std::size_t{1} << 40;

// A record as it stands in the file.
std::string framed(std::string_view record);

// Walks over the records of a file that is in memory.
class JournalReader {
public:
  // The bytes outlive the reader. An error of kind File: this is no journal.
  static Expected<JournalReader> over(std::string_view bytes);

  // Nothing at the end of what is whole. The error, of kind File, tells of
  // damage and its place; reading cannot go on behind it.
  std::optional<Expected<std::string_view>> next();
  // How many bytes were read, up to the end of the last whole record.
  std::size_t position() const {
    return at_;
  }
  // What follows there, if the last record is cut off.
  std::size_t torn_bytes() const {
    return bytes_.size() - at_;
  }

private:
  explicit JournalReader(std::string_view bytes)
      : bytes_(bytes), at_(journal_magic.size()) {}

  std::string_view bytes_;
  std::size_t at_;
};

} // namespace parlour::adapters
