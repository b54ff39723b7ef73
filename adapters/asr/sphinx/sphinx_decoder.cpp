#include "adapters/asr/sphinx/sphinx_decoder.hpp"

#include <cstdio>
#include <functional>
#include <map>
#include <string_view>
#include <utility>

#include <pocketsphinx.h>
#include <sphinxbase/err.h>

#include "adapters/asr/words/memory_file.hpp"

namespace parlour::adapters::asr {

namespace {

struct Free {
  void operator()(ps_decoder_t* decoder) const {
    ps_free(decoder);
  }
  void operator()(cmd_ln_t* config) const {
    cmd_ln_free_r(config);
  }
  void operator()(fsg_model_t* grammar) const {
    fsg_model_free(grammar);
  }
  void operator()(ngram_model_t* domain) const {
    ngram_model_free(domain);
  }
  void operator()(std::FILE* file) const {
    std::fclose(file);
  }
};

template <class T>
using Owned = std::unique_ptr<T, Free>;

// The library tells the score of a keyword less this, and divided by a power of
// two.
constexpr int most_of_keywords = 1'500;
constexpr int senone_shift = 10;

// Of grammars: with the library's beams (1e-48, 7e-29) the
// beginning of a right sentence is given up where other sentences sound better
// for a moment, which hangs on the level of what was said before.
constexpr double wide_beam = 1e-64;
constexpr double wide_word_beam = 1e-40;

// "(2)" behind a word is another way to say it; words in <> and [] are none.
std::string plain_word(const char* text) {
  std::string word(text);
  if (word.empty() || word[0] == '<' || word[0] == '[' || word[0] == '(' ||
      word[0] == '+')
    return {};
  return word.substr(0, word.find('('));
}

// How many ways to say it a word has, for words with several.
using Ways = std::map<std::string, int, std::less<>>;

// Those of a dictionary.
Ways ways_to_say(std::string_view text) {
  Ways ways;
  for (std::size_t at = 0; at < text.size();) {
    const auto line = text.substr(at, text.find('\n', at) - at);
    at += line.size() + 1;
    const auto name = line.substr(0, line.find(' '));
    if (name.ends_with(')'))
      ++ways.try_emplace(std::string(name.substr(0, name.find('('))), 1)
            .first->second;
  }
  return ways;
}

// A grammar with all ways to say its words. The library can add them itself,
// but looks through the whole grammar for each of them: twelve seconds for that
// of the receptionist.
std::string with_all_ways(std::string_view grammar, const Ways& ways) {
  std::string made;
  made.reserve(grammar.size());
  for (std::size_t at = 0; at < grammar.size();) {
    const auto line = grammar.substr(at, grammar.find('\n', at) - at);
    at += line.size() + 1;
    made.append(line).append("\n");
    if (!line.starts_with("TRANSITION"))
      continue;
    const auto word = line.substr(line.rfind(' ') + 1);
    if (const auto found = ways.find(word); found != ways.end())
      for (int way = 2; way <= found->second; ++way)
        made.append(line).append("(" + std::to_string(way) + ")\n");
  }
  return made;
}

tl::unexpected<Error> refused(const std::string& what) {
  return fail(ErrorKind::settings, "PocketSphinx does not take " + what);
}

} // namespace

struct SphinxDecoder::Implementation {
  Owned<cmd_ln_t> config;
  Owned<ps_decoder_t> decoder;
  int frames_a_second = 100;
  bool is_open = false;
  Ways ways; // of its dictionary

