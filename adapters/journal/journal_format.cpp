#include "adapters/journal/journal_format.hpp"

#include <cstdint>

#include "runtime/base/word_hash.hpp"

namespace parlour::adapters {

namespace {

constexpr std::size_t frame_bytes = 8;

std::uint32_t checksum_of(std::string_view record) {
  WordHash hash;
  hash.add(record);
  return static_cast<std::uint32_t>(hash.value());
}

void add(std::string& bytes, std::uint32_t number) {
  for (int shift = 0; shift < 32; shift += 8)
    bytes += static_cast<char>(number >> shift & 0xff);
}

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i)
    number |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])}
              << (8 * i);
  return number;
}

} // namespace

std::string framed(std::string_view record) {
  std::string bytes;
  bytes.reserve(frame_bytes + record.size());
  add(bytes, static_cast<std::uint32_t>(record.size()));
  add(bytes, checksum_of(record));
  bytes += record;
  return bytes;
}

Expected<JournalReader> JournalReader::over(std::string_view bytes) {
  if (!bytes.starts_with(journal_magic))
    return fail(ErrorKind::file,
                "this is no journal: it does not begin with 'parlour journal "
                "1'");
  return JournalReader(bytes);
}

std::optional<Expected<std::string_view>> JournalReader::next() {
  if (torn_bytes() < frame_bytes)
    return std::nullopt;
  const std::size_t size = number_at(bytes_, at_);
  const auto place = "byte " + std::to_string(at_) + ": ";
  if (size > max_record_bytes)
    return fail(ErrorKind::file, place + "a record of " + std::to_string(size) +
                                     " bytes: the journal is damaged here");
  if (torn_bytes() - frame_bytes < size)
    return std::nullopt;
  const auto record = bytes_.substr(at_ + frame_bytes, size);
  if (number_at(bytes_, at_ + 4) != checksum_of(record))
    return fail(ErrorKind::file,
                place + "a record's checksum is wrong: the journal is damaged "
                        "here");
  at_ += frame_bytes + size;
  return Expected<std::string_view>(record);
}

} // namespace parlour::adapters
