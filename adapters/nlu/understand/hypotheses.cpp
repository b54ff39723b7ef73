#include "adapters/nlu/understand/hypotheses.hpp"

#include <algorithm>

#include "adapters/nlu/text/negation.hpp"

namespace parlour::adapters::nlu {

namespace {

// From this score on, grammars need no hypothesis.
constexpr double well_understood = 0.9;
// How close to the best score an alternative is.
constexpr double alternative_range = 0.1;
// For how many topics slots are looked for: the context may prefer one that is
// not the most likely.
constexpr std::size_t max_topics = 4;

// Whether the fill uses one of these tokens.
bool overlap(const Fill& fill, std::uint32_t begin, std::uint32_t end) {
  return fill.begin < end && begin < fill.end;
}

// A slot is filled once, and a word fills one slot.
bool may_add(const std::vector<Fill>& fills, const Fill& more) {
  return std::ranges::none_of(fills, [&](const Fill& fill) {
    return fill.slot == more.slot || overlap(fill, more.begin, more.end);
  });
}

// Finds the values of the slots of one topic.
class SlotFiller {
public:
  SlotFiller(const Utterance& utterance, Spans& spans, const Schema& schema,
             TopicNumber topic)
      : utterance_(utterance), spans_(spans), schema_(schema), topic_(topic) {}

  // What was learnt comes first; then values that are certain fill slots that
  // are still free.
  std::vector<Fill> run(const std::vector<SlotHypothesis>& hypotheses) {
    for (const auto& hypothesis : hypotheses)
      add_hypothesis(hypothesis);
    for (const auto& slot : schema_.at(topic_).slots)
      if (slot.entity != words_entity)
        add_certain(slot);
    // In the order of the utterance.
    std::ranges::stable_sort(fills_, {}, &Fill::begin);
    return std::move(fills_);
  }

private:
  void add_hypothesis(const SlotHypothesis& hypothesis) {
    const auto* slot = schema_.at(topic_).find(hypothesis.slot);
    if (!slot)
      return;
    if (slot->entity == words_entity)
      add({slot->name, topic_, {}, {}, hypothesis.begin, hypothesis.end});
    else if (const auto span = span_of(slot->entity, hypothesis))
      add(slot->name, *span);
  }

  // The longest value that begins in these words. If there is none, the words
  // of a set count as a value that it does not have.
  std::optional<std::uint32_t> span_of(EntityId entity,
                                       const SlotHypothesis& hypothesis) {
    std::optional<std::uint32_t> best;
    for (auto at = hypothesis.begin; at < hypothesis.end; ++at)
      for (const auto index : spans_.at(entity, at))
        if (!best || spans_[index].end > spans_[*best].end)
          best = index;
    if (best || is_form(entity))
      return best;
    for (const auto index : spans_.open(entity, hypothesis.begin,
                                        hypothesis.end - hypothesis.begin))
      if (spans_[index].end == hypothesis.end)
        return index;
    return {};
  }

  // A value that is clearly meant fills its slot, even if the examples do not
  // say so.
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

// The largest bonus that an act about the topic can get.
double max_bonus(TopicNumber topic, const Context& context) {
  return context.bonus(topic) +
         (topic == context.asked_topic ? asked_bonus : 0);
}

// As for acts of grammars (acts.cpp).
double bonus_of(const BuiltAct& act, const Context& context) {
  const bool asked = act.topic == context.asked_topic &&
                     std::ranges::find(act.fills, context.asked_slot,
                                       &Fill::slot) != act.fills.end();
  return context.bonus(act.topic) + (asked ? asked_bonus : 0);
}

// Whether the utterance has only function words and fillers.
bool means_nothing(const Utterance& utterance) {
  for (std::size_t at = 0; at < utterance.size(); ++at)
    if (!utterance.function[at] && !utterance.filler[at])
      return false;
  return true;
}

// The answer to a negated order.
BuiltAct refusal(const Utterance& utterance, double score) {
  BuiltAct act;
  act.act = "deny";
  act.negated = true;
  act.end = static_cast<std::uint32_t>(utterance.size());
  act.score = score;
  return act;
}

} // namespace

std::vector<BuiltAct> hypothesised_acts(const TrainedModel& learned,
                                        const Utterance& utterance,
                                        Spans& spans, const Schema& schema,
                                        const Context& context,
                                        double threshold) {
  std::vector<BuiltAct> acts;
  if (learned.empty() || means_nothing(utterance))
    return acts;
  const auto words = learning_words(utterance, spans);
  auto topics = learned.topics(words);
  topics.resize(std::min(topics.size(), max_topics));
  std::vector<std::vector<Feature>> features;
  for (const auto& hypothesis : topics) {
    // Topics that cannot reach the threshold are skipped before the slots,
    // which are the expensive part, are looked for.
    if (hypothesis.probability + max_bonus(hypothesis.topic, context) <
        threshold)
      continue;
    if (features.empty())
      features = word_features(words);
    BuiltAct act;
    // A negated order is a refusal, whatever it is about.
    if (is_negated_order(utterance.tokens, utterance.negates))
      return {refusal(utterance, hypothesis.probability)};
    act.act = schema.at(hypothesis.topic).enquiry ? "request" : "inform";
    act.topic = hypothesis.topic;
    act.fills = SlotFiller(utterance, spans, schema, hypothesis.topic)
                    .run(learned.slots(hypothesis.topic, features));
    act.end = static_cast<std::uint32_t>(utterance.size());
    act.score = hypothesis.probability + bonus_of(act, context);
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

bool prefer_better(std::vector<BuiltAct>& acts, const BuiltAct& hypothesis,
                   const Context& context) {
  const bool better =
      acts.empty() || (acts[0].elliptical && acts[0].score < hypothesis.score);
  if (acts.empty() || (better && acts[0].topic != hypothesis.topic)) {
    acts = {hypothesis};
    return true;
  }
  if (acts[0].topic != hypothesis.topic || acts[0].act == "deny")
    return false;
  for (const auto& fill : hypothesis.fills)
    if (may_add(acts[0].fills, fill))
      acts[0].fills.push_back(fill);
  // Several topics take this value, but the whole sentence is about this one:
  // the act is no longer elliptical.
  const bool sentence = better && acts[0].act == hypothesis.act &&
                        context.bonus(hypothesis.topic) == 0;
  if (sentence) {
    acts[0].score = hypothesis.score;
    acts[0].elliptical = false;
  }
  return sentence;
}

} // namespace parlour::adapters::nlu
