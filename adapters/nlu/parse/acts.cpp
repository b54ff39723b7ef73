#include "adapters/nlu/parse/acts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "adapters/nlu/parse/doubt.hpp"

namespace parlour::adapters::nlu {

namespace {

// Generic acts that are only politeness if something else is said.
constexpr std::array<std::string_view, 7> courtesies{
    "greet", "thank", "help", "repeat", "explain", "options", "rephrase"};

const Fill* find(const std::vector<Fill>& fills, std::string_view slot) {
  const auto found = std::ranges::find(fills, slot, &Fill::slot);
  return found == fills.end() ? nullptr : &*found;
}

// The islands that become one act.
struct Group {
  TopicNumber topic = no_topic;
  std::string act; // as rules say it
  std::vector<Fill> fills;
  std::vector<Fill> denied;
  // Began with "no"; with "do not …"; with "how about".
  bool corrects = false;
  bool negated = false;
  bool leads_in = false;
  bool only_bare = true;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

// Goes through the chain once. Islands are added to the open group as long as
// they continue it; markers ("no, I mean") and words that lead in ("how about",
// "and") are kept for the island that follows.
class ActBuilder {
public:
  ActBuilder(const Schema& schema, const Utterance& utterance,
             const Context& context)
      : schema_(schema), utterance_(utterance), context_(context) {}

  std::vector<BuiltAct> run(const Chain& chain) {
    for (const auto& link : chain.links)
      add(link);
    close();
    if (marker_)
      add_generic(*marker_);
    drop_negated();
    drop_doubtful(acts_, chain, utterance_, context_);
    drop_courtesies();
    return std::move(acts_);
  }

private:
  void add(const ChainLink& link) {
    const auto& island = *link.island;
    if (island.is_content())
      add_content(link);
    else if (island.is_marker())
      add_marker(island);
    else if (island.act.empty())
      lead_in_ = &island;
    else
      add_other(island);
  }

  // Of several markers the last counts, but a denial stays. A "not" that
  // negates nothing is no denial: "I cannot find a bank".
  void add_marker(const Island& island) {
    if (island.denies && island.end - island.begin == 1 &&
        !utterance_.negates[island.begin])
      return;
    if (!marker_ || island.denies || !marker_->denies)
      marker_ = &island;
  }

  void add_other(const Island& island) {
    close();
    if (marker_)
      add_generic(*std::exchange(marker_, nullptr));
    add_generic(island);
  }

  void add_generic(const Island& island) {
    BuiltAct act;
    act.act = island.act;
    act.begin = island.begin;
    act.end = island.end;
    acts_.push_back(std::move(act));
  }

  // Opens a group, or adds to the open one. A later value of a slot replaces an
  // earlier one.
  void add_content(const ChainLink& link) {
    const auto& island = *link.island;
    if (!open_ || is_negated(island) != group_.negated || !continues(link))
      begin_group(link);
    if (!island.act.empty() && group_.act.empty())
      group_.act = island.act;
    group_.only_bare = group_.only_bare && is_value(island);
    const bool denied =
        denies() || (is_value(island) && utterance_.is_negated(island.begin));
    auto& fills = denied ? group_.denied : group_.fills;
    for (const auto& fill : island.fills)
      put(fills, fill);
    group_.end = island.end;
    marker_ = nullptr;
    lead_in_ = nullptr;
  }

  static bool is_value(const Island& island) {
    return island.rule->bare || island.asked;
  }

  // "not the blue one"
  bool denies() const {
    return marker_ && marker_->denies;
  }

  // A negated order. A denied value ("not the blue one") is something else.
  bool is_negated(const Island& island) const {
    const bool names_value =
        is_value(island) || (denies() && !island.fills.empty());
    return !names_value && utterance_.is_negated(island.begin);
  }

  // Whether the island says more of what the group says. Repeating a slot
  // begins a new act if the island has an act of its own or the topic is an
  // enquiry.
  bool continues(const ChainLink& link) const {
    const auto& island = *link.island;
    if (link.topic != group_.topic || asks_further())
      return false;
    if (marker_ || island.rule->bare)
      return true;
    const bool again = std::ranges::any_of(island.fills, [&](const Fill& fill) {
      return find(group_.fills, fill.slot) != nullptr;
    });
    return !(again && (!island.act.empty() || is_enquiry()));
  }

