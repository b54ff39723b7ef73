#include "adapters/nlu/acts/acts.hpp"

#include <algorithm>

#include "adapters/nlu/acts/act_scores.hpp"
#include "adapters/nlu/acts/asides.hpp"
#include "adapters/nlu/acts/courtesies.hpp"
#include "adapters/nlu/acts/denied_values.hpp"
#include "adapters/nlu/acts/doubt.hpp"

namespace parlour::adapters::nlu {

namespace {

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
  // Some of several values are not wanted, up to this token; 0: none.
  std::uint32_t without = 0;
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
    add_held();
    drop_negated();
    drop_doubtful(acts_, chain, utterance_, context_);
    drop_courtesies();
    drop_needless_yes();
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

  // In "no, wait, the bedroom", nobody is to wait.
  void add_other(const Island& island) {
    if (marker_ && island.act == "wait") {
      wait_ = &island;
      return;
    }
    close();
    add_held();
    add_generic(island);
  }

  // A marker that nothing followed is an act of its own.
  void add_held() {
    for (const auto* held :
         {std::exchange(marker_, nullptr), std::exchange(wait_, nullptr)})
      if (held)
        add_generic(*held);
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
    // In "And I was late. Where is the bank?", "and" leads to no bank.
    if (lead_in_ && is_before_sentence(*lead_in_, island, utterance_.tokens))
      lead_in_ = nullptr;
    // Nobody is to wait in "no, wait, make it four".
    const bool waits = wait_ && !island.act.empty() && island.act != "correct";
    if (waits || (marker_ && ends_sentence(utterance_, *marker_))) {
      close();
      add_held();
    }
    const auto without = end_of_unwanted(link);
    if (!open_ || is_negated(link) != group_.negated || !continues(link))
      begin_group(link);
    group_.without = std::max(group_.without, without);
    if (!island.act.empty() && group_.act.empty())
      group_.act = island.act;
    group_.only_bare = group_.only_bare && is_value(island);
    const bool denied =
        without == 0 &&
        (denies(island) ||
         (is_value(island) && utterance_.is_negated(island.begin)));
    for (const auto& fill : island.fills) {
      auto& fills =
          denied || fill.begin < without ? group_.denied : group_.fills;
      if (!adds_to(fills, island, fill))
        put(fills, fill, link.topic);
    }
    group_.end = island.end;
    marker_ = nullptr;
    wait_ = nullptr;
    lead_in_ = nullptr;
  }

  static bool is_value(const Island& island) {
    return island.rule->bare || island.asked;
  }

  // "I am Anouk, Windmolen Energy": who is asked for any words has said them
  // first; what follows is something else, unless it corrects them.
  bool adds_to(const std::vector<Fill>& fills, const Island& island,
               const Fill& fill) const {
    const auto* const said = find(fills, fill.slot);
    return island.asked && fill.open && said && said->open && !marker_;
  }

  // "not the blue one". In "not Orchard Road, take me to Tampines", what is not
  // wanted is something that nothing has understood.
  bool denies(const Island& island) const {
    return marker_ && marker_->denies &&
           utterance_.weight_of(marker_->end, island.begin) < full_weight;
  }

  // Behind the values that are not wanted, of a slot with several: "no towels,
  // one more pillow", "we need no towels, only a pillow". 0: there are none.
  std::uint32_t end_of_unwanted(const ChainLink& link) const {
    const auto& island = *link.island;
    if (island.fills.empty() ||
        !schema_.at(link.topic).takes_many(island.fills[0].slot))
      return 0;
    if (denies(island) ||
        (marker_ && denies_first_value(utterance_, *marker_, island)))
      return end_of_denied(utterance_, island);
    if (is_value(island) || !utterance_.is_negated(island.begin))
      return 0;
    const auto end = end_of_denied(utterance_, island);
    return end < island.fills.back().begin ? end : 0;
  }

