#include "adapters/nlu/understand/explanation.hpp"

#include <algorithm>
#include <cstdio>

#include "adapters/nlu/acts/act_value.hpp"

namespace parlour::adapters::nlu {

namespace {

// How much is shown: the best islands, and the most likely topics.
constexpr std::size_t max_islands = 20;
constexpr std::size_t max_hypotheses = 3;

// Scores need no more precision to be compared.
std::string two_digits(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", number);
  return text;
}

} // namespace

std::vector<std::string>
Explanation::lines(const std::vector<Island>& islands,
                   const std::vector<Chain>& chains,
                   const std::vector<BuiltAct>& acts) const {
  std::vector<std::string> made{tokens()};
  std::vector<const Island*> sorted;
  for (const auto& one : islands)
    sorted.push_back(&one);
  std::ranges::stable_sort(sorted, std::greater(), &Island::score);
  if (sorted.size() > max_islands)
    sorted.resize(max_islands);
  for (const auto* one : sorted)
    made.push_back("island " + island(*one));
  for (const auto& chain : chains) {
    made.push_back("way " + two_digits(chain.score) + ":");
    for (const auto& link : chain.links)
      made.push_back("  " + topic(link.topic) + " " + island(*link.island));
  }
  for (const auto& one : acts)
    made.push_back(act(one));
  return made;
}

std::vector<std::string> Explanation::learnt(const TrainedModel& learned,
                                             const Likeness& likeness) const {
  std::vector<std::string> made;
  if (!learned.empty() && utterance_.size() > 0)
    made.push_back(learnt(learned));
  for (const auto& like :
       likeness.likes(utterance_, learned.words(utterance_, spans_)))
    made.push_back("alike " + two_digits(like.similarity) + " " +
                   topic(like.meaning.topic) + " \"" + like.sentence + '"');
  return made;
}

std::string Explanation::learnt(const TrainedModel& learned) const {
  const auto words = learned.words(utterance_, spans_);
  const auto hypotheses = learned.topics(words);
  if (hypotheses.empty())
    return "learnt nothing of these words";
  std::string line = "learnt";
  for (std::size_t at = 0; at < hypotheses.size() && at < max_hypotheses;
       ++at) {
    const auto& [number, probability, label] = hypotheses[at];
    line += " " + two_digits(probability) + " " + topic(number);
    for (const auto& [slot, value] : label->constants)
      line += "{" + slot + "=" + to_string(value) + "}";
  }
  for (const auto& slot :
       learned.slots(hypotheses[0].topic, word_features(words)))
    line += " " + slot.slot + "=\"" +
            std::string(words_of(utterance_.text, utterance_.tokens, slot.begin,
                                 slot.end)) +
            "\"";
  return line;
}

// Marks fillers, and words that no rule has.
std::string Explanation::tokens() const {
  std::string line = "tokens";
  for (std::size_t at = 0; at < utterance_.size(); ++at) {
    line += ' ' + utterance_.tokens.list[at].word;
    if (utterance_.filler[at])
      line += "(filler)";
    else if (utterance_.words[at] == unknown_word && !utterance_.synonyms[at] &&
             !utterance_.function[at])
      line += "(?)";
  }
  if (utterance_.tokens.truncated)
    line += " … (the rest is not looked at)";
  return line;
}

// The score, the words and the rule; then what it says. A confidence below 1
// means that the value was not said exactly.
std::string Explanation::island(const Island& one) const {
  auto line = two_digits(one.score) + " \"" +
              std::string(words_of(utterance_.text, utterance_.tokens,
                                   one.begin, one.end)) +
              "\" " + one.rule->name;
  if (!one.act.empty())
    line += " act=" + one.act;
  for (const auto& fill : one.fills) {
    line += " " + fill.slot + "=\"" +
            std::string(words_of(utterance_.text, utterance_.tokens, fill.begin,
                                 fill.end)) +
            "\"";
    if (fill.span && spans_[*fill.span].confidence < 1)
      line += "(" + two_digits(spans_[*fill.span].confidence) + ")";
  }
  return line;
}

std::string Explanation::act(const BuiltAct& one) const {
  return "act " + two_digits(one.score) + " " +
         to_string(Value(act_value(one, utterance_, spans_, schema_)));
}

std::string Explanation::topic(TopicNumber number) const {
  return number == no_topic ? "-" : schema_.at(number).name;
}

} // namespace parlour::adapters::nlu
