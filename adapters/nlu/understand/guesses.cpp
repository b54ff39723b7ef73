#include "adapters/nlu/understand/guesses.hpp"

#include <algorithm>

#include "adapters/nlu/text/negation.hpp"

namespace parlour::adapters::nlu {

namespace {

// Grammars that understood this much need no guess.
constexpr double well_understood = 0.9;
constexpr double alternative_range = 0.1;
// Topics whose slots are looked for: the context may prefer one that is not
// the likeliest.
constexpr std::size_t most_topics = 4;

bool overlap(const Fill& fill, std::uint32_t begin, std::uint32_t end) {
  return fill.begin < end && begin < fill.end;
}

bool may_add(const std::vector<Fill>& fills, const Fill& more) {
  return std::ranges::none_of(fills, [&](const Fill& fill) {
    return fill.slot == more.slot || overlap(fill, more.begin, more.end);
  });
}

// The slots of one topic.
class SlotFiller {
public:
  SlotFiller(const Utterance& utterance, Spans& spans, const Schema& schema,
             TopicNumber topic)
      : utterance_(utterance), spans_(spans), schema_(schema), topic_(topic) {}

  std::vector<Fill> run(const std::vector<SlotGuess>& guesses) {
    for (const auto& guess : guesses)
      add_guess(guess);
    for (const auto& slot : schema_.at(topic_).slots)
      if (slot.entity != words_entity)
        add_certain(slot);
    std::ranges::stable_sort(fills_, {}, &Fill::begin);
    return std::move(fills_);
  }

private:
  void add_guess(const SlotGuess& guess) {
    const auto* slot = schema_.at(topic_).find(guess.slot);
    if (!slot)
      return;
    if (slot->entity == words_entity)
      add({slot->name, topic_, {}, {}, guess.begin, guess.end});
    else if (const auto span = span_of(slot->entity, guess))
      add(slot->name, *span);
  }

  // The longest value that begins in these words; else, for a set, the words
  // as none of its values.
  std::optional<std::uint32_t> span_of(EntityId entity,
                                       const SlotGuess& guess) {
    std::optional<std::uint32_t> best;
    for (auto at = guess.begin; at < guess.end; ++at)
      for (const auto index : spans_.at(entity, at))
        if (!best || spans_[index].end > spans_[*best].end)
          best = index;
    if (best || is_form(entity))
      return best;
    for (const auto index :
         spans_.open(entity, guess.begin, guess.end - guess.begin))
      if (spans_[index].end == guess.end)
        return index;
    return {};
  }

  // Values that can only be meant are slots' without being learnt as such.
  void add_certain(const Schema::Slot& slot) {
    for (std::size_t at = 0; at < utterance_.size(); ++at)
      for (const auto index : spans_.at(slot.entity, at))
        if (!spans_[index].weak)
          add(slot.name, index);
  }

  void add(const std::string& slot, std::uint32_t index) {
    const auto& span = spans_[index];
    add({slot, topic_, index, {}, span.core, span.end});
  }

  void add(Fill fill) {
    if (may_add(fills_, fill))
      fills_.push_back(std::move(fill));
  }

  const Utterance& utterance_;
  Spans& spans_;
  const Schema& schema_;
  TopicNumber topic_;
  std::vector<Fill> fills_;
};

double most_bonus(TopicNumber topic, const Context& context) {
  return context.bonus(topic) +
         (topic == context.asked_topic ? asked_bonus : 0);
}

double bonus_of(const BuiltAct& act, const Context& context) {
  const bool asked = act.topic == context.asked_topic &&
                     std::ranges::find(act.fills, context.asked_slot,
                                       &Fill::slot) != act.fills.end();
  return context.bonus(act.topic) + (asked ? asked_bonus : 0);
}

// Not even one word that means something by itself.
bool means_nothing(const Utterance& utterance) {
  for (std::size_t at = 0; at < utterance.size(); ++at)
    if (!utterance.function[at] && !utterance.filler[at])
      return false;
  return true;
}

// Of what was not to be done.
BuiltAct refusal(const Utterance& utterance, double score) {
  BuiltAct act;
  act.act = "deny";
  act.negated = true;
  act.end = static_cast<std::uint32_t>(utterance.size());
  act.score = score;
  return act;
}

} // namespace

std::vector<BuiltAct> guessed_acts(const Learned& learned,
                                   const Utterance& utterance, Spans& spans,
                                   const Schema& schema, const Context& context,
                                   double threshold) {
  std::vector<BuiltAct> acts;
  if (learned.empty() || means_nothing(utterance))
    return acts;
  const auto words = learning_words(utterance, spans);
  auto topics = learned.topics(words);
  topics.resize(std::min(topics.size(), most_topics));
  std::vector<std::vector<Feature>> features;
  for (const auto& guess : topics) {
    if (guess.probability + most_bonus(guess.topic, context) < threshold)
      continue;
    if (features.empty())
      features = word_features(words);
    BuiltAct act;
    if (is_negated_order(utterance.tokens, utterance.negates))
      return {refusal(utterance, guess.probability)};
    act.act = schema.at(guess.topic).enquiry ? "request" : "inform";
    act.topic = guess.topic;
    act.fills = SlotFiller(utterance, spans, schema, guess.topic)
                    .run(learned.slots(guess.topic, features));
    act.end = static_cast<std::uint32_t>(utterance.size());
    act.score = guess.probability + bonus_of(act, context);
    if (act.score >= threshold)
      acts.push_back(std::move(act));
  }
  std::ranges::stable_sort(acts, std::greater(), &BuiltAct::score);
  std::erase_if(acts, [&](const BuiltAct& act) {
    return act.score < acts.front().score - alternative_range;
  });
  return acts;
}

bool leaves_open(const std::vector<BuiltAct>& acts) {
  return acts.empty() ||
         (acts.size() == 1 && acts[0].topic != no_topic &&
          (acts[0].elliptical || acts[0].score < well_understood));
}

bool prefer_better(std::vector<BuiltAct>& acts, const BuiltAct& guess,
                   const Context& context) {
  const bool better =
      acts.empty() || (acts[0].elliptical && acts[0].score < guess.score);
  if (acts.empty() || (better && acts[0].topic != guess.topic)) {
    acts = {guess};
    return true;
  }
  if (acts[0].topic != guess.topic || acts[0].act == "deny")
    return false;
  for (const auto& fill : guess.fills)
    if (may_add(acts[0].fills, fill))
      acts[0].fills.push_back(fill);
  // A value that several topics may take, in a sentence of this one.
  const bool sentence =
      better && acts[0].act == guess.act && context.bonus(guess.topic) == 0;
  if (sentence) {
    acts[0].score = guess.score;
    acts[0].elliptical = false;
  }
  return sentence;
}

} // namespace parlour::adapters::nlu
