#include "adapters/asr/words/language_store.hpp"

#include <algorithm>
#include <utility>

#include "adapters/asr/words/packed_trigrams.hpp"

namespace parlour::adapters::asr {

namespace {

// With fewer, what is seldom said is missing; with more, it takes longer to
// make, to send and to read.
constexpr std::size_t drawn_sentences = 20'000;
// Three words that were drawn together once only were so by chance.
constexpr double least_drawn = 2;

} // namespace

MadeLanguage::MadeLanguage(const LanguageSources& sources)
    : language(sources), counts(language.sentences().arc_count() == 0
                                    ? TrigramCounts()
                                    : language.counts(drawn_sentences)) {}

std::string MadeLanguage::arpa() const {
  if (counts.empty())
    return "";
  return Trigrams(counts, least_drawn).arpa(language.symbols());
}

const std::string& MadeLanguage::packed_model() const {
  std::call_once(once_, [this] {
    if (!counts.empty())
      packed_ = packed(counts, language.symbols(), least_drawn);
  });
  return packed_;
}

bool LanguageStore::Kept::is_of(const LanguageSources& wanted) const {
  return sources.model == wanted.model && sources.generic == wanted.generic &&
         sources.forms == wanted.forms &&
         sources.conversations == wanted.conversations &&
         sources.wordings == wanted.wordings;
}

// No lock is held while columns are read and while a language is made: the
// first calls what is not ours, the second takes long.
std::shared_ptr<const MadeLanguage>
LanguageStore::get(const LanguageSources& sources) {
  const auto values_of =
      [&](const std::string& name) -> std::optional<std::vector<std::string>> {
    if (!sources.columns)
      return {};
    auto values = sources.columns(name);
    if (!values)
      return {};
    return std::move(*values);
  };
  const auto is_as_before = [&](const auto& column) {
    return values_of(column.first) == column.second;
  };
  if (const auto before = kept();
      before && before->is_of(sources) &&
      std::ranges::all_of(before->columns, is_as_before))
    return before->made;
  auto latest = std::make_shared<Kept>();
  latest->sources = sources;
  latest->sources.columns =
      [&](const std::string& name) -> Expected<std::vector<std::string>> {
    const auto& values = latest->columns[name] = values_of(name);
    if (!values)
      return fail(ErrorKind::database, name + " cannot be read");
    return *values;
  };
  latest->made = std::make_shared<const MadeLanguage>(latest->sources);
  latest->sources.columns = nullptr;
  keep(latest);
  return latest->made;
}

std::shared_ptr<const LanguageStore::Kept> LanguageStore::kept() const {
  const std::lock_guard lock(mutex_);
  return kept_;
}

void LanguageStore::keep(std::shared_ptr<const Kept> latest) {
  const std::lock_guard lock(mutex_);
  kept_ = std::move(latest);
}

LanguageStore& language_store() {
  static LanguageStore store;
  return store;
}

} // namespace parlour::adapters::asr
