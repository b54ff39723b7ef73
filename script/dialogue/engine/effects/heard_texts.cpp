#include "script/dialogue/engine/effects/heard_texts.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace parlour::dialogue {

namespace {

// The understanding reads each of them, with every utterance of the user.
constexpr std::size_t most_texts = 5;
constexpr std::size_t longest_text = 1'000; // in bytes

// Recognisers name a text alone, or in a map.
const Value& text_of(const Value& alternative) {
  return alternative.if_map() ? alternative["text"] : alternative;
}

} // namespace

// RecognitionResult(text, confidence, alternatives): equal texts count once,
// and what is too long is left out. A typed line has no alternatives.
Value heard_texts(const Message& result) {
  if (result.params.size() < 3 || !result.params[0].if_string())
    return {};
  const auto* alternatives = result.params[2].if_list();
  if (!alternatives)
    return {};
  List texts{result.params[0]};
  for (const auto& alternative : *alternatives) {
    const auto& text = text_of(alternative);
    const auto* words = text.if_string();
    if (words && !words->empty() && words->size() <= longest_text &&
        texts.size() < most_texts &&
        std::ranges::find(texts, text) == texts.end())
      texts.push_back(text);
  }
  return texts;
}

// A script that posts another text than was heard, such as a corrected one,
// means that text and none of the alternatives. It was heard all the same.
Value with_heard(Value context, const Value& text, const Value& heard) {
  const auto* texts = heard.if_list();
  if (!texts || texts->empty() || !context.if_map())
    return context;
  auto made = *context.if_map();
  made.set("heard", (*texts)[0] == text ? List(texts->begin() + 1, texts->end())
                                        : List());
  return made;
}

} // namespace parlour::dialogue
