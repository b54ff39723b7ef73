#include "script/dialogue/inputs/session_input.hpp"

namespace parlour::dialogue {

namespace {

// In the order of the variant.
constexpr std::string_view names[] = {
    "begin",       "message",   "step",          "frame",         "query",
    "file",        "component", "socket opened", "socket closed", "timer",
    "output done", "end",       "resume"};
static_assert(std::size(names) == std::variant_size_v<SessionInput>);

// The input function for each kind.
struct Taker {
  Conversation& conversation;
  Timestamp now;

  void operator()(input::Begun&) {
    conversation.open(now);
  }
  void operator()(input::Received& what) {
    conversation.receive(std::move(what.message));
  }
  void operator()(input::Stepped&) {
    conversation.step(now);
  }
  void operator()(input::FrameApplied& what) {
    conversation.frame_applied(std::move(what.result), now);
  }
  void operator()(input::QueryAnswered& what) {
    conversation.query_answered(what.id, std::move(what.outcome), now);
  }
  void operator()(input::FileAnswered& what) {
    conversation.file_answered(what.id, std::move(what.outcome), now);
  }
  void operator()(input::ComponentAnswered& what) {
    conversation.component_answered(what.id, std::move(what.outcome), now);
  }
  void operator()(input::SocketOpened& what) {
    conversation.socket_opened(what.id, std::move(what.outcome), now);
  }
  void operator()(input::SocketClosed& what) {
    conversation.socket_closed(what.id);
  }
  void operator()(input::TimerFired& what) {
    conversation.timer_fired(what.id, now);
  }
  void operator()(input::OutputFinished& what) {
    conversation.output_finished(what.id, what.played, now);
  }
  void operator()(input::Closed&) {
    conversation.close(now);
  }
  void operator()(input::Resumed& what) {
    conversation.resume(now);
    if (what.after_crash)
      conversation.ask_again();
  }
};

} // namespace

std::string_view name_of(const SessionInput& input) {
  return names[input.index()];
}

void take(Conversation& conversation, SessionInput input, Timestamp now) {
  std::visit(Taker{conversation, now}, input);
}

} // namespace parlour::dialogue
