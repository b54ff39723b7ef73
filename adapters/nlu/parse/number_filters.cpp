#include "adapters/nlu/parse/number_filters.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

#include "adapters/nlu/text/has.hpp"
#include "adapters/nlu/text/word_set.hpp"

namespace parlour::adapters::nlu {

namespace {

// "two hours", "thirty pages"
bool is_unit(std::string_view word) {
  static const WordSet units{
      "second", "seconds", "minute", "minutes", "hour",     "hours", "day",
      "days",   "night",   "nights", "week",    "weeks",    "month", "months",
      "year",   "years",   "people", "persons", "children", "kids",  "adults",
      "guests", "pages",   "times",  "euros",   "dollars",  "cents", "percent"};
  return units.contains(word);
}

// "six of us"
bool is_group(std::string_view word) {
  return is_one_of(word, {"us", "them", "you"});
}

// Names of slots and topics have capital letters.
bool is_same_word(std::string_view word, std::string_view name) {
  return std::ranges::equal(word, name, [](char left, char right) {
    return left == std::tolower(static_cast<unsigned char>(right));
  });
}

} // namespace

void leave_out_counts(std::vector<Island>& islands, const Utterance& utterance,
                      const Spans& spans) {
  const auto is_counted = [&](const Island& island) {
    const auto& tokens = utterance.tokens.list;
    if (island.end >= tokens.size() || island.rule->generic ||
        island.rule->bare || tokens[island.end].before != Break::none ||
        std::ranges::none_of(island.fills, [&](const Fill& fill) {
          return fill.span && fill.end == island.end &&
                 is_form(spans[*fill.span].entity);
        }))
      return false;
    const bool is_part =
        tokens[island.end].word == "of" && island.end + 1 < tokens.size();
    return is_unit(tokens[island.end].word) ||
           (is_part && is_group(tokens[island.end + 1].word));
  };
  std::erase_if(islands, is_counted);
}

void leave_out_small_numbers(std::vector<Island>& islands,
                             const Utterance& utterance, const Spans& spans,
                             const Schema& schema, const Context& context) {
  // "My card number is 305": who says what it is learns that it is wrong.
  const auto is_named = [&](const Island& island, const std::string& slot,
                            const std::string& topic) {
    for (auto token = island.begin; token < island.end; ++token) {
      const auto& word = utterance.tokens.list[token].word;
      if (word == "number" || is_same_word(word, slot) ||
          is_same_word(word, topic))
        return true;
    }
    return false;
  };
  const auto is_small = [&](const Island& island, const Fill& fill,
                            TopicNumber number) {
    const auto& topic = schema.at(number);
    const auto* slot = topic.find(fill.slot);
    const bool is_asked =
        number == context.asked_topic && fill.slot == context.asked_slot;
    return slot && slot->fewest > 0 && !is_asked && fill.span &&
           is_form(spans[*fill.span].entity) &&
           spans[*fill.span].value.integer_or(slot->fewest) < slot->fewest &&
           !is_named(island, slot->name, topic.name);
  };
  leave_out_topics(islands, [&](const Island& island, TopicNumber topic) {
    return std::ranges::any_of(island.fills, [&](const Fill& fill) {
      return is_small(island, fill,
                      fill.topic == no_topic ? topic : fill.topic);
    });
  });
}

} // namespace parlour::adapters::nlu
