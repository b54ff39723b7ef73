#include "adapters/nlu/keywords/keyword_matcher.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

// The words of a slot that takes any.
constexpr std::size_t max_words = 5;
// How many words may stand between a word and the value after it: "to the
// airport".
constexpr std::size_t max_between = 2;
// The confidence of what is understood only because it was expected.
constexpr double when_expected = 0.8;

struct Range {
  // Tokens [begin, end).
  std::size_t begin = 0;
  std::size_t end = 0;
};

// A rule of which a keyword was said, and where.
struct Said {
  const KeywordRule* rule = nullptr;
  Range keyword;
};

// One search of one text.
class Search {
public:
  Search(const KeywordRules& rules, const std::string& text,
         const Value& context)
      : rules_(rules), text_(text), tokens_(tokenize(text)),
        context_(read_context(context, rules.schema)) {}

  // Rules about topics first. Without any, the context decides, unless a
  // question wants a clear yes or no. A generic act comes last.
  std::vector<Value> run() {
    find_rules();
    matches_ = rules_.schema.values().find(tokens_, plain_);
    std::vector<Value> acts;
    for (const auto& said : said_)
      if (said.rule->topic != no_topic)
        acts.push_back(
            act(said.rule->topic, said.rule->act, slots(*said.rule), false));
    const bool answers =
        is_answer(plain_act()) && !context_.confirms.empty() && !leaves_words();
    if (acts.empty() && !answers)
      go_on(acts);
    if (acts.empty() && !plain_act().empty())
      acts.push_back(act(no_topic, plain_act(), {}, false));
    return acts;
  }

private:
  // -- keywords ---------------------------------------------------------------

  // Of several rules about the same topic the first one counts.
  void find_rules() {
    plain_.assign(tokens_.list.size(), false);
    for (const auto& rule : rules_.rules)
      if (const auto keyword = first_of(rule.keywords);
          keyword && !has(rule.topic))
        said_.push_back({&rule, *keyword});
    std::ranges::stable_sort(said_, {},
                             [](const Said& one) { return one.keyword.begin; });
    for (const auto& said : said_)
      for (auto at = said.keyword.begin; at < said.keyword.end; ++at)
        plain_[at] = true;
  }

  bool has(TopicNumber topic) const {
    return topic != no_topic &&
           std::ranges::any_of(said_, [&](const Said& one) {
             return one.rule->topic == topic;
           });
  }

  // The first of the keywords in the text.
  std::optional<Range> first_of(const std::vector<Words>& keywords) const {
    std::optional<Range> first;
    for (const auto& words : keywords)
      if (const auto found = find(words))
        if (!first || found->begin < first->begin)
          first = found;
    return first;
  }

  // The first place where the words follow each other.
  std::optional<Range> find(const Words& words) const {
    const auto& list = tokens_.list;
    const auto found = std::search(
        list.begin(), list.end(), words.begin(), words.end(),
        [](const auto& token, const auto& word) { return token.word == word; });
    if (found == list.end() || words.empty())
      return {};
    const auto begin = static_cast<std::size_t>(found - list.begin());
    return Range{begin, begin + words.size()};
  }

  // -- yes and no -------------------------------------------------------------

  static bool is_answer(std::string_view act) {
    return act == "confirm" || act == "deny";
  }

  bool says(std::string_view act) const {
    return std::ranges::any_of(
        said_, [&](const Said& one) { return one.rule->act == act; });
  }

  // The generic act that was said; empty if there is none or it is in doubt. A
  // yes counts only if nothing else is said (adapters/nlu/acts/doubt.hpp); any
  // other wish goes before it.
  std::string plain_act() const {
    const auto wish = std::ranges::find_if(said_, [](const Said& one) {
      return !is_answer(one.rule->act) && one.rule->act != "greet" &&
             one.rule->act != "thank";
    });
    if (wish != said_.end())
      return wish->rule->act;
    if (says("confirm"))
      return says("deny") || leaves_words() ? "" : "confirm";
    return said_.empty() ? "" : said_.front().rule->act;
  }

  // Whether there are words besides the keywords, the fillers and the words of
  // the question.
  bool leaves_words() const {
    for (std::size_t at = 0; at < tokens_.list.size(); ++at) {
      const auto& word = tokens_.list[at].word;
      const bool means_nothing =
          is_function_word(word) ||
          std::ranges::find(filler_phrases(), word) != filler_phrases().end() ||
          std::ranges::find(context_.confirms, word) != context_.confirms.end();
      if (!plain_[at] && (is_turning_word(word) || !means_nothing))
        return true;
    }
    return false;
  }

  // -- slots ------------------------------------------------------------------

  // The slots of a rule that can be filled.
  Map slots(const KeywordRule& rule) const {
    Map map;
    for (const auto& slot : rule.slots)
      if (auto fill = fill_of(slot))
        map.set(slot.name, std::move(*fill));
    return map;
  }

