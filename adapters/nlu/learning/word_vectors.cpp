#include "adapters/nlu/learning/word_vectors.hpp"

#include <bit>
#include <cstring>
#include <utility>

#include "adapters/nlu/text/hash.hpp"
#include "runtime/base/outside/file_bytes.hpp"

namespace parlour::adapters::nlu {

static_assert(std::endian::native == std::endian::little,
              "the file of word vectors is little-endian");

namespace {

constexpr std::string_view file_mark = "PARLOURW";
// The mark and two counts.
constexpr std::size_t header = 16;
// Where the parts of a word begin.
constexpr std::size_t step_at = 8;
constexpr std::size_t groups_at = 12;
constexpr std::size_t steps_at = 16;

template <class T>
T number_at(std::string_view bytes, std::size_t at) {
  T number;
  std::memcpy(&number, bytes.data() + at, sizeof(T));
  return number;
}

} // namespace

WordVectors::WordVectors(std::string bytes, std::size_t words,
                         std::size_t record)
    : bytes_(std::move(bytes)), words_(words), record_(record) {}

Expected<std::shared_ptr<const WordVectors>>
WordVectors::read(const std::filesystem::path& path) {
  auto bytes = read_file(path);
  if (!bytes)
    return tl::make_unexpected(bytes.error());
  if (bytes->size() >= header && bytes->starts_with(file_mark)) {
    const std::size_t words = number_at<std::uint32_t>(*bytes, 8);
    const auto record = steps_at + number_at<std::uint32_t>(*bytes, 12);
    if (bytes->size() == header + words * record)
      return std::shared_ptr<const WordVectors>(
          new WordVectors(std::move(*bytes), words, record));
  }
  return fail(ErrorKind::file,
              "this file has no word vectors, or not all of them; "
              "`tools/dependencies words` makes it anew",
              {path.string(), 1, 1});
}

std::uint64_t WordVectors::hash_at(std::size_t number) const {
  return number_at<std::uint64_t>(bytes_, header + number * record_);
}

WordMeaning WordVectors::find(std::string_view word) const {
  const auto hash = hash_of(word);
  std::size_t first = 0;
  for (auto count = words_; count > 0;) {
    const auto half = count / 2;
    if (hash_at(first + half) < hash) {
      first += half + 1;
      count -= half + 1;
    } else {
      count = half;
    }
  }
  if (first == words_ || hash_at(first) != hash)
    return {};
  const auto found =
      std::string_view(bytes_).substr(header + first * record_, record_);
  return {found.substr(steps_at), number_at<float>(found, step_at),
          number_at<std::uint16_t>(found, groups_at),
          number_at<std::uint16_t>(found, groups_at + 2)};
}

} // namespace parlour::adapters::nlu
