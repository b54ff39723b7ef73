// Inbox: what has come to a conversation and is not taken yet: messages from
// outside in the order in which they arrived, and internal events, which come
// before them and are limited (engine rules 2.1 and 2.6). All that is in it
// holds its user turn. Plain data: it knows no script and no port. For example,
// two typed lines arrive together; while the first is dealt with, the second is
// known to be here, so that no question to the first is released (engine rule
// 3.5).
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "script/dialogue/agenda/turns.hpp"
#include "script/dialogue/context/input.hpp"
#include "script/support/fifo.hpp"

namespace parlour::dialogue {

// Owned by ConversationImplementation, which decides in which order the inbox,
// outputs and slices are served.
class Inbox {
public:
  // `turns` must outlive the inbox.
  explicit Inbox(Turns& turns) : turns_(turns) {}

  // -- messages from outside --
  void receive(Input&& input);
  // One that was taken, holds its turn, and could not be dealt with then: it is
  // the next.
  void put_back(Input&& input);
  // Whose messages count: not the user's while the conversation ends.
  enum class Of : std::uint8_t { all, all_but_user };
  bool has_message(Of whom) const;
  // The next; nothing where there is none. Whoever takes it lets its turn go
  // when it is dealt with; the same holds for take_internal.
  std::optional<Input> take_message(Of whom);
  // All, without their turns: for another conversation.
  Fifo<Input> take_unread();
  // The number of the last that was received; nothing where none has come since
  // it was asked for.
  std::optional<std::uint64_t> take_received() {
    return std::exchange(has_received_, false) ? std::optional(received_)
                                               : std::nullopt;
  }
  // Those to come are numbered by another message centre, whose numbers may be
  // lower.
  void number_anew() {
    received_ = 0;
  }

  // -- internal events --
  void add_internal(Input&& input);
  bool has_internal() const {
    return !internal_.empty();
  }
  Input take_internal() { // there must be one
    return internal_.take();
  }
  // Whether a message in it is such a one.
  template <class Predicate>
  bool any(Predicate is) const {
    const auto fits = [&](const Input& input) { return is(*input.message); };
    return std::any_of(internal_.begin(), internal_.end(), fits) ||
           std::any_of(messages_.begin(), messages_.end(), fits);
  }
  // Whether something in it answers this. A wait whose answer is here needs
  // neither a deadline nor to be asked for again.
  bool has_answer_to(Correlation correlation) const {
    return any([=](const Message& message) {
      return message.correlation == correlation;
    });
  }

  // An external event is taken: what follows from it is counted anew.
  void external_event_begins();
  enum class Count : std::uint8_t {
    within,     // the limit
    just_above, // told once between two external events
    above,
  };
  // One more internal event is taken, or one more step of a script. Above the
  // limit scripts chase each other: what is queued is dropped then.
  Count count_internal();
  // Of the events that were dropped, those that nobody was told of yet.
  bool has_dropped() const {
    return !dropped_.empty();
  }
  // The caller settles what hangs on them, such as an output that waits for its
  // words. Their turns were let go.
  Fifo<Input> take_dropped();

  // How far from outside the message is that is being handled (engine rule
  // 1.6).
  std::uint32_t rounds() const {
    return rounds_;
  }
  void handles(const Message& message) {
    rounds_ = message.rounds;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    // Who saves need not know what was asked for: to tell it twice is no harm.
    archive.without(turns_, has_received_);
    archive(messages_, internal_, dropped_, internal_count_, rounds_, received_,
            is_told_);
  }

private:
  Turns& turns_;
  Fifo<Input> messages_;
  Fifo<Input> internal_;
  Fifo<Input> dropped_;
  int internal_count_ = 0; // since the last external event
  std::uint32_t rounds_ = 0;
  std::uint64_t received_ = 0;
  bool has_received_ = true;
  bool is_told_ = false; // that there were too many
};

} // namespace parlour::dialogue
