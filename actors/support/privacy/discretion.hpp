// Discretion: what is private="true" is masked wherever it would be shown:
// traces, logs, reports. Stands between the node and whoever watches it.
//
// What a user says is shown when it is known what it means, as only then one
// knows whether it was private; until then all that happens in its session is
// held back.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "actors/support/privacy/recent_secrets.hpp"
#include "runtime/base/text/text_map.hpp"
#include "runtime/message/inspection.hpp"
#include "runtime/message/masking.hpp"

namespace parlour::actors {

// Safe from any thread. What shows may ask what is masked or private, and may
// send messages.
//
// An example: the robot asks for a PIN, the slot is private, and the user says
// "4711". The message is held back until the session says what was private in
// that turn (conceal, conceal_turn) and that the turn is understood (settled).
// Then all of it is shown at once, with `***` for the digits.
class Discretion {
public:
  // Called in the order of what happened, by one thread at a time where
  // something is private.
  using Show = std::function<void(const Inspection&)>;
  // Whether a message is what somebody was heard to say.
  using IsHeard = std::function<bool(const Message&)>;

  // Without `is_heard` nothing is private: all is shown at once and as it is,
  // and nothing is noted.
  Discretion(Show show, IsHeard is_heard);
  bool hides() const {
    return is_heard_ != nullptr;
  }

  // -- sessions --------------------------------------------------------------

  void conceal(const SessionId& session, const std::vector<std::string>& texts);
  // What is being said is private, whatever it means.
  void conceal_turn(const SessionId& session);
  // What it has received up to the message of that number is understood.
  void settled(const SessionId& session, std::uint64_t received);
  void ended(const SessionId& session);
  // What was heard for one is another's turn: a seat is named while it has no
  // session, or a turn came too late for the one before.
  void goes_on(const SessionId& from, const SessionId& to);

  // -- observers -------------------------------------------------------------

  // Each message on its way, before it is shown.
  void pass(const Message& message, const std::string& way);
  void show(Inspection seen);
  // As it may be shown, from whatever session it is.
  std::string masked(const std::string& text) const;
  // The same of what is told of a conversation when it is over: without all
  // that was heard in private turns, too.
  std::string masked_afterwards(const std::string& text) const;
  // Whether a user's words are not to be kept.
  bool is_private(const std::string& words) const;

private:
  // From the first that was heard or concealed until some time after its end.
  struct Session {
    explicit Session(SharedSecrets& shared) : secrets(shared) {}

    RecentSecrets secrets;
    bool is_open = false;           // somebody was heard, and is not understood
    std::uint64_t opened = 0;       // the number of the last that was heard
    bool hides_turn = false;        // a private slot was filled or asked for
    std::vector<std::string> heard; // since it is open
    std::vector<Inspection> held;
  };
  // What is shown now, and how it is masked.
  struct Ready {
    Secrets secrets;
    std::vector<Inspection> seen;
  };

  // Made anew where it is not known. With the lock held, as all below.
  Session& known(const SessionId& session);
  static void move_turn(Session& from, Session& to);
  Ready taken(Inspection seen);
  Ready end_turn(Session& session);
  Secrets note_private_turn(Session& session);
  // Late messages of a session that is over are masked, too, for some time.
  void drop_oldest();
  void show_masked(Ready ready) const;

  const Show show_;
  const IsHeard is_heard_;
  std::mutex showing_;       // taken before the other, and kept while showing
  mutable std::mutex mutex_; // of what follows
  SharedSecrets all_;        // those of all sessions
  TextMap<Session> sessions_;
  std::deque<SessionId> ended_; // of which the secrets are still known
  RecentSecrets words_;         // of private turns
};

} // namespace parlour::actors