  float weight() const {
    return static_cast<float>(cmd_ln_float_r(config.get(), "-lw"));
  }
};

Expected<void> SphinxDecoder::is_built_in() {
  return {};
}

SphinxDecoder::SphinxDecoder(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

SphinxDecoder::SphinxDecoder(SphinxDecoder&&) noexcept = default;
SphinxDecoder& SphinxDecoder::operator=(SphinxDecoder&&) noexcept = default;
SphinxDecoder::~SphinxDecoder() = default;

// The dictionary is a file in memory: the library wants a name, and nothing is
// to be left on a disk.
Expected<SphinxDecoder> SphinxDecoder::make(const std::string& model,
                                            const std::string& dictionary,
                                            Passes passes) {
  err_set_logfp(nullptr);
  const auto file = MemoryFile::make(dictionary);
  if (!file)
    return fail(ErrorKind::limit, "there is no memory for a dictionary");
  auto made = std::make_unique<Implementation>();
  const auto* const more = passes == Passes::three ? "yes" : "no";
  made->config.reset(cmd_ln_init(nullptr, ps_args(), 1, "-hmm", model.c_str(),
                                 "-dict", file->path().c_str(), "-fwdflat",
                                 more, "-bestpath", more, "-fsgusealtpron",
                                 "no", nullptr));
  made->ways = ways_to_say(dictionary);
  if (made->config)
    made->decoder.reset(ps_init(made->config.get()));
  if (!made->decoder)
    return fail(ErrorKind::settings,
                "no acoustic model of PocketSphinx can be loaded from " +
                    model +
                    "; install pocketsphinx-en-us, or set the option 'model'");
  return SphinxDecoder(std::move(made));
}

// The beams are those of the configuration when the search is made.
Expected<void> SphinxDecoder::add_grammar(const std::string& name,
                                          const std::string& fsg) {
  auto* const decoder = implementation_->decoder.get();
  cmd_ln_set_float_r(implementation_->config.get(), "-beam", wide_beam);
  cmd_ln_set_float_r(implementation_->config.get(), "-wbeam", wide_word_beam);
  auto text = with_all_ways(fsg, implementation_->ways);
  const Owned<std::FILE> file(fmemopen(text.data(), text.size(), "r"));
  const Owned<fsg_model_t> grammar(
      file ? fsg_model_read(file.get(), ps_get_logmath(decoder),
                            implementation_->weight())
           : nullptr);
  if (!grammar || ps_set_fsg(decoder, name.c_str(), grammar.get()) < 0)
    return refused("the grammar '" + name + "'");
  return {};
}

Expected<void> SphinxDecoder::add_domain(const std::string& name,
                                         const std::string& arpa) {
  auto* const decoder = implementation_->decoder.get();
  auto* const config = implementation_->config.get();
  const auto file = MemoryFile::make(arpa);
  // Not read with the configuration: the library would weigh the model without
  // looking whether it could be read.
  const Owned<ngram_model_t> domain(
      file ? ngram_model_read(nullptr, file->path().c_str(), NGRAM_ARPA,
                              ps_get_logmath(decoder))
           : nullptr);
  if (!domain)
    return refused("the domain model '" + name + "'");
  ngram_model_apply_weights(domain.get(),
                            static_cast<float>(cmd_ln_float_r(config, "-lw")),
                            static_cast<float>(cmd_ln_float_r(config, "-wip")));
  if (ps_set_lm(decoder, name.c_str(), domain.get()) < 0)
    return refused("the domain model '" + name + "'");
  return {};
}

Expected<void> SphinxDecoder::add_keywords(const std::string& name,
                                           const std::string& keywords) {
  const auto file = MemoryFile::make(keywords);
  if (!file || ps_set_kws(implementation_->decoder.get(), name.c_str(),
                          file->path().c_str()) < 0)
    return refused("the keywords");
  return {};
}

Expected<void> SphinxDecoder::begin(const std::string& search) {
  drop();
  auto* const decoder = implementation_->decoder.get();
  if (ps_set_search(decoder, search.c_str()) < 0 || ps_start_utt(decoder) < 0)
    return refused("the search '" + search + "'");
  implementation_->is_open = true;
  return {};
}

void SphinxDecoder::hear(std::span<const Sample> audio) {
  if (implementation_->is_open)
    ps_process_raw(implementation_->decoder.get(), audio.data(), audio.size(),
                   0, 0);
}

std::string SphinxDecoder::text() const {
  const char* const text =
      implementation_->is_open
          ? ps_get_hyp(implementation_->decoder.get(), nullptr)
          : nullptr;
  return text ? text : "";
}

std::vector<SpottedPhrase> SphinxDecoder::spotted() const {
  std::vector<SpottedPhrase> found;
  auto* const decoder = implementation_->decoder.get();
  int score = 0;
  // The segments are those of the last hypothesis.
  if (!implementation_->is_open || !ps_get_hyp(decoder, &score))
    return found;
  for (auto* each = ps_seg_iter(decoder); each; each = ps_seg_next(each)) {
    const auto scaled =
        (ps_seg_prob(each, nullptr, nullptr, nullptr) + most_of_keywords)
        << senone_shift;
    // A blank stands behind it.
    std::string phrase = ps_seg_word(each);
    phrase.erase(phrase.find_last_not_of(' ') + 1);
    found.push_back({std::move(phrase),
                     logmath_log_to_ln(ps_get_logmath(decoder), scaled)});
  }
  return found;
}

// Words of silence and noise have no plain word, and are passed over.
std::vector<HeardWord> SphinxDecoder::finish() {
  std::vector<HeardWord> words;
  if (!implementation_->is_open)
    return words;
  auto* const decoder = implementation_->decoder.get();
  ps_end_utt(decoder);
  implementation_->is_open = false;
  const auto time = 1'000 / implementation_->frames_a_second;
  for (auto* each = ps_seg_iter(decoder); each; each = ps_seg_next(each)) {
    int first = 0;
    int last = 0;
    ps_seg_frames(each, &first, &last);
    if (auto word = plain_word(ps_seg_word(each)); !word.empty())
      words.push_back({std::move(word), std::int64_t{first} * time,
                       std::int64_t{last + 1} * time});
  }
  return words;
}

void SphinxDecoder::drop() {
  if (std::exchange(implementation_->is_open, false))
    ps_end_utt(implementation_->decoder.get());
}

} // namespace parlour::adapters::asr
