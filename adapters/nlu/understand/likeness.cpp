#include "adapters/nlu/understand/likeness.hpp"

#include <algorithm>
#include <optional>

#include "adapters/nlu/text/negation.hpp"
#include "adapters/nlu/text/word_set.hpp"
#include "adapters/nlu/understand/hypotheses.hpp"

namespace parlour::adapters::nlu {

namespace {

// From this score on, an utterance is the application's whatever it is like.
constexpr double well_said = 0.8;
// Rules with fewer meanings do not tell which words are theirs.
constexpr std::size_t enough_meanings = 20;
// How much nearer other talk must be.
constexpr float much_nearer = 0.05F;

// So many meanings are looked at.
constexpr std::size_t most_meanings = 3;

// With "@" for each value.
std::string shown(const std::vector<std::string>& words) {
  std::string made;
  for (const auto& word : words)
    made += (made.empty() ? "" : " ") + (word.starts_with('@') ? "@" : word);
  return made;
}

// How much more alike a text must be to a rule that gives a value which the
// text does not say: "how long is left" asks for no price.
constexpr double value_of_rule = 0.1;

// Fills a slot with the longest value of this kind, false if none is said.
bool add_value(BuiltAct& act, const Spans& spans, const std::string& slot,
               EntityId entity) {
  std::optional<std::uint32_t> best;
  for (std::uint32_t at = 0; at < spans.all().size(); ++at)
    if (const auto& span = spans[at];
        span.entity == entity && !span.unmatched &&
        (!best || span.end - span.core > spans[*best].end - spans[*best].core))
      best = at;
  if (best)
    act.fills.push_back(
        {slot, act.topic, best, {}, spans[*best].core, spans[*best].end});
  return best.has_value();
}

// Says a word for what was spoken of before: then any words may be meant.
bool refers_back(const Utterance& utterance) {
  static const WordSet references{
      "it",  "its",   "they", "them", "their", "she",  "he",    "her",  "him",
      "his", "there", "that", "this", "one",   "ones", "those", "these"};
  return std::ranges::any_of(utterance.tokens.list, [](const Token& token) {
    return references.contains(token.word);
  });
}

// Without fillers.
std::vector<std::string> plain_words(const Utterance& utterance) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < utterance.size(); ++at)
    if (!utterance.filler[at])
      words.push_back(utterance.tokens.list[at].word);
  return words;
}

bool are_apart(const Fill& one, const Fill& other) {
  return !one.span || !other.span || one.end <= other.begin ||
         other.end <= one.begin;
}

} // namespace

// Words, and others as which some may be read.
struct Likeness::Said {
  NearestTexts::Words words;
  std::vector<NearestTexts::Words> others;
};

Likeness::Likeness(const Automaton& automaton,
                   const std::vector<SampledSentence>& sentences,
                   const std::vector<std::string>& other_talk)
    : words_(automaton.vocabulary.size() + 1) {
  for (const auto& [word, number] : automaton.vocabulary)
    words_[number] = word;
  for (const auto& sentence : sentences) {
    const auto found = std::ranges::find(meanings_, sentence.meaning);
    const auto label = static_cast<std::uint32_t>(found - meanings_.begin());
    if (found == meanings_.end())
      meanings_.push_back(sentence.meaning);
    texts_.add(sentence.words, label);
    sentences_.push_back(shown(sentence.words));
    values_.push_back(sentence.values);
  }
  knows_other_talk_ =
      !other_talk.empty() && meanings_.size() >= enough_meanings;
  if (knows_other_talk_)
    for (const auto& sentence : other_talk)
      texts_.add_other(plain_words(make_utterance(sentence, automaton)));
  texts_.finish();
}

Likeness::Said Likeness::said(const Utterance& utterance,
                              const std::vector<LearningWord>& words) const {
  Said made;
  std::uint32_t before = 0;
  for (std::size_t at = 0; at < words.size(); ++at) {
    const auto kind = words[at].kind;
    if (kind == 0 && !utterance.filler[at]) {
      made.words.emplace_back(words[at].word);
      if (utterance.words[at] == unknown_word && utterance.synonyms[at]) {
        auto& further = made.others.emplace_back();
        for (const auto number : *utterance.synonyms[at])
          further.push_back(words_[number]);
      }
    } else if (kind != 0 && kind != before) {
      made.words.push_back(value_word(kind - 1));
    }
    before = kind;
  }
  return made;
}

std::vector<Likeness::Like>
Likeness::likes(const Utterance& utterance,
                const std::vector<LearningWord>& words) const {
  const auto said = this->said(utterance, words);
  std::vector<Like> made;
  for (const auto& near : texts_.find(said.words, said.others, most_meanings))
    made.push_back({meanings_[near.label], sentences_[near.text],
                    near.similarity, values_[near.text]});
  return made;
}

bool Likeness::leave_out_other_talk(std::vector<BuiltAct>& acts,
                                    const Utterance& utterance,
                                    const Spans& spans,
                                    const TrainedModel& learned,
                                    const Context& context) const {
  const auto is_doubtful = [&](const BuiltAct& act) {
    return act.topic != no_topic && act.score < well_said &&
           !context.expects(act.topic);
  };
  if (!knows_other_talk_ || acts.empty() || context.asked_topic != no_topic ||
      context.waiting_topic != no_topic || refers_back(utterance) ||
      !std::ranges::all_of(acts, is_doubtful))
    return false;
  const auto said = this->said(utterance, learned.words(utterance, spans));
  const auto near = texts_.nearness(said.words, said.others);
  const bool is_other_talk = near.other >= near.labelled + much_nearer;
  if (is_other_talk)
    acts.clear();
  return is_other_talk;
}

std::vector<BuiltAct> Likeness::acts(const Utterance& utterance, Spans& spans,
                                     const std::vector<LearningWord>& words,
                                     const Schema& schema,
                                     const Context& context,
                                     double threshold) const {
  std::vector<BuiltAct> acts;
  if (is_negated_order(utterance.tokens, utterance.negates))
    return acts;
  for (const auto& like : likes(utterance, words)) {
    const auto& topic = schema.at(like.meaning.topic);
    if (topic.part && !context.goes_on(like.meaning.topic))
      continue;
    BuiltAct act;
    act.act = like.meaning.act;
    act.topic = like.meaning.topic;
    act.end = static_cast<std::uint32_t>(utterance.size());
    act.score = like.similarity + context.bonus(act.topic);
    for (const auto& [slot, value] : like.meaning.literals)
      act.fills.push_back({slot, act.topic, {}, value, act.begin, act.end});
    if (!std::ranges::all_of(like.values, [&](const auto& value) {
          return add_value(act, spans, value.first, value.second);
        }))
      continue;
    for (auto& fill : certain_fills(utterance, spans, schema, act.topic))
      if (std::ranges::all_of(act.fills, [&](const Fill& other) {
            return other.slot != fill.slot && are_apart(other, fill);
          }))
        act.fills.push_back(std::move(fill));
    const bool begins = !topic.enquiry && act.fills.empty();
    if (act.score >= threshold + (begins ? task_without_values : 0) +
                         (like.meaning.literals.empty() ? 0 : value_of_rule))
      acts.push_back(std::move(act));
  }
  keep_best(acts);
  return acts;
}

} // namespace parlour::adapters::nlu
