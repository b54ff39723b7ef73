#include "adapters/nlu/grammar/examples.hpp"

#include "adapters/nlu/grammar/marked_text.hpp"
#include "adapters/nlu/text/tokens.hpp"

namespace parlour::adapters::nlu {

namespace {

using jsgf::Node;
using jsgf::NodeKind;

// How much of an example that is too long the error message shows, in bytes.
constexpr std::size_t shown_bytes = 40;

void add_words(Node& sequence, std::string_view text) {
  for (auto& token : tokenize(text).list)
    sequence.children.push_back(
        {NodeKind::word, std::move(token.word), {}, {}, {}, {}});
}

// The part that ends in the slot at `last`: the words before it, back to the
// previous slot. Empty if there are no words between.
Node part_before(const Node& whole, std::size_t last) {
  auto first = last;
  while (first > 0 && whole.children[first - 1].kind == NodeKind::word)
    --first;
  Node part{NodeKind::sequence, "", {}, {}, {}, {}};
  if (first < last)
    for (auto at = first; at <= last; ++at)
      part.children.push_back(whole.children[at]);
  return part;
}

} // namespace

ExampleRules example_rules(const TopicModel& topic, const std::string& example,
                           std::vector<Error>& errors) {
  ExampleRules made;
  made.whole.kind = NodeKind::sequence;
  if (example.size() > max_example_bytes) {
    errors.push_back({ErrorKind::compile,
                      "the example \"" + example.substr(0, shown_bytes) +
                          "...\" of the topic '" + topic.name +
                          "' has more than " +
                          std::to_string(max_example_bytes) + " bytes",
                      {}});
    return made;
  }
  const auto marked = read_marks(example);
  if (!marked) {
    errors.push_back({ErrorKind::compile,
                      "the example \"" + example + "\" of the topic '" +
                          topic.name +
                          "' marks a slot's words like this: [words](Slot)",
                      {}});
    return made;
  }
  const std::string_view text = marked->text;
  // Words between the marks become words of the rule; each mark becomes a
  // reference to its slot.
  std::size_t at_byte = 0;
  for (const auto& mark : marked->marks) {
    add_words(made.whole, text.substr(at_byte, mark.begin - at_byte));
    made.whole.children.push_back(
        {NodeKind::reference, topic.name + '.' + mark.slot, {}, {}, {}, {}});
    at_byte = mark.end;
  }
  add_words(made.whole, text.substr(at_byte));
  // A part that is the whole example would be the same rule twice.
  for (std::size_t at = 0; at < made.whole.children.size(); ++at) {
    if (made.whole.children[at].kind != NodeKind::reference)
      continue;
    auto part = part_before(made.whole, at);
    if (!part.children.empty() &&
        part.children.size() < made.whole.children.size())
      made.parts.push_back(std::move(part));
  }
  return made;
}

} // namespace parlour::adapters::nlu
