#include "adapters/nlu/understand/hypotheses.hpp"

#include <algorithm>

#include "adapters/nlu/parse/open_words.hpp"
#include "adapters/nlu/text/negation.hpp"

namespace parlour::adapters::nlu {

namespace {

// How close to the best score an alternative is.
constexpr double alternative_range = 0.1;
// What a topic needs above the threshold beside many wordings: at any time,
// while something is asked, and while a yes or no is waited for, to be answered
// and to be begun.
constexpr double among_many = 0.05;
constexpr double beside_a_question = 0.2;
constexpr double answered_beside_a_yes = 0.4;
constexpr double begun_beside_a_yes = 0.5;
// For how many topics slots are looked for, beside those that the context
// prefers.
constexpr std::size_t max_topics = 4;

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
    if (may_fill(fills_, fill, schema_.at(topic_).takes_many(fill.slot)))
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
  bool known = false;   // one of them is a word of grammars or examples
  bool values = false;
  std::size_t small = 0; // function words
};

Makeup makeup_of(const Utterance& utterance,
                 const std::vector<LearningWord>& words) {
  Makeup made;
  for (std::size_t at = 0; at < utterance.size(); ++at) {
    const bool is_value = words[at].kind != 0;
    if (utterance.function[at]) {
      made.small += is_value ? 0U : 1U;
    } else if (!utterance.filler[at]) {
      (is_value ? made.values : made.content) = true;
      made.known |= utterance.words[at] != unknown_word;
    }
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

// What is said of the topic in the place of what it is for. A negated order is
// a refusal, unless such orders are what the topic is about, or a more likely
// one. What a task is for may be called off, and begins nothing then.
std::optional<BuiltAct> turned_round(const Utterance& utterance,
                                     const TopicHypothesis& hypothesis,
                                     double probability, bool is_task) {
  const auto& label = *hypothesis.label;
  if (!label.negates && is_negated_order(utterance.tokens, utterance.negates))
    return refusal(utterance, probability);
  if (!is_task || label.calls_off || !calls_off(utterance.tokens))
    return {};
  BuiltAct act;
  act.act = "cancel";
  act.topic = hypothesis.topic;
  act.end = static_cast<std::uint32_t>(utterance.size());
  act.score = probability;
  return act;
}

// Instead of what was found for these slots.
void add_constants(
    BuiltAct& act,
    const std::vector<std::pair<std::string, Value>>& constants) {
  for (const auto& constant : constants) {
    std::erase_if(act.fills, [&](const Fill& fill) {
      return fill.slot == constant.first;
    });
    act.fills.push_back(
        {constant.first, act.topic, {}, constant.second, act.begin, act.end});
  }
}

// Whether it has what all of its wordings say. Small words alone give no
// constant: "make sure that one is off".
bool says_enough(const BuiltAct& act, const LessonLabel& label,
                 const Makeup& makeup) {
  const bool says_value = act.fills.size() > label.constants.size();
  return (makeup.content || says_value || label.constants.empty()) &&
         std::ranges::all_of(label.needs, [&](const std::string& slot) {
           return std::ranges::find(act.fills, slot, &Fill::slot) !=
                  act.fills.end();
         });
}

// What a topic needs above the threshold beside many wordings. One that nobody
// has spoken of needs more while a question waits, and all but the one that is
// asked about need most where a yes or no does.
double doubt_of(TopicNumber topic, const Schema& schema,
                const TrainedModel& learned, const Context& context) {
  if (!learned.is_well_taught())
    return 0;
  if (!context.confirms.empty() && topic != context.asked_topic)
    return schema.at(topic).enquiry ? answered_beside_a_yes
                                    : begun_beside_a_yes;
  const bool is_new = !context.expects(topic);
  return is_new && context.asked_topic != no_topic ? beside_a_question
                                                   : among_many;
}

} // namespace

bool may_fill(const std::vector<Fill>& fills, const Fill& more, bool many) {
  return std::ranges::none_of(fills, [&](const Fill& fill) {
    return (fill.slot == more.slot && !many) ||
           (fill.begin < more.end && more.begin < fill.end);
  });
}

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
    const auto& constants = hypothesis.label->constants;
    if (at >= max_topics && !context.expects(hypothesis.topic))
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
    if (auto other =
            turned_round(utterance, hypothesis, probability, !topic.enquiry)) {
      if (acts.empty())
        return {std::move(*other)};
      continue;
    }
    act.act = topic.usual_act();
    act.topic = hypothesis.topic;
    act.fills = SlotFiller(utterance, spans, schema, hypothesis.topic)
                    .run(learned.slots(hypothesis.topic, features));
    act.end = static_cast<std::uint32_t>(utterance.size());
    add_constants(act, constants);
    // "Do you sell food?" does not go on with the opening hours.
    const bool may_go_on =
        makeup.known || !act.fills.empty() || learned.is_well_taught();
    act.score = probability + (may_go_on ? bonus_of(act, context) : 0);
    const bool is_new = !context.expects(hypothesis.topic);
    const bool begins = learned.is_beside_grammars() && !topic.enquiry &&
                        act.fills.size() == constants.size() && is_new;
    if (says_enough(act, *hypothesis.label, makeup) &&
        act.score >=
            threshold + std::max(begins ? task_without_values : 0,
                                 doubt_of(act.topic, schema, learned, context)))
      acts.push_back(std::move(act));
  }
  keep_best(acts);
  return acts;
}

void keep_best(std::vector<BuiltAct>& acts) {
  std::ranges::stable_sort(acts, std::greater(), &BuiltAct::score);
  std::erase_if(acts, [&](const BuiltAct& act) {
    return act.score < acts.front().score - alternative_range ||
           (&act != &acts.front() && act.topic == acts.front().topic);
  });
}

std::vector<Fill> certain_fills(const Utterance& utterance, Spans& spans,
                                const Schema& schema, TopicNumber topic) {
  return SlotFiller(utterance, spans, schema, topic).run({});
}

} // namespace parlour::adapters::nlu