  // The rule's own value; or a value anywhere in the text; or what follows
  // certain words.
  std::optional<Value> fill_of(const KeywordSlot& slot) const {
    if (slot.value)
      return Value(*slot.value);
    if (slot.after.empty())
      return found_between({0, tokens_.list.size()}, slot.entity, false);
    const auto before = find(slot.after);
    if (!before)
      return {};
    if (slot.entity == words_entity)
      return words_from(before->end);
    const Range near{before->end, before->end + max_between + 1};
    return found_between(near, slot.entity, true);
  }

  // A value of the entity that begins in the range.
  std::optional<Value> found_between(Range range, EntityId entity,
                                     bool expected) const {
    if (is_set(entity))
      return value_of_set(range, entity - first_set_entity);
    if (!is_form(entity))
      return {};
    const auto end = std::min(range.end, tokens_.list.size());
    for (auto at = range.begin; at < end; ++at)
      if (const auto form =
              form_at(static_cast<Form>(entity), tokens_, at, context_.now);
          form && (expected || !form->weak))
        return fill(form->value, 1, {at, at + form->length});
    return {};
  }

  // The best match of the set. Values that fit equally well become candidates.
  std::optional<Value> value_of_set(Range range, SetId set) const {
    const ValueMatch* best = nullptr;
    for (const auto& match : matches_)
      if (match.set == set && match.begin >= range.begin &&
          match.begin < range.end &&
          (!best || match.confidence > best->confidence))
        best = &match;
    if (!best)
      return {};
    List values;
    for (const auto value : best->values)
      values.push_back(rules_.schema.values().value(set, value));
    const Range place{best->begin, best->end};
    if (values.size() == 1)
      return fill(values.front(), best->confidence, place);
    auto candidates = fill({}, best->confidence, place);
    candidates.set(act_key::candidates, std::move(values));
    return Value(std::move(candidates));
  }

  // The words up to a comma, the end of the sentence, or a keyword.
  std::optional<Value> words_from(std::size_t begin) const {
    auto end = begin;
    while (end < tokens_.list.size() && end - begin < max_words &&
           !plain_[end] &&
           (end == begin || tokens_.list[end].before == Break::none))
      ++end;
    if (end == begin)
      return {};
    return fill(text_of({begin, end}), 1, {begin, end});
  }

  Map fill(Value value, double confidence, Range place) const {
    return Map{{act_key::value, std::move(value)},
               {act_key::confidence, confidence},
               {act_key::text, text_of(place)}};
  }

  std::string text_of(Range range) const {
    return std::string(words_of(text_, tokens_, range.begin, range.end));
  }

  // -- without a topic's keyword ----------------------------------------------

  // Takes values to be about the topic that the context expects.
  void go_on(std::vector<Value>& acts) const {
    for (const auto topic :
         {context_.asked_topic, context_.current, context_.resting})
      if (topic != no_topic && acts.empty())
        if (auto slots = expected_slots(topic); !slots.empty())
          acts.push_back(act(topic, rules_.schema.at(topic).usual_act(),
                             std::move(slots), true));
  }

  // Values for the slots of a topic that the context expects. A text without
  // any keyword may be the value of the open slot that was asked for.
  Map expected_slots(TopicNumber topic) const {
    const auto& known = rules_.schema.at(topic);
    const auto asked = [&](const Schema::Slot& slot) {
      return topic == context_.asked_topic && slot.name == context_.asked_slot;
    };
    const Range everywhere{0, tokens_.list.size()};
    Map slots;
    const bool answers = is_answer(plain_act()) && !leaves_words();
    for (const auto& slot : known.slots)
      // "yes" is a value only of the slot that was asked for.
      if (answers && !asked(slot))
        continue;
      else if (auto found = found_between(everywhere, slot.entity, asked(slot)))
        slots.set(slot.name, std::move(*found));
    if (!slots.empty() || !said_.empty() || tokens_.list.empty())
      return slots;
    for (const auto& slot : known.slots)
      if (asked(slot) && slot.entity == words_entity)
        slots.set(slot.name, fill(text_, 1, everywhere));
    return slots;
  }

  // An act as FrameInfo carries it. One without a keyword is elliptical and
  // less certain.
  Value act(TopicNumber topic, const std::string& act, Map slots,
            bool elliptical) const {
    return Map{{act_key::topic, topic == no_topic
                                    ? Value()
                                    : Value(rules_.schema.at(topic).name)},
               {act_key::act, act},
               {act_key::confidence, elliptical ? when_expected : 1.0},
               {act_key::slots, std::move(slots)},
               {act_key::text, text_},
               {act_key::elliptical, elliptical}};
  }

  const KeywordRules& rules_;
  const std::string& text_;
  const Tokens tokens_;
  const Context context_;
  std::vector<Said> said_;
  // The tokens that belong to a keyword.
  std::vector<bool> plain_;
  std::vector<ValueMatch> matches_;
};

} // namespace

std::vector<Value> KeywordMatcher::understand(const std::string& text,
                                              const Value& context) const {
  return Search(rules_, text, context).run();
}

} // namespace parlour::adapters::nlu