  // "… and a bank?" is another question.
  bool asks_further() const {
    return lead_in_ && !marker_ && is_enquiry();
  }

  // Enquiries can be repeated: "… and in the bedroom".
  bool is_enquiry() const {
    return schema_.at(group_.topic).enquiry;
  }

  // A marker makes the act a correction, unless the topic changes or the island
  // asks something; then it is an answer of its own ("no. where is …").
  void begin_group(const ChainLink& link) {
    close();
    group_ = {};
    group_.topic = link.topic;
    group_.negated = is_negated(*link.island);
    group_.corrects =
        marker_ && !changes_topic(link.topic) && link.island->act != "request";
    if (marker_ && link.island->act == "request" && acts_.empty() &&
        !group_.negated)
      add_generic(*std::exchange(marker_, nullptr));
    group_.leads_in = lead_in_ != nullptr;
    group_.begin = marker_    ? marker_->begin
                   : lead_in_ ? lead_in_->begin
                              : link.island->begin;
    open_ = true;
  }

  // "…, no, I want a taxi" corrects nothing about the taxi.
  bool changes_topic(TopicNumber topic) const {
    return !acts_.empty() && acts_.back().topic != no_topic &&
           acts_.back().topic != topic;
  }

  static void put(std::vector<Fill>& fills, const Fill& fill) {
    const auto same = std::ranges::find(fills, fill.slot, &Fill::slot);
    if (same == fills.end())
      fills.push_back(fill);
    else
      *same = fill;
  }

  // Turns the group into an act. A negated order becomes a plain "deny".
  void close() {
    if (!open_)
      return;
    open_ = false;
    BuiltAct act;
    act.negated = group_.negated;
    act.begin = group_.begin;
    act.end = group_.end;
    if (group_.negated) {
      act.act = "deny";
      acts_.push_back(std::move(act));
      return;
    }
    act.topic = group_.topic;
    act.act = act_of_group();
    act.fills = group_.fills.empty() ? group_.denied : group_.fills;
    act.elliptical = is_elliptical();
    acts_.push_back(std::move(act));
  }

  // Denied values without others make a "deny", with others a "correct".
  std::string act_of_group() const {
    if (group_.fills.empty() && !group_.denied.empty())
      return "deny";
    if (!group_.fills.empty() && (group_.corrects || !group_.denied.empty()))
      return "correct";
    if (!group_.act.empty())
      return group_.act;
    return schema_.at(group_.topic).enquiry ? "request" : "inform";
  }

  // A value without a sentence around it, or with "how about" before it.
  bool is_elliptical() const {
    if (group_.only_bare)
      return true;
    return group_.act.empty() &&
           (group_.leads_in || schema_.at(group_.topic).enquiry);
  }

  // In "I don't want tea, I want coffee" only the coffee counts.
  void drop_negated() {
    if (std::ranges::any_of(
            acts_, [](const BuiltAct& act) { return act.topic != no_topic; }))
      std::erase_if(acts_, [](const BuiltAct& act) { return act.negated; });
  }

  void drop_courtesies() {
    // In "sorry, what did you say", "sorry" corrects nothing.
    if (acts_.size() > 1)
      std::erase_if(acts_, [](const BuiltAct& act) {
        return act.topic == no_topic && act.act == "correct";
      });
    const auto is_courtesy = [](const BuiltAct& act) {
      return act.topic == no_topic &&
             std::ranges::find(courtesies, act.act) != courtesies.end();
    };
    if (!std::ranges::all_of(acts_, is_courtesy))
      std::erase_if(acts_, is_courtesy);
    // "thank you, thank you" is one act.
    const auto again =
        std::unique(acts_.begin(), acts_.end(),
                    [](const BuiltAct& left, const BuiltAct& right) {
                      return left.topic == no_topic &&
                             right.topic == no_topic && left.act == right.act;
                    });
    acts_.erase(again, acts_.end());
  }

