#include "adapters/nlu/understand/likeness.hpp"

#include <algorithm>

#include "adapters/nlu/text/negation.hpp"
#include "adapters/nlu/understand/hypotheses.hpp"

namespace parlour::adapters::nlu {

namespace {

// Of the rules that are remembered, and how many meanings are looked at.
constexpr std::size_t sentences = 8000;
constexpr std::size_t most_meanings = 3;
// What a task that no value is said of needs beyond that.
constexpr double task_without_values = 0.1;
// How close to the best score an alternative is.
constexpr double alternative_range = 0.1;

std::string kind_word(EntityId entity) {
  return '@' + std::to_string(entity);
}

} // namespace

Likeness::Likeness(const Automaton& automaton, const Schema& schema)
    : words_(automaton.vocabulary.size() + 1) {
  for (const auto& [word, number] : automaton.vocabulary)
    words_[number] = word;
  for (const auto& sentence : sample_sentences(automaton, schema, sentences)) {
    NearestTexts::Words words;
    std::string shown_words;
    for (const auto& one : sentence.words) {
      words.push_back(one.word.empty() ? kind_word(one.value)
                                       : std::string(one.word));
      shown_words += (shown_words.empty() ? "" : " ") +
                     (one.word.empty() ? "@" : std::string(one.word));
    }
    const auto found = std::ranges::find(meanings_, sentence.meaning);
    const auto label = static_cast<std::uint32_t>(found - meanings_.begin());
    if (found == meanings_.end())
      meanings_.push_back(sentence.meaning);
    texts_.add(words, label);
    sentences_.push_back(std::move(shown_words));
  }
  texts_.finish();
}

std::vector<Likeness::Like>
Likeness::likes(const Utterance& utterance,
                const std::vector<LearningWord>& words) const {
  NearestTexts::Words said;
  std::vector<NearestTexts::Words> others;
  std::uint32_t before = 0;
  for (std::size_t at = 0; at < words.size(); ++at) {
    const auto kind = words[at].kind;
    if (kind == 0 && !utterance.filler[at]) {
      said.emplace_back(words[at].word);
      if (utterance.words[at] == unknown_word && utterance.synonyms[at]) {
        auto& further = others.emplace_back();
        for (const auto number : *utterance.synonyms[at])
          further.push_back(words_[number]);
      }
    } else if (kind != 0 && kind != before) {
      said.push_back(kind_word(kind - 1));
    }
    before = kind;
  }
  std::vector<Like> made;
  for (const auto& near : texts_.find(said, others, most_meanings))
    made.push_back(
        {meanings_[near.label], sentences_[near.text], near.similarity});
  return made;
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
    for (auto& fill : certain_fills(utterance, spans, schema, act.topic))
      if (std::ranges::find(act.fills, fill.slot, &Fill::slot) ==
          act.fills.end())
        act.fills.push_back(std::move(fill));
    const bool begins = !topic.enquiry && act.fills.empty();
    if (act.score >= threshold + (begins ? task_without_values : 0))
      acts.push_back(std::move(act));
  }
  std::ranges::stable_sort(acts, std::greater(), &BuiltAct::score);
  std::erase_if(acts, [&](const BuiltAct& act) {
    return act.score < acts.front().score - alternative_range ||
           (&act != &acts.front() && act.topic == acts.front().topic);
  });
  return acts;
}

} // namespace parlour::adapters::nlu
