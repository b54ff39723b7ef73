#include "script/dialogue/engine/answers.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "script/dialogue/engine/effects/heard_texts.hpp"

namespace parlour::dialogue {

using namespace std::string_view_literals;

namespace {

const std::string understanding = "NLU";

} // namespace

// The user's own words are understood with the present question as their
// context. A meaning that the application asked for itself is looked at as it
// is.
std::optional<StepList> Answers::take(Input& input) {
  if (is_meaning(*input.message))
    return answer(input);
  if (!input.begins_turn || input.is_no_answer ||
      input.message->params.empty() || !context_.port.reachable(understanding))
    return std::nullopt;
  const auto correlation = messenger_.post(
      understanding, "DoNLU",
      {input.message->params[0],
       with_heard(topics_.understanding_context(), input.message->params[0],
                  context_.turns.heard(input.turn))},
      input.turn);
  context_.turns.let_go(input.turn); // the question keeps it open, for its time
  words_.emplace(correlation, std::move(input));
  return StepList();
}

// Words that turn out to be no answer are put back as the next message and
// marked, so that they are not sent to the understanding a second time from
// here.
std::optional<StepList> Answers::take_meaning(Input& input) {
  const auto found = words_.find(input.message->correlation);
  if (found == words_.end() ||
      context_.port.reply_to_request(*input.message) == Reply::none)
    return std::nullopt;
  auto words = std::move(found->second);
  words_.erase(found);
  if (is_meaning(*input.message))
    if (auto acts = answer(input))
      return acts;
  context_.turns.hold(words.turn);
  context_.turns.let_go(input.turn);
  words.is_no_answer = true;
  inbox_.put_back(std::move(words));
  return StepList();
}

void Answers::forget(TurnId turn) {
  std::erase_if(words_,
                [&](const auto& entry) { return entry.second.turn == turn; });
}

bool Answers::is_meaning(const Message& message) const {
  return message.command == "FrameInfo"sv &&
         context_.port.is_source(understanding, message.source);
}

// All or nothing: of "yes, and is there a lift?" only the first half is an
// answer. Taken apart here, the second half would reach no handler.
std::optional<StepList> Answers::answer(const Input& input) {
  auto parsed = parse_acts(Value(List(input.message->params)));
  if (parsed.acts.empty() ||
      !std::all_of(parsed.acts.begin(), parsed.acts.end(),
                   [&](const Act& act) { return topics_.is_waited_for(act); }))
    return std::nullopt;
  StepList acts;
  for (auto& act : parsed.acts) {
    context_.turns.hold(input.turn);
    acts.add(steps::TakeAct{std::make_shared<const Act>(std::move(act)),
                            input.turn});
  }
  context_.turns.let_go(input.turn);
  return acts;
}

} // namespace parlour::dialogue
