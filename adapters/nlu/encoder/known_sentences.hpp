// What SentenceEncoder makes of texts, kept in a file from one start to the
// next: thousands of texts take many seconds, and most are there again.
//
//  const auto file = known_sentences_file(environment);
//  const auto sentences = encode_all(texts, *encoder, file);
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "adapters/nlu/encoder/sentence_encoder.hpp"
#include "runtime/base/outside/environment.hpp"

namespace parlour::adapters::nlu {

// A file has no more than these; of more, those that were asked for last.
inline constexpr std::size_t most_known_sentences = 65'536;

// The file of this user: parlour/sentences.known below XDG_CACHE_HOME or
// ~/.cache, whose folder is made; empty if neither is known or can be written.
std::filesystem::path
known_sentences_file(const EnvironmentLookup& environment);

// What the encoder makes of each text, in their order, each number rounded to a
// byte, so that it is the same whether it was known or not. What the file does
// not have is encoded, by a few threads, and added. A file that is broken, of
// another encoder or cannot be written counts as none, for nothing is lost but
// time. Processes may share it: it is always whole, and one that writes while
// another does writes nothing. No file if `file` is empty. Of several threads,
// one works at a time.
std::vector<std::vector<float>>
encode_all(const std::vector<std::string>& texts,
           const SentenceEncoder& encoder, const std::filesystem::path& file);

} // namespace parlour::adapters::nlu
