#include "adapters/nlu/encoder/known_sentences.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <future>
#include <mutex>
#include <string_view>
#include <system_error>
#include <thread>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "adapters/nlu/text/hash.hpp"
#include "runtime/base/bytes.hpp"
#include "runtime/base/outside/file_bytes.hpp"

namespace parlour::adapters::nlu {

namespace {

namespace fs = std::filesystem;

// With another number where the encoder makes other numbers of the same file.
constexpr std::string_view file_mark = "PARLOURK1";
// Who writes is done long before.
constexpr std::chrono::minutes given_up{1};
constexpr std::size_t head_size = 16; // the sum and the hash
constexpr float largest_byte = 127;
// Other work goes on beside them.
constexpr std::size_t most_threads = 4;

// The numbers of a sentence, each as a byte times `step`.
struct Packed {
  float step = 0;
  std::string bytes;
};

// By the hash of the text.
using Known = std::unordered_map<std::uint64_t, Packed>;

Packed packed(const std::vector<float>& numbers) {
  float most = 0;
  for (const auto number : numbers)
    most = std::max(most, std::abs(number));
  Packed made{most > 0 ? most / largest_byte : 1, {}};
  for (const auto number : numbers)
    made.bytes += static_cast<char>(std::lround(number / made.step));
  return made;
}

std::vector<float> unpacked(const Packed& sentence) {
  std::vector<float> numbers;
  numbers.reserve(sentence.bytes.size());
  for (const char byte : sentence.bytes)
    numbers.push_back(static_cast<float>(static_cast<signed char>(byte)) *
                      sentence.step);
  return numbers;
}

// The file: its mark, the sum of the encoder's file, a hash of what follows, a
// count, and the hash, the step and the bytes of each sentence.
Known read_known(const fs::path& file, const SentenceEncoder& encoder) {
  const auto bytes =
      file.empty() ? Expected<std::string>(std::string()) : read_file(file);
  if (!bytes || !bytes->starts_with(file_mark))
    return {};
  const auto rest = std::string_view(*bytes).substr(file_mark.size());
  ByteReader reader(rest);
  if (reader.fixed() != encoder.sum() ||
      reader.fixed() != hash_of(rest.substr(std::min(rest.size(), head_size))))
    return {};
  Known known;
  const auto count = reader.count("sentences");
  for (std::size_t at = 0; at < count && reader.ok(); ++at) {
    const auto hash = reader.fixed();
    const auto step =
        std::bit_cast<float>(static_cast<std::uint32_t>(reader.number()));
    const auto numbers = reader.block();
    if (!std::isfinite(step) || numbers.size() != encoder.width())
      reader.fail("another sentence");
    known[hash] = {step, std::string(numbers)};
  }
  return reader.ok() ? std::move(known) : Known();
}

// A file for one writer at a time; what one that was killed has left is taken.
bool begin_file(const fs::path& begun) {
  std::error_code error;
  const auto written = fs::last_write_time(begun, error);
  if (!error && fs::file_time_type::clock::now() - written > given_up)
    fs::remove(begun, error);
  const int descriptor =
      open(begun.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0600);
  return descriptor >= 0 && close(descriptor) == 0;
}

// Under another name until it is whole. Somebody else who writes just now goes
// first: what is missing then is encoded at the next start.
void write_known(const fs::path& file, const SentenceEncoder& encoder,
                 const Known& known) {
  const auto begun = file.string() + ".new";
  if (!begin_file(begun))
    return;
  ByteWriter body;
  body.number(known.size());
  for (const auto& [hash, sentence] : known) {
    body.fixed(hash);
    body.number(std::bit_cast<std::uint32_t>(sentence.step));
    body.text(sentence.bytes);
  }
  const auto bytes = body.take();
  ByteWriter head;
  head.fixed(encoder.sum());
  head.fixed(hash_of(bytes));
  std::ofstream out(begun, std::ios::binary);
  out << file_mark << head.take() << bytes;
  out.close();
  std::error_code ignored;
  if (out)
    fs::rename(begun, file, ignored);
  fs::remove(begun, ignored);
}

// Every `step`th from `first` on.
std::vector<Packed> encoded(const std::vector<const std::string*>& texts,
                            const SentenceEncoder& encoder, std::size_t first,
                            std::size_t step) {
  std::vector<Packed> made;
  for (auto at = first; at < texts.size(); at += step)
    made.push_back(packed(encoder.encode(*texts[at])));
  return made;
}

void encode(const std::vector<const std::string*>& texts,
            const SentenceEncoder& encoder, Known& known) {
  const auto threads =
      std::min({texts.size(), most_threads,
                std::max<std::size_t>(std::thread::hardware_concurrency(), 1)});
  std::vector<std::future<std::vector<Packed>>> parts;
  for (std::size_t part = 0; part < threads; ++part)
    parts.push_back(std::async(std::launch::async, encoded, std::cref(texts),
                               std::cref(encoder), part, threads));
  for (std::size_t part = 0; part < threads; ++part) {
    auto at = part;
    for (auto& sentence : parts[part].get()) {
      known[hash_of(*texts[at])] = std::move(sentence);
      at += threads;
    }
  }
}

// Those that nobody asks for go where there are too many.
void keep_asked_for(Known& known, const std::vector<std::string>& texts) {
  if (known.size() <= most_known_sentences)
    return;
  Known kept;
  for (const auto& text : texts)
    if (kept.size() < most_known_sentences)
      kept[hash_of(text)] = known[hash_of(text)];
  known = std::move(kept);
}

} // namespace

fs::path known_sentences_file(const EnvironmentLookup& environment) {
  auto cache = user_folder(environment, "XDG_CACHE_HOME", ".cache");
  if (cache.empty())
    return {};
  cache /= "parlour";
  std::error_code ignored; // that it cannot be written is seen next
  fs::create_directories(cache, ignored);
  return access(cache.c_str(), W_OK) == 0 ? cache / "sentences.known"
                                          : fs::path();
}

std::vector<std::vector<float>>
encode_all(const std::vector<std::string>& texts,
           const SentenceEncoder& encoder, const fs::path& file) {
  // Who waits finds what the others have made.
  static std::mutex one_by_one;
  const std::lock_guard lock(one_by_one);
  auto known = read_known(file, encoder);
  std::vector<const std::string*> unknown;
  std::unordered_set<std::uint64_t> seen;
  for (const auto& text : texts)
    if (const auto hash = hash_of(text);
        !known.contains(hash) && seen.insert(hash).second)
      unknown.push_back(&text);
  encode(unknown, encoder, known);
  std::vector<std::vector<float>> made;
  made.reserve(texts.size());
  for (const auto& text : texts)
    made.push_back(unpacked(known[hash_of(text)]));
  if (!unknown.empty() && !file.empty()) {
    // Another process may have written meanwhile.
    known.merge(read_known(file, encoder));
    keep_asked_for(known, texts);
    write_known(file, encoder, known);
  }
  return made;
}

} // namespace parlour::adapters::nlu
