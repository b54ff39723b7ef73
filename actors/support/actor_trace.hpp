// ActorTrace: shows each message that an actor takes, where somebody has asked
// for the actor by its kind or its name (`parlour run --trace-actors`). Costs
// one comparison a message where nobody has.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "actors/protocol/interfaces.hpp"
#include "actors/support/observer.hpp"

namespace parlour::actors {

// A message's name in actors/protocol/interfaces.hpp.
#define X(message)                                                             \
  inline const char* name_of(const message&) {                                 \
    return #message;                                                           \
  }
#include "actors/protocol/local_messages.def"

// What a trace tells of a message beside its name: the events in it.
inline std::string detail_of(const std::vector<Message>& messages) {
  std::string text;
  for (const auto& message : messages)
    text += (text.empty() ? "" : "; ") + to_string(message);
  return text;
}
template <class What>
std::string detail_of(const What& what) {
  if constexpr (requires { what.messages; })
    return detail_of(what.messages);
  else if constexpr (requires { what.event.params; })
    return to_string(what.event);
  else if constexpr (requires { what.id; })
    return std::to_string(what.id);
  return {};
}

// For one thread: the actor's.
class ActorTrace {
public:
  ActorTrace() = default; // of an actor that nobody asked for
  // `session`: whose actor it is; what is private there is masked. Empty: each
  // message's own.
  ActorTrace(Observer& observer, std::string_view kind, std::string_view name,
             std::string_view session = {});

  explicit operator bool() const {
    return observer_ != nullptr;
  }
  void took(const std::string& message, std::string detail,
            const SessionId& session = {}) const;
  template <class What>
  void took(const What& what) const {
    if constexpr (requires { what.messages; })
      took(name_of(what), detail_of(what),
           what.messages.empty() ? SessionId() : what.messages.front().session);
    else
      took(name_of(what), detail_of(what));
  }

private:
  Observer* observer_ = nullptr;
  std::string actor_;
  SessionId session_;
};

// A handler that shows what it is given first.
// CAF reads the message's type from the call operator, so that the wrapper has
// the same argument and result as the handler.
template <class Handler, class Result, class Argument>
struct TracedHandler {
  Handler handler;
  std::shared_ptr<const ActorTrace> trace; // null: nobody asked

  Result operator()(Argument what) const {
    if (trace)
      trace->took(what);
    return handler(what);
  }
};

template <class Handler, class Result, class Class, class Argument>
TracedHandler<Handler, Result, Argument>
make_traced(Handler handler, std::shared_ptr<const ActorTrace> trace,
            Result (Class::*)(Argument) const) {
  return {std::move(handler), std::move(trace)};
}

// An actor's behavior of these handlers.
template <class Behavior, class... Handlers>
Behavior traced(ActorTrace trace, Handlers... handlers) {
  const auto shared =
      trace ? std::make_shared<const ActorTrace>(std::move(trace)) : nullptr;
  return Behavior{
      make_traced(std::move(handlers), shared, &Handlers::operator())...};
}

} // namespace parlour::actors
