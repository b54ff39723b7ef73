#include "adapters/asr/sphinx/hearing.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>
#include <utility>

#include "adapters/asr/words/agreement.hpp"
#include "adapters/asr/words/pronunciations.hpp"

namespace parlour::adapters::asr {

namespace {

constexpr const char* everything = "everything";
constexpr const char* domain = "domain";
// Searches of one decoder, which keep their memory.
constexpr std::size_t most_narrow = 16;
// The domain model joins words freely: if they are a sentence all the same, by
// no accident, they count at least so much.
constexpr double of_sentence = 0.5;
constexpr std::size_t least_sentence = 3; // words

std::vector<std::string> words_of(const std::vector<HeardWord>& heard) {
  std::vector<std::string> words;
  for (const auto& each : heard)
    words.push_back(each.word);
  return words;
}

} // namespace

std::vector<std::string> split_text(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

std::string text_of(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words)
    text.append(text.empty() ? "" : " ").append(word);
  return text;
}

// Words without any sound are left out of grammar and model: PocketSphinx drops
// what its dictionary lacks.
Expected<Vocabulary> make_vocabulary(const LanguageSources& sources,
                                     const std::string& model) {
  Vocabulary vocabulary;
  vocabulary.made = language_store().get(sources);
  const auto& language = vocabulary.made->language;
  const auto sounds = model_sounds(model, language.words(),
                                   given_sounds(sources.model.pronunciations));
  if (!sounds)
    return tl::make_unexpected(sounds.error());
  vocabulary.dictionary = dictionary_text(*sounds);
  vocabulary.domain_model = vocabulary.made->arpa();
  auto grammar = language.fsg(language.sentences());
  vocabulary.grammar = std::move(grammar.text);
  vocabulary.is_whole = grammar.is_whole;
  return vocabulary;
}

// Only the decoder by the domain model makes three passes
// (SphinxDecoder::Passes).
Expected<Hearing> Hearing::make(std::shared_ptr<const Vocabulary> vocabulary,
                                const std::string& model) {
  auto grammar = SphinxDecoder::make(model + "/en-us", vocabulary->dictionary);
  if (!grammar)
    return tl::make_unexpected(grammar.error());
  auto second = SphinxDecoder::make(model + "/en-us", vocabulary->dictionary,
                                    SphinxDecoder::Passes::three);
  if (!second)
    return tl::make_unexpected(second.error());
  if (auto added = grammar->add_grammar(everything, vocabulary->grammar);
      !added)
    return tl::make_unexpected(added.error());
  if (auto added = second->add_domain(domain, vocabulary->domain_model); !added)
    return tl::make_unexpected(added.error());
  return Hearing(std::move(vocabulary), std::move(*grammar),
                 std::move(*second));
}

Hearing::Hearing(std::shared_ptr<const Vocabulary> vocabulary,
                 SphinxDecoder grammar, SphinxDecoder second)
    : vocabulary_(std::move(vocabulary)), grammar_(std::move(grammar)),
      domain_(std::move(second)), search_(everything) {}

Expected<void> Hearing::begin(const std::vector<std::string>& grammars) {
  gate_ = {};
  search_ = search_for(grammars);
  if (auto begun = grammar_.begin(search_); !begun)
    return begun;
  return domain_.begin(domain);
}

// Searches stay, as they take time to be made. The oldest is replaced when
// there are too many.
std::string Hearing::search_for(const std::vector<std::string>& names) {
  const auto known = std::ranges::find(narrow_, names, &Narrow::names);
  if (known != narrow_.end())
    return known->search;
  auto graph = names.empty() ? std::nullopt
                             : vocabulary_->made->language.sentences(names);
  if (!graph)
    return everything;
  auto search = narrow_.size() < most_narrow
                    ? "narrow" + std::to_string(narrow_.size())
                    : narrow_.front().search;
  if (!grammar_.add_grammar(search,
                            vocabulary_->made->language.fsg(*graph).text))
    return everything;
  if (narrow_.size() == most_narrow)
    narrow_.erase(narrow_.begin());
  narrow_.push_back({names, search, std::move(*graph)});
  return search;
}

const WordGraph& Hearing::graph() const {
  const auto found = std::ranges::find(narrow_, search_, &Narrow::search);
  return found == narrow_.end() ? vocabulary_->made->language.sentences()
                                : found->graph;
}

void Hearing::hear(std::span<const Sample> audio) {
  decode(gate_.take(audio));
}

void Hearing::decode(std::span<const Sample> audio) {
  grammar_.hear(audio);
  domain_.hear(audio);
}

std::string Hearing::partial() const {
  return grammar_.text();
}

std::optional<bool> Hearing::ends(const std::string& partial) const {
  return vocabulary_->made->language.ends(graph(), split_text(partial));
}

// In noise the domain model hears better; what a narrow grammar expects is more
// probable than either.
Heard Hearing::finish() {
  decode(gate_.finish());
  const auto first = grammar_.finish();
  const auto second = domain_.finish();
  const auto by_grammar = words_of(first);
  const auto by_domain = words_of(second);
  Heard heard;
  heard.by_grammar = text_of(by_grammar);
  heard.by_domain = text_of(by_domain);
  const bool is_narrow = search_ != everything;
  const bool take_grammar = (is_narrow && !first.empty()) || second.empty();
  const auto agreed = take_grammar ? agreement(by_grammar, by_domain)
                                   : agreement(by_domain, by_grammar);
  heard.words = take_grammar ? first : second;
  heard.agreement = agreed.value;
  heard.agreed = agreed.agreed;
  if (!take_grammar && by_domain.size() >= least_sentence &&
      vocabulary_->made->language.ends(graph(), by_domain) == true)
    heard.agreement = std::max(heard.agreement, of_sentence);
  return heard;
}

void Hearing::drop() {
  gate_ = {};
  grammar_.drop();
  domain_.drop();
}

} // namespace parlour::adapters::asr
