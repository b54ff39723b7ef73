#include "adapters/journal/journal_format.hpp"

#include <charconv>
#include <fstream>

#include "runtime/base/outside/file_bytes.hpp"
#include "runtime/base/text/word_hash.hpp"

namespace parlour::adapters {

namespace {

constexpr std::string_view magic = "parlour journal 2\n";
constexpr std::size_t header_bytes = magic.size() + 8 + 4;
constexpr std::size_t frame_bytes = 12;

std::uint32_t checksum_of(std::string_view record) {
  WordHash hash;
  hash.add(record);
  return static_cast<std::uint32_t>(hash.value());
}

std::uint32_t guard_of(std::uint64_t number) {
  WordHash hash;
  hash.add(number);
  return static_cast<std::uint32_t>(hash.value());
}

template <class Number>
void add(std::string& bytes, Number number) {
  for (std::size_t i = 0; i < sizeof(Number); ++i)
    bytes += static_cast<char>(number >> (8 * i) & 0xff);
}

template <class Number>
Number number_at(std::string_view bytes, std::size_t at) {
  Number number = 0;
  for (std::size_t i = 0; i < sizeof(Number); ++i)
    number |= Number{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  return number;
}

} // namespace

std::string part_header(std::uint64_t needed) {
  std::string bytes(magic);
  add(bytes, needed);
  add(bytes, guard_of(needed));
  return bytes;
}

std::string framed(std::string_view record) {
  const auto size = static_cast<std::uint32_t>(record.size());
  std::string bytes;
  bytes.reserve(frame_bytes + record.size());
  add(bytes, size);
  add(bytes, guard_of(size));
  add(bytes, checksum_of(record));
  bytes += record;
  return bytes;
}

std::filesystem::path part_path(const std::filesystem::path& folder,
                                std::uint64_t number) {
  const auto digits = std::to_string(number);
  return folder / (std::string(digits.size() < 6 ? 6 - digits.size() : 0, '0') +
                   digits + ".journal");
}

Expected<JournalParts> parts_of(const std::filesystem::path& folder) {
  const auto files = list_files(folder, ".journal");
  if (!files)
    return tl::make_unexpected(files.error());
  JournalParts parts;
  for (const auto& file : *files) {
    const auto name = file.stem().string();
    std::uint64_t number = 0;
    const auto* end = name.data() + name.size();
    const auto read = std::from_chars(name.data(), end, number);
    if (read.ec == std::errc() && read.ptr == end && number > 0)
      parts.emplace(number, file);
  }
  return parts;
}

std::uint64_t first_needed(const JournalParts& parts) {
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
    std::string header(header_bytes, '\0');
    std::ifstream file(part->second, std::ios::binary);
    if (!file.read(header.data(), header_bytes))
      continue;
    if (const auto reader = JournalReader::over(header))
      return reader->needed();
  }
  return 1;
}

Expected<JournalReader> JournalReader::over(std::string_view bytes) {
  if (!bytes.starts_with(magic.substr(0, bytes.size())))
    return fail(ErrorKind::file, "this is no part of a journal: it does not "
                                 "begin with 'parlour journal 2'");
  if (bytes.size() < header_bytes)
    return JournalReader(bytes, 0, 0);
  const auto needed = number_at<std::uint64_t>(bytes, magic.size());
  if (number_at<std::uint32_t>(bytes, magic.size() + 8) != guard_of(needed))
    return fail(ErrorKind::file, "the journal's header is damaged");
  return JournalReader(bytes, header_bytes, needed);
}

bool JournalReader::rest_is_zero() const {
  return bytes_.find_first_not_of('\0', at_) == std::string_view::npos;
}

std::optional<Expected<std::string_view>> JournalReader::next() {
  if (at_ == 0 || torn_bytes() < frame_bytes || rest_is_zero())
    return std::nullopt;
  const auto size = number_at<std::uint32_t>(bytes_, at_);
  const auto place = "byte " + std::to_string(at_) + ": ";
  if (number_at<std::uint32_t>(bytes_, at_ + 4) != guard_of(size) ||
      size > max_record_bytes)
    return fail(ErrorKind::file,
                place + "a record's size is wrong: the journal is damaged "
                        "here");
  if (torn_bytes() - frame_bytes < size)
    return std::nullopt;
  const auto record = bytes_.substr(at_ + frame_bytes, size);
  if (number_at<std::uint32_t>(bytes_, at_ + 8) != checksum_of(record))
    return fail(ErrorKind::file,
                place + "a record's checksum is wrong: the journal is damaged "
                        "here");
  at_ += frame_bytes + size;
  return Expected<std::string_view>(record);
}

} // namespace parlour::adapters