  // A negated order. A denied value ("not the blue one") is something else.
  bool is_negated(const ChainLink& link) const {
    const auto& island = *link.island;
    const bool names_value =
        is_value(island) || (denies(island) && !island.fills.empty());
    return !names_value && utterance_.is_negated(island.begin) &&
           end_of_unwanted(link) == 0;
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
      return find(group_.fills, fill.slot) != nullptr &&
             !schema_.at(link.topic).takes_many(fill.slot);
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
    group_.negated = is_negated(link);
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

  // A slot with several values takes each of them.
  void put(std::vector<Fill>& fills, const Fill& fill,
           TopicNumber topic) const {
    const bool many =
        topic != no_topic && schema_.at(topic).takes_many(fill.slot);
    const auto same =
        many ? fills.end() : std::ranges::find(fills, fill.slot, &Fill::slot);
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
    if (group_.without > 0 && !group_.fills.empty())
      take_out_denied(act);
    act.act = act_of_group();
    act.is_declared = !group_.act.empty();
    act.fills = group_.fills.empty() ? group_.denied : group_.fills;
    act.elliptical = is_elliptical();
    act.is_aside = group_.only_bare && !group_.leads_in &&
                   act.act != "correct" && act.act != "deny";
    acts_.push_back(std::move(act));
  }

  // What is not wanted is an act of its own; the others replace nothing.
  void take_out_denied(BuiltAct& others) {
    auto act = others;
    act.act = "deny";
    act.fills = std::exchange(group_.denied, {});
    act.end = others.begin = group_.without;
    acts_.push_back(std::move(act));
    group_.corrects = false;
  }

  // Denied values without others make a "deny", with others a "correct".
  std::string act_of_group() const {
    if (group_.fills.empty() && !group_.denied.empty())
      return "deny";
    if (!group_.fills.empty() && (group_.corrects || !group_.denied.empty()))
      return "correct";
    if (!group_.act.empty())
      return group_.act;
    return schema_.at(group_.topic).usual_act();
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

  // "Yes, with a wheelchair", to a question that no yes answers.
  void drop_needless_yes() {
    const bool answers = context_.confirms.empty() &&
                         context_.asked_topic != no_topic &&
                         std::ranges::any_of(acts_, [&](const BuiltAct& act) {
                           return act.topic == context_.asked_topic &&
                                  find(act.fills, context_.asked_slot);
                         });
    if (answers)
      std::erase_if(acts_, [](const BuiltAct& act) {
        return act.topic == no_topic && act.act == "confirm";
      });
  }

  void drop_courtesies() {
    // In "sorry, what did you say", "sorry" corrects nothing.
    if (acts_.size() > 1)
      std::erase_if(acts_, [](const BuiltAct& act) {
        return act.topic == no_topic && act.act == "correct";
      });
    const auto is_polite = [](const BuiltAct& act) {
      return act.topic == no_topic && is_courtesy(act.act);
    };
    if (!std::ranges::all_of(acts_, is_polite))
      std::erase_if(acts_, is_polite);
    // Who wants something has not gone yet: "I am off. Lights out. See you."
    // Nor has who says "okay" to nothing in particular answered.
    const bool wants_something =
        std::ranges::any_of(acts_, [](const BuiltAct& act) {
          return act.topic != no_topic && !act.negated;
        });
    if (wants_something)
      std::erase_if(acts_, [&](const BuiltAct& act) {
        return act.topic == no_topic &&
               (act.act == "bye" ||
                is_opening(act.act, act.begin, utterance_, context_));
      });
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
  // Behind the marker.
  const Island* wait_ = nullptr;
  const Island* lead_in_ = nullptr;
};

// Whether rules fill the same slots with the same.
bool says_same(const BuiltAct& left, const BuiltAct& right) {
  return left.topic != no_topic && left.topic == right.topic &&
         left.act == right.act && !left.fills.empty() &&
         std::ranges::equal(
             left.fills, right.fills, [](const Fill& one, const Fill& other) {
               return one.slot == other.slot && one.literal && other.literal &&
                      *one.literal == *other.literal;
             });
}

} // namespace

std::vector<BuiltAct> build_acts(const Chain& chain, const Utterance& utterance,
                                 const Schema& schema, const Context& context,
                                 double threshold) {
  auto acts = ActBuilder(schema, utterance, context).run(chain);
  set_scores(acts, chain, utterance, context);
  std::erase_if(acts,
                [&](const BuiltAct& act) { return act.score < threshold; });
  drop_asides(acts, utterance, context);
  // What is said twice in one breath is done once.
  acts.erase(std::unique(acts.begin(), acts.end(), says_same), acts.end());
  return acts;
}

} // namespace parlour::adapters::nlu