  const Schema& schema_;
  const Utterance& utterance_;
  const Context& context_;
  std::vector<BuiltAct> acts_;
  Group group_;
  bool open_ = false;
  const Island* marker_ = nullptr;
  const Island* lead_in_ = nullptr;
};

// How much of the words of a further value must be understood: "… and in the
// bedroom" is more of the same, "… and close the blinds in the bedroom" is
// something else.
constexpr double further_value = 0.6;

// How much of each token is understood, from 0 to its weight. An island's
// coverage is spread evenly over its tokens.
std::vector<double> coverage(const Chain& chain, std::size_t size) {
  std::vector<double> covered(size, 0);
  for (const auto& link : chain.links) {
    const auto& island = *link.island;
    const auto length = double(island.end - island.begin);
    for (auto at = island.begin; at < island.end; ++at)
      covered[at] = island.covered / length;
  }
  return covered;
}

double bonus_of(const BuiltAct& act, const Context& context) {
  if (act.topic == no_topic)
    return 0;
  const bool asked =
      act.topic == context.asked_topic && find(act.fills, context.asked_slot);
  return context.bonus(act.topic) + (asked ? asked_bonus : 0);
}

bool is_something_else(const BuiltAct& act, const BuiltAct& before,
                       const Context& context) {
  return act.elliptical && act.act != "correct" && act.topic == before.topic &&
         act.score - bonus_of(act, context) < further_value;
}

// An act is scored on the tokens from its begin to the begin of the next one.
void set_scores(std::vector<BuiltAct>& acts, const Chain& chain,
                const Utterance& utterance, const Context& context) {
  const auto covered = coverage(chain, utterance.size());
  for (std::size_t at = 0; at < acts.size(); ++at) {
    const std::size_t first = at == 0 ? 0 : acts[at].begin;
    const auto last =
        at + 1 < acts.size() ? acts[at + 1].begin : utterance.size();
    const auto whole = utterance.weight_of(first, last);
    double sum = 0;
    for (auto token = first; token < last; ++token)
      sum += covered[token];
    acts[at].score = (whole > 0 ? std::min(1.0, sum / whole) : 1.0) +
                     bonus_of(acts[at], context);
  }
}

// Confidences are rounded so that they print well.
double in_thousandths(double confidence) {
  return std::round(confidence * 1000) / 1000;
}

Value fill_value(const Fill& fill, const Utterance& utterance,
                 const Spans& spans, const Schema& schema) {
  const std::string text(
      words_of(utterance.text, utterance.tokens, fill.begin, fill.end));
  Map made{{act_key::value, text}, {act_key::confidence, 1.0}};
  if (fill.literal) {
    made.set(act_key::value, *fill.literal);
  } else if (fill.span) {
    const auto& span = spans[*fill.span];
    made.set(act_key::confidence, in_thousandths(span.confidence));
    if (is_form(span.entity) && !span.unmatched)
      made.set(act_key::value, span.value);
    if (span.unmatched)
      made.set("unmatched", true);
    const auto set = span.entity - first_set_entity;
    List candidates;
    for (const auto value : span.values)
      candidates.push_back(schema.values().value(set, value));
    if (candidates.size() == 1)
      made.set(act_key::value, candidates[0]);
    else if (candidates.size() > 1) {
      made.set(act_key::value, Value());
      made.set(act_key::candidates, std::move(candidates));
    }
  }
  made.set(act_key::text, text);
  return made;
}

} // namespace

std::vector<BuiltAct> build_acts(const Chain& chain, const Utterance& utterance,
                                 const Schema& schema, const Context& context,
                                 double threshold) {
  auto acts = ActBuilder(schema, utterance, context).run(chain);
  set_scores(acts, chain, utterance, context);
  std::vector<BuiltAct> kept;
  for (const auto& act : acts)
    // A further value that is mostly not understood is left out rather than
    // taken for more of the same.
    if (act.score >= threshold &&
        (kept.empty() || !is_something_else(act, kept.back(), context)))
      kept.push_back(act);
  return kept;
}

Map act_value(const BuiltAct& act, const Utterance& utterance,
              const Spans& spans, const Schema& schema) {
  Map slots;
  for (const auto& fill : act.fills)
    slots.set(fill.slot, fill_value(fill, utterance, spans, schema));
  const auto topic =
      act.topic == no_topic ? Value() : Value(schema.at(act.topic).name);
  return Map{{act_key::topic, topic},
             {act_key::act, act.act},
             {act_key::confidence, in_thousandths(std::min(1.0, act.score))},
             {act_key::slots, std::move(slots)},
             {act_key::text,
              words_of(utterance.text, utterance.tokens, act.begin, act.end)},
             {act_key::elliptical, act.elliptical}};
}

} // namespace parlour::adapters::nlu
