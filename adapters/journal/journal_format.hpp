// The form of a journal: a folder of parts, files "000001.journal" and so on,
// each of which is
//
//   "parlour journal 2\n"
//   needed    8 bytes, lowest first: the number of the oldest part that the
//             sessions which were open when this one was begun stand in
//   guard     4 bytes, lowest first: the low half of its WordHash
//   then for each record
//     size      4 bytes, lowest first: of the record
//     guard     4 bytes, lowest first: the low half of the size's WordHash
//     checksum  4 bytes, lowest first: the low half of the record's WordHash
//     record    any bytes
//
// What a crash left unfinished at the end of a part is no damage, nor are zeros
// there, as a loss of power leaves them; anything else that is wrong is. The
// run after a crash begins a new part.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "runtime/base/error.hpp"

namespace parlour::adapters {

// More cannot be one record of a session.
inline constexpr std::size_t max_record_bytes = std::size_t{64} << 20;

// Larger parts are not read.
inline constexpr std::size_t max_part_bytes = std::size_t{4} << 30;

// What a part begins with, and a record as it stands there.
std::string part_header(std::uint64_t needed);
std::string framed(std::string_view record);

// The parts of a journal by their numbers. An error, of kind File: the folder
// cannot be read.
using JournalParts = std::map<std::uint64_t, std::filesystem::path>;
Expected<JournalParts> parts_of(const std::filesystem::path& folder);
std::filesystem::path part_path(const std::filesystem::path& folder,
                                std::uint64_t number);
// The oldest one that sessions which may be open stand in, as the last part
// says that has a whole header; 1 where none does.
std::uint64_t first_needed(const JournalParts& parts);

// Walks over the records of a part that is in memory.
class JournalReader {
public:
  // The bytes outlive the reader. An error of kind File: this is no journal, or
  // damaged. A part that a crash left without its header has no records.
  static Expected<JournalReader> over(std::string_view bytes);

  // Nothing at the end of what is whole. The error, of kind File, tells of
  // damage and its place; reading cannot go on behind it.
  std::optional<Expected<std::string_view>> next();
  // Of the header.
  std::uint64_t needed() const {
    return needed_;
  }
  // How many bytes were read, up to the end of the last whole record.
  std::size_t position() const {
    return at_;
  }
  // What follows there, if the last record is cut off.
  std::size_t torn_bytes() const {
    return bytes_.size() - at_;
  }

private:
  JournalReader(std::string_view bytes, std::size_t at, std::uint64_t needed)
      : bytes_(bytes), at_(at), needed_(needed) {}
  bool rest_is_zero() const;

  std::string_view bytes_;
  std::size_t at_;
  std::uint64_t needed_;
};

} // namespace parlour::adapters
