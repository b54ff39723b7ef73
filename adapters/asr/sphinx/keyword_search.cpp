#include "adapters/asr/sphinx/keyword_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "adapters/asr/sphinx/hearing.hpp"
#include "adapters/asr/words/spoken_words.hpp"

namespace parlour::adapters::asr {

namespace {

constexpr const char* search = "keywords";

// Scores of one sound at the ends of the scale. Phrases in clear speech have
// -12 to 13, other speech has -7 and less.
constexpr double least_sensitive = 2;
constexpr double most_sensitive = -16;
// How a score becomes a confidence.
constexpr double steepness = 2;

std::size_t count_sounds(const std::string& phones) {
  return split_text(phones).size();
}

// A word with several pronunciations counts as its shortest.
std::size_t least_sounds(const std::vector<std::string>& ways) {
  auto least = count_sounds(ways.front());
  for (const auto& way : ways)
    least = std::min(least, count_sounds(way));
  return least;
}

Expected<Pronunciations> sounds_of(const std::set<std::string>& words,
                                   const std::string& model,
                                   const Pronunciations& given) {
  auto sounds = model_sounds(model, words, given);
  if (!sounds)
    return sounds;
  for (const auto& word : words)
    if (!sounds->contains(word))
      return fail(ErrorKind::settings,
                  "it is unknown how the keyword '" + word + "' sounds");
  return sounds;
}

} // namespace

// What is enough is said for each sound, and so depends on how long the phrase
// is.
Expected<Keywords> make_keywords(const std::vector<std::string>& phrases,
                                 const std::string& model, double sensitivity,
                                 const Pronunciations& given) {
  Keywords made;
  made.least_score =
      least_sensitive + sensitivity * (most_sensitive - least_sensitive);
  std::set<std::string> words;
  for (const auto& written : phrases) {
    const auto spoken = spoken_words(written);
    if (spoken.empty())
      return fail(ErrorKind::settings, "a keyword has no words");
    words.insert(spoken.begin(), spoken.end());
    made.phrases.push_back({written, text_of(spoken), 0});
  }
  const auto sounds = sounds_of(words, model, given);
  if (!sounds)
    return tl::make_unexpected(sounds.error());
  for (auto& phrase : made.phrases)
    for (const auto& word : split_text(phrase.spoken))
      phrase.sounds += least_sounds(sounds->at(word));
  made.dictionary = dictionary_text(*sounds);
  return made;
}

Expected<KeywordSearch>
KeywordSearch::make(std::shared_ptr<const Keywords> keywords,
                    const std::string& model) {
  auto decoder = SphinxDecoder::make(model + "/en-us", keywords->dictionary);
  if (!decoder)
    return tl::make_unexpected(decoder.error());
  std::string lines;
  for (const auto& phrase : keywords->phrases)
    lines +=
        fmt::format("{} /1e{:.0f}/\n", phrase.spoken,
                    keywords->least_score * static_cast<double>(phrase.sounds) /
                        std::numbers::ln10);
  if (auto added = decoder->add_keywords(search, lines); !added)
    return tl::make_unexpected(added.error());
  KeywordSearch made(std::move(keywords), std::move(*decoder));
  made.begin();
  return made;
}

KeywordSearch::KeywordSearch(std::shared_ptr<const Keywords> keywords,
                             SphinxDecoder decoder)
    : keywords_(std::move(keywords)), decoder_(std::move(decoder)) {}

void KeywordSearch::begin() {
  // It cannot fail: the search was added.
  (void)decoder_.begin(search);
}

// The library would tell the same phrase again and again.
std::vector<FoundKeyword> KeywordSearch::hear(std::span<const Sample> audio) {
  decoder_.hear(audio);
  std::vector<FoundKeyword> all;
  for (const auto& spotted : decoder_.spotted())
    all.push_back(found(spotted));
  if (!all.empty())
    begin();
  return all;
}

// At the threshold it is 0.5; each two points more for a sound bring it nearer
// to 1.
FoundKeyword KeywordSearch::found(const SpottedPhrase& spotted) const {
  const auto phrase = std::ranges::find(keywords_->phrases, spotted.phrase,
                                        &Keywords::Phrase::spoken);
  if (phrase == keywords_->phrases.end())
    return {spotted.phrase, 0.5};
  const auto above = spotted.score / static_cast<double>(phrase->sounds) -
                     keywords_->least_score;
  return {phrase->written,
          std::max(0.5, 1 / (1 + std::exp(-above / steepness)))};
}

} // namespace parlour::adapters::asr
