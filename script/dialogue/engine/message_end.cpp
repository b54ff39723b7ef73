#include "script/dialogue/engine/message_end.hpp"

#include <string_view>
#include <utility>

namespace parlour::dialogue {

using namespace std::string_view_literals;

// What means nothing leads to NoMatch also where a handler took it: that one
// counts as having apologised, but the question still has to come again.
void MessageEnd::handled(const Handled& what) {
  if (output_.waits_for_words())
    output_.handled(what.message, what.worded);
  sockets_.handled(what.message);
  const bool nothing = means_nothing(what);
  if (!what.taken && !nothing)
    unhandled(what);
  if (nothing || (!what.taken && what.is_said))
    not_understood(what);
}

// The engine's own reaction to what no state and no handler took, or it counts
// as unhandled; nobody has to take what the engine raised.
void MessageEnd::unhandled(const Handled& what) {
  const auto& message = what.message;
  if (message.source == "Script"sv && message.command == "Error"sv) {
    if (!output_.may_apologise())
      return;
    Say apology;
    apology.act = "unavailable";
    apology.data =
        Map{{"reason", message.params.empty() ? Value() : message.params[0]}};
    apology.turn = what.turn;
    output_.say(std::move(apology));
    return;
  }
  if (!what.raised)
    context_.port.unhandled(message);
}

// The understanding gave up, or broke while it worked for the user. Where it
// broke at something else, the user has said nothing that is not understood.
bool MessageEnd::means_nothing(const Handled& what) const {
  const auto& event = what.message;
  const bool broke = event.command == "Failed"sv && what.turn != 0;
  return (broke || event.command == "NoResult"sv) &&
         context_.port.is_source("NLU", event.source);
}

// The question that was asked comes again; a handler that took the event has
// made the apology (engine rule 5.10).
void MessageEnd::not_understood(const Handled& what) {
  context_.turns.hold(what.turn);
  context_.lane.queue(
      steps::NoMatch{.turn = what.turn, .apologised = what.taken});
}

} // namespace parlour::dialogue
