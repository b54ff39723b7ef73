#include "script/dialogue/engine/heard_grammar.hpp"

#include <algorithm>

namespace parlour::dialogue {

namespace {

const std::string recogniser = "ASR";

// Whether a state or a slot names a grammar at all.
bool uses_grammars(const script::Program& program) {
  const auto names_one = [](const auto& one) { return !one.grammar.empty(); };
  return std::ranges::any_of(program.states, names_one) ||
         std::ranges::any_of(program.topics, [&](const script::Topic& topic) {
           return std::ranges::any_of(topic.slots, names_one);
         });
}

} // namespace

HeardGrammar::HeardGrammar(DialogueContext& context, Messenger& messenger,
                           const Whereabouts& whereabouts)
    : context_(context), messenger_(messenger), whereabouts_(whereabouts),
      is_used_(uses_grammars(*context.program)) {}

// A list with one name, or an empty list for all. It belongs to no turn, as
// nobody waits for its answer.
void HeardGrammar::tell() {
  if (!is_used_)
    return;
  const auto& wanted = whereabouts_.narrowing_grammar();
  if (wanted == told_ || !context_.port.reachable(recogniser))
    return;
  told_ = wanted;
  List names;
  if (!told_.empty())
    names.emplace_back(told_);
  messenger_.post(recogniser, "SetGrammar", {Value(std::move(names))}, 0);
}

} // namespace parlour::dialogue
