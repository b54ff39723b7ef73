// SessionInput: everything that may enter a conversation, as data (engine rule
// 7.2). Whoever keeps the inputs of a session, each with its time, can repeat
// the session: equal inputs lead to equal states and words. The list is closed:
// what can change a conversation and is no alternative here would be missing in
// a replay. An alternative that is added goes to the end, as its place in the
// variant is what the bytes tell it by.
#pragma once

#include <cstddef>
#include <memory>
#include <string_view>
#include <utility>
#include <variant>

#include "script/dialogue/engine/conversation.hpp"

namespace parlour::dialogue {

namespace input {

// The session begins.
struct Begun {
  template <class Archive>
  void serialize(Archive&) {}
};

// A message of the message centre; never null.
struct Received {
  std::shared_ptr<const Message> message;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(message);
    archive.needs(message);
  }
};

// One of what is queued is taken, or outputs are released (Conversation::step).
// Kept, too, as it says in which order things were taken.
struct Stepped {
  template <class Archive>
  void serialize(Archive&) {}
};

// The result of a filling event. It follows from what was asked: a replay
// computes it again, so it is not kept.
struct FrameApplied {
  FrameResult result;

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(result);
  }
};

// The outcomes below belong to what was wanted under the same id
// (agenda/port.hpp).
struct QueryAnswered {
  QueryId id = 0;
  Expected<Value> outcome;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(id, outcome);
  }
};

struct FileAnswered {
  QueryId id = 0;
  Expected<Value> outcome;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(id, outcome);
  }
};

// Of a <load> or <unload>: no value, only whether it was done.
struct ComponentAnswered {
  QueryId id = 0;
  Expected<void> outcome;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(id, outcome);
  }
};

struct SocketOpened {
  SocketId id = 0;
  Expected<void> outcome;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(id, outcome);
  }
};

// By the other side; its last message is another input.
struct SocketClosed {
  SocketId id = 0;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(id);
  }
};

struct TimerFired {
  TimerId id = 0;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(id);
  }
};

// An output was shown; `played` false: it was broken off before a word was
// heard.
struct OutputFinished {
  OutputId id = 0;
  bool played = true;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(id, played);
  }
};

// The session is to end.
struct Closed {
  template <class Archive>
  void serialize(Archive&) {}
};

// It goes on with another port (engine rule 7.9).
struct Resumed {
  bool after_crash = false; // whoever talks may not know any more where he was

  template <class Archive>
  void serialize(Archive& archive) {
    archive(after_crash);
  }
};

} // namespace input

using SessionInput =
    std::variant<input::Begun, input::Received, input::Stepped,
                 input::FrameApplied, input::QueryAnswered, input::FileAnswered,
                 input::ComponentAnswered, input::SocketOpened,
                 input::SocketClosed, input::TimerFired, input::OutputFinished,
                 input::Closed, input::Resumed>;

inline SessionInput received(Message message) {
  return input::Received{std::make_shared<const Message>(std::move(message))};
}

// "message", "step", "timer" …: as pages and tools name them.
std::string_view name_of(const SessionInput& input);

// Hands the input to the function of the conversation that is meant for it.
// `now`: milliseconds since 1970, not earlier than with the input before.
void take(Conversation& conversation, SessionInput input, Timestamp now);

// An input and when it came, as it is kept.
struct TimedInput {
  Timestamp now = 0;
  SessionInput what;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(now);
    std::uint64_t kind = what.index();
    archive.place(kind, std::variant_size_v<SessionInput>);
    if constexpr (Archive::reads)
      what = empty(
          kind, std::make_index_sequence<std::variant_size_v<SessionInput>>());
    std::visit([&](auto& input) { archive(input); }, what);
  }

private:
  // The alternative of that number, to be read into.
  template <std::size_t... Kinds>
  static SessionInput empty(std::uint64_t kind, std::index_sequence<Kinds...>) {
    SessionInput one;
    ((Kinds == kind ? void(one.template emplace<Kinds>()) : void()), ...);
    return one;
  }
};

} // namespace parlour::dialogue
