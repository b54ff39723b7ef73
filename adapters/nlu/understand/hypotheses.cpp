#include "adapters/nlu/understand/hypotheses.hpp"

#include <algorithm>

#include "adapters/nlu/parse/open_words.hpp"
#include "adapters/nlu/text/negation.hpp"

namespace parlour::adapters::nlu {

namespace {

// From this score on, grammars need no hypothesis.
constexpr double well_understood = 0.9;
// How close to the best score an alternative is.
constexpr double alternative_range = 0.1;
// For how many topics slots are looked for, beside those that the context
// prefers.
constexpr std::size_t max_topics = 4;

// Whether the fill uses one of these tokens.
bool overlap(const Fill& fill, std::uint32_t begin, std::uint32_t end) {
  return fill.begin < end && begin < fill.end;
}

// A slot is filled once, but for one with several values; a word fills one
// slot.
bool may_add(const std::vector<Fill>& fills, const Fill& more, bool many) {
  return std::ranges::none_of(fills, [&](const Fill& fill) {
    return (fill.slot == more.slot && !many) ||
           overlap(fill, more.begin, more.end);
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
    if (slot->entity != words_entity) {
      if (const auto span = span_of(slot->entity, hypothesis))
        add(slot->name, *span);
    } else if (!is_value_of_another(hypothesis) &&
               may_be_value(utterance_, {hypothesis.begin, hypothesis.end})) {
      add({slot->name, topic_, {}, {}, hypothesis.begin, hypothesis.end});
    }
  }

  // "the toilet" is the thing that is looked for, not the day of the visit.
  bool is_value_of_another(const SlotHypothesis& words) const {
    return std::ranges::any_of(
        schema_.at(topic_).slots, [&](const Schema::Slot& slot) {
          if (slot.entity == words_entity)
            return false;
          const auto known = spans_.at(slot.entity, words.begin);
          return std::ranges::any_of(known, [&](std::uint32_t index) {
            return !spans_[index].weak && spans_[index].end == words.end &&
                   spans_[index].confidence == 1;
          });
        });
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
    if (may_add(fills_, fill, schema_.at(topic_).takes_many(fill.slot)))
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

// Evidence of known values: the share of the utterance that they are, and which
// topics take all of them.
class ValueEvidence {
public:
  ValueEvidence(const Utterance& utterance,
                const std::vector<LearningWord>& words, const Schema& schema,
                const std::vector<TopicHypothesis>& topics)
      : schema_(schema) {
    double known = 0;
    for (std::size_t at = 0; at < words.size(); ++at)
      if (const auto kind = words[at].kind; kind != 0) {
        known += utterance.weight[at];
        if (std::ranges::find(entities_, kind - 1) == entities_.end())
          entities_.push_back(kind - 1);
      }
    const auto all = utterance.weight_of(0, utterance.size());
    share_ = all > 0 ? known / all : 0;
    for (const auto& one : topics)
      if (takes_all(one.topic))
        rivals_ += one.probability;
  }

  // The probability by examples and values together: either may be right while
  // the other says nothing. Values speak for each topic that takes them, as far
  // as the examples prefer it.
  double joined(const TopicHypothesis& hypothesis) const {
    const auto probability = hypothesis.probability;
    if (share_ == 0 || rivals_ == 0 || !takes_all(hypothesis.topic))
      return probability;
    const auto by_values = share_ * probability / rivals_;
    return 1 - (1 - probability) * (1 - by_values);
  }

private:
  bool takes_all(TopicNumber topic) const {
    const auto& slots = schema_.at(topic).slots;
    return std::ranges::all_of(entities_, [&](EntityId entity) {
      return std::ranges::find(slots, entity, &Schema::Slot::entity) !=
             slots.end();
    });
  }

  const Schema& schema_;
  std::vector<EntityId> entities_;
  double share_ = 0;
  // The probability of all topics that take all values.
  double rivals_ = 0;
};

// What a topic needs that only small words and values speak for.
constexpr double very_likely = 0.9;
constexpr std::size_t least_small_words = 3;

// What an utterance is made of, beside fillers.
struct Makeup {
  bool content = false; // words that may tell a topic
  bool values = false;
  std::size_t small = 0; // function words
};

Makeup makeup_of(const Utterance& utterance,
                 const std::vector<LearningWord>& words) {
  Makeup made;
  for (std::size_t at = 0; at < utterance.size(); ++at) {
    const bool is_value = words[at].kind != 0;
    if (utterance.function[at])
      made.small += is_value ? 0U : 1U;
    else if (!utterance.filler[at])
      (is_value ? made.values : made.content) = true;
  }
  return made;
}

// Without content only a very likely topic counts, and only beside a few small
// words: "what desserts do you have", but not "the kitchen".
bool tells_nothing(const Makeup& makeup) {
  return !makeup.content &&
         (!makeup.values || makeup.small < least_small_words);
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

// Whether the hypothesis has these values, too.
bool has_all(const BuiltAct& hypothesis, const BuiltAct& act) {
  return std::ranges::all_of(act.fills, [&](const Fill& fill) {
    return std::ranges::any_of(hypothesis.fills, [&](const Fill& other) {
      return other.begin <= fill.begin && fill.end <= other.end;
    });
  });
}

// Acts about the conversation for which a part of a sentence about a topic may
// be taken: "repeat the alarm". A yes or no is never replaced.
bool is_replaceable(const BuiltAct& act) {
  return act.topic == no_topic && act.score < well_understood &&
         act.act != "confirm" && act.act != "deny" && act.act != "correct";
}

// A bare value tells no topic by itself. If the conversation does not expect
// it, the words around it decide.
bool is_better(const BuiltAct& act, const BuiltAct& hypothesis,
               const Context& context) {
  // What is broken off is what goes on: "never mind, I can walk".
  const bool breaks_off = act.act == "cancel" || act.act == "abandon";
  if (act.topic == no_topic)
    return is_replaceable(act) && hypothesis.score > act.score &&
           !(breaks_off && max_bonus(hypothesis.topic, context) > 0);
  return act.elliptical && act.act != "correct" &&
         (act.score < hypothesis.score ||
          (max_bonus(act.topic, context) == 0 && has_all(hypothesis, act)));
}

} // namespace

std::vector<BuiltAct> hypothesised_acts(const TrainedModel& learned,
                                        const Utterance& utterance,
                                        Spans& spans, const Schema& schema,
                                        const Context& context,
                                        double threshold) {
  std::vector<BuiltAct> acts;
  if (learned.empty())
    return acts;
  const auto words = learned.words(utterance, spans);
  const auto makeup = makeup_of(utterance, words);
  if (tells_nothing(makeup))
    return acts;
  auto topics = learned.topics(words);
  const ValueEvidence evidence(utterance, words, schema, topics);
  std::vector<std::vector<Feature>> features;
  for (std::size_t at = 0; at < topics.size(); ++at) {
    const auto& hypothesis = topics[at];
    if (at >= max_topics && max_bonus(hypothesis.topic, context) == 0)
      continue;
    // Topics that cannot reach the threshold are skipped before the slots,
    // which are the expensive part, are looked for.
    const auto& topic = schema.at(hypothesis.topic);
    if ((topic.part && !context.goes_on(hypothesis.topic)) ||
        (!makeup.content && hypothesis.probability < very_likely))
      continue;
    const auto probability = evidence.joined(hypothesis);
    if (probability + max_bonus(hypothesis.topic, context) < threshold)
      continue;
    if (features.empty())
      features = word_features(words);
    BuiltAct act;
    // A negated order is a refusal, unless such orders are what the topic is
    // about, or a more likely one.
    if (!hypothesis.negates &&
        is_negated_order(utterance.tokens, utterance.negates)) {
      if (acts.empty())
        return {refusal(utterance, probability)};
      continue;
    }
    act.act = topic.usual_act();
    act.topic = hypothesis.topic;
    act.fills = SlotFiller(utterance, spans, schema, hypothesis.topic)
                    .run(learned.slots(hypothesis.topic, features));
    act.end = static_cast<std::uint32_t>(utterance.size());
    act.score = probability + bonus_of(act, context);
    const bool begins = learned.is_beside_grammars() && !topic.enquiry &&
                        act.fills.empty() &&
                        max_bonus(hypothesis.topic, context) == 0;
    if (act.score >= threshold + (begins ? task_without_values : 0))
      acts.push_back(std::move(act));
  }
  keep_best(acts);
  return acts;
}

void keep_best(std::vector<BuiltAct>& acts) {
  std::ranges::stable_sort(acts, std::greater(), &BuiltAct::score);
  std::erase_if(acts, [&](const BuiltAct& act) {
    return act.score < acts.front().score - alternative_range;
  });
}

std::vector<Fill> certain_fills(const Utterance& utterance, Spans& spans,
                                const Schema& schema, TopicNumber topic) {
  return SlotFiller(utterance, spans, schema, topic).run({});
}

bool leaves_open(const std::vector<BuiltAct>& acts) {
  return acts.empty() ||
         (acts.size() == 1 &&
          (acts[0].topic == no_topic
               ? is_replaceable(acts[0])
               : acts[0].elliptical || acts[0].score < well_understood));
}

bool prefer_better(std::vector<BuiltAct>& acts, const BuiltAct& hypothesis,
                   const Schema& schema, const Context& context) {
  const bool better = acts.empty() || is_better(acts[0], hypothesis, context);
  if (acts.empty() || (better && acts[0].topic != hypothesis.topic)) {
    acts = {hypothesis};
    return true;
  }
  if (acts[0].topic != hypothesis.topic || acts[0].act == "deny")
    return false;
  for (const auto& fill : hypothesis.fills)
    if (may_add(acts[0].fills, fill,
                schema.at(hypothesis.topic).takes_many(fill.slot)))
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
