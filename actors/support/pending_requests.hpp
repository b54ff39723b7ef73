// PendingRequests: the messages that an instance was given and has not answered
// yet. Should it break, who waits for them is told at once.
#pragma once

#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/message/message.hpp"
#include "runtime/message/roles.hpp"

namespace parlour::actors {

// For one thread at a time.
//
// An example: Weather was asked for a forecast and crashes. Its entry makes the
// session's request end with an error at once, not after `request-timeout`.
class PendingRequests {
public:
  // Of the commands that roles.def does not know, many want no answer: what is
  // older is held for one of these, and of more than so many, the oldest.
  static constexpr Milliseconds patience{60'000};
  static constexpr std::size_t max_entries = 1'000;

  explicit PendingRequests(std::vector<std::string> roles,
                           std::vector<RoleEvent> own_events = {})
      : roles_(std::move(roles)), own_events_(std::move(own_events)) {}

  // Its session and correlation are kept. What has no correlation waits for no
  // answer, nor does a command that roles.def says so of.
  void given(const Message& message, Timestamp now);
  // What the instance says; ends what it answers.
  void said(const Message& event);
  bool none(Timestamp now);
  // As messages of which session and correlation are those to answer to.
  std::vector<Message> take(Timestamp now);

private:
  bool wants_answer(const std::string& command) const;
  bool is_answer(const std::string& command) const;
  void forget_old(Timestamp now);

  // Only what an answer needs: the message itself is not kept.
  struct Entry {
    Timestamp since;
    Correlation correlation;
    SessionId session;
  };
  std::vector<std::string> roles_;
  std::vector<RoleEvent> own_events_;
  std::deque<Entry> entries_;
};

} // namespace parlour::actors
