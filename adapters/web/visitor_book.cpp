#include "adapters/web/visitor_book.hpp"

#include <algorithm>
#include <utility>

#include <unistd.h>

#include "adapters/web/bounds.hpp"

namespace parlour::adapters::web {

namespace {

std::size_t size_of(const Told& told) {
  const auto* said = std::get_if<Said>(&told);
  return sizeof(Told) + (said ? said->text.size() + said->act.size() : 0);
}

// Whether who says that it has seen that much has not seen this.
// `told` is a Said or a Done: nothing else is kept.
bool is_news(const Told& told, std::uint64_t turn, std::uint64_t output) {
  if (const auto* said = std::get_if<Said>(&told))
    return said->output > output;
  return std::get<Done>(told).turn > turn;
}

bool is_of_turn(const Told& told, std::uint64_t turn) {
  if (const auto* said = std::get_if<Said>(&told))
    return said->turn == turn;
  return std::get<Done>(told).turn == turn;
}

} // namespace

// -- who is there -------------------------------------------------------------

VisitorBook::Visitor* VisitorBook::find(VisitorId id) {
  const auto found = visitors_.find(id);
  return found == visitors_.end() ? nullptr : &found->second;
}

const VisitorBook::Visitor* VisitorBook::find(VisitorId id) const {
  const auto found = visitors_.find(id);
  return found == visitors_.end() ? nullptr : &found->second;
}

VisitorBook::Visitor* VisitorBook::find(VisitorId id,
                                        const std::string& session) {
  auto* visitor = find(id);
  return visitor && !visitor->session.empty() && visitor->session == session
             ? visitor
             : nullptr;
}

VisitorId VisitorBook::refuse(Connection& connection, Refused why) {
  connection.tell(why);
  return 0;
}

// Sessions whose visitor is away take a place, too.
VisitorId VisitorBook::add(Connection& connection, bool can_return) {
  if (going_on_ >= options_.sessions) {
    ++counters_.refused;
    return refuse(connection,
                  {"full", "all " + std::to_string(options_.sessions) +
                               " places are taken; try again later"});
  }
  auto& visitor = visitors_[++last_];
  visitor.connection = &connection;
  visitor.can_return = can_return;
  ++going_on_;
  ++counters_.visitors;
  return last_;
}

// A person has nothing to come back with: no id was shown.
VisitorId VisitorBook::come(Connection& connection) {
  const auto id = add(connection, false);
  if (id != 0)
    host_.open(id);
  return id;
}

VisitorId VisitorBook::come(Connection& connection, const Hello& hello) {
  if (!hello.session.empty())
    return resume(connection, hello);
  const auto id = add(connection, true);
  if (id != 0)
    host_.open(id);
  return id;
}

// The session's id is the key to it: whoever names it takes over, also from a
// connection that has not noticed yet that it is dead.
VisitorId VisitorBook::resume(Connection& connection, const Hello& hello) {
  const auto found = by_session_.find(hello.session);
  if (found == by_session_.end())
    return refuse(connection,
                  {"unknown-session",
                   "there is no such session: it has ended, or its time "
                   "without a connection is over; say hello without one"});
  const auto id = found->second;
  auto& visitor = visitors_.at(id);
  if (auto* before = std::exchange(visitor.connection, nullptr)) {
    before->tell(Refused{"taken-over", "another connection goes on with this "
                                       "session"});
    before->close();
  }
  visitor.connection = &connection;
  lingering_.erase({visitor.expires, id}); // whose session has ended stays
  ++counters_.resumed;
  welcome(visitor, hello);
  return id;
}

// What came before the turns that are open, or before the last one, is lost.
VisitorId VisitorBook::bring_back(LeftVisitor left, Moment now) {
  auto& visitor = visitors_[++last_];
  ++going_on_;
  visitor.can_return = true;
  visitor.session = std::move(left.session);
  visitor.taken = left.taken;
  visitor.done = left.done;
  by_session_[visitor.session] = last_;
  visitor.dropped_turn =
      left.taken == left.done && left.taken > 0 ? left.taken - 1 : left.done;
  if (!left.said.empty())
    visitor.dropped_output = left.said.front().output - 1;
  for (auto& said : left.said)
    keep(visitor, std::move(said));
  for (auto turn = visitor.dropped_turn; turn < left.done;)
    keep(visitor, Done{++turn});
  linger(last_, visitor, now);
  return last_;
}

bool VisitorBook::is_kept_since(const Visitor& visitor, const Hello& hello) {
  return hello.turn >= visitor.dropped_turn &&
         hello.output >= visitor.dropped_output;
}

// All that has happened since, in order.
void VisitorBook::welcome(Visitor& visitor, const Hello& hello) {
  tell(visitor, Welcome{visitor.session, visitor.taken, true,
                        !is_kept_since(visitor, hello), host_.clock(),
                        static_cast<std::uint64_t>(getpid())});
  for (const auto& told : visitor.kept)
    if (is_news(told, hello.turn, hello.output))
      tell(visitor, told);
  if (visitor.ended) {
    tell(visitor, Ended());
    std::exchange(visitor.connection, nullptr)->close();
  }
}

// -- turns --------------------------------------------------------------------

bool VisitorBook::has_room(VisitorId id) const {
  const auto* visitor = find(id);
  return visitor && visitor->taken - visitor->done < max_open_turns;
}

std::uint64_t VisitorBook::next_turn(VisitorId id) const {
  const auto* visitor = find(id);
  return visitor ? visitor->taken + 1 : 0;
}

// Somebody who is not known waits for nothing.
bool VisitorBook::is_answered(VisitorId id) const {
  const auto* visitor = find(id);
  return !visitor ||
         (!visitor->session.empty() && visitor->taken == visitor->done);
}

// The first turns may come before the session has begun, which takes a moment:
// they wait in `early`.
bool VisitorBook::take(VisitorId id, const Turn& turn) {
  auto* visitor = find(id);
  if (!visitor || visitor->ended)
    return false;
  if (turn.number <= visitor->taken)
    return repeat(*visitor, turn.number);
  if (turn.number != visitor->taken + 1) {
    tell(*visitor, Refused{"not-next",
                           "turn " + std::to_string(visitor->taken + 1) +
                               " is next; this one was not taken",
                           turn.number});
    return false;
  }
  if (!has_room(id)) {
    tell(*visitor, Refused{"too-many-turns",
                           std::to_string(max_open_turns) +
                               " turns wait for their answers; wait for one "
                               "of them, then say it again",
                           turn.number});
    return false;
  }
  ++visitor->taken;
  ++counters_.turns;
  if (visitor->session.empty())
    visitor->early.push_back(turn);
  else
    host_.take(id, turn);
  return true;
}

bool VisitorBook::repeat(Visitor& visitor, std::uint64_t turn) {
  if (turn <= visitor.dropped_turn) {
    tell(visitor, Refused{"too-old",
                          "this turn was taken, and its answers are not kept "
                          "any more; go on with turn " +
                              std::to_string(visitor.taken + 1),
                          turn});
    return false;
  }
  for (const auto& told : visitor.kept)
    if (is_of_turn(told, turn))
      tell(visitor, told);
  return true;
}

// -- going --------------------------------------------------------------------

// Who cannot come back, or said goodbye, or never got a session's id, goes for
// good.
void VisitorBook::lose(VisitorId id, const Connection& connection, Moment now) {
  const auto found = visitors_.find(id);
  if (found == visitors_.end() || found->second.connection != &connection)
    return; // it has come back by another one
  auto& visitor = found->second;
  visitor.connection = nullptr;
  if (visitor.can_return && !visitor.finished && !visitor.session.empty())
    return linger(id, visitor, now);
  // Its session's end finds nobody any more.
  forget(found);
  host_.close(id);
}

// The end comes by ended(), when the conversation has said its last words.
void VisitorBook::finish(VisitorId id) {
  auto* visitor = find(id);
  if (!visitor || visitor->finished || visitor->ended)
    return;
  visitor->finished = true;
  host_.close(id);
}

void VisitorBook::linger(VisitorId id, Visitor& visitor, Moment now) {
  lingering_.erase({visitor.expires, id}); // lost before the session ended
  visitor.expires = now + options_.linger;
  (visitor.ended ? ended_ : lingering_).emplace(visitor.expires, id);
}

// The caller sees to the host and to the lists of those who are awaited.
void VisitorBook::forget(Visitors::iterator found) {
  if (!found->second.ended)
    --going_on_;
  by_session_.erase(found->second.session);
  visitors_.erase(found);
}

// -- conversations ------------------------------------------------------------

// Turns that came early are taken now, in order.
void VisitorBook::began(VisitorId id, const std::string& session) {
  auto* visitor = find(id);
  if (!visitor || !visitor->session.empty())
    return;
  visitor->session = session;
  if (visitor->can_return)
    by_session_[session] = id;
  tell(*visitor, Welcome{session, 0, false, false, host_.clock(),
                         static_cast<std::uint64_t>(getpid())});
  for (const auto& turn : std::exchange(visitor->early, {}))
    host_.take(id, turn);
}

// What is said while a turn is open counts as an answer to the oldest.
void VisitorBook::said(VisitorId id, const std::string& session, Said what) {
  auto* visitor = find(id, session);
  if (!visitor)
    return;
  what.turn = visitor->taken > visitor->done ? visitor->done + 1 : 0;
  tell(*visitor, what);
  keep(*visitor, std::move(what));
}

// The session tells only the highest number; the visitor is told of each.
void VisitorBook::done(VisitorId id, const std::string& session,
                       std::uint64_t turn) {
  auto* visitor = find(id, session);
  if (!visitor)
    return;
  for (; visitor->done < std::min(turn, visitor->taken);) {
    const Done done{++visitor->done};
    tell(*visitor, done);
    keep(*visitor, done);
  }
  if (visitor->connection)
    visitor->connection->go_on();
}

// Who has lost the connection just now may still come for the last words.
void VisitorBook::ended(VisitorId id, const std::string& session, Moment now) {
  auto* visitor = find(id, session);
  if (!visitor || visitor->ended)
    return;
  visitor->ended = true;
  --going_on_;
  tell(*visitor, Ended());
  if (auto* connection = std::exchange(visitor->connection, nullptr))
    connection->close();
  host_.close(id);
  if (visitor->can_return && !visitor->finished)
    linger(id, *visitor, now);
  else
    forget(visitors_.find(id));
}

void VisitorBook::tell(Visitor& visitor, const Told& told) {
  if (visitor.connection)
    visitor.connection->tell(told);
}

// What is dropped is remembered by its number: a visitor who has not seen it is
// told that something is lost.
void VisitorBook::keep(Visitor& visitor, Told told) {
  if (!visitor.can_return)
    return;
  visitor.kept_bytes += size_of(told);
  visitor.kept.push_back(std::move(told));
  while (visitor.kept.size() > max_kept ||
         visitor.kept_bytes > max_kept_bytes) {
    const auto& oldest = visitor.kept.front();
    visitor.kept_bytes -= size_of(oldest);
    if (const auto* said = std::get_if<Said>(&oldest)) {
      visitor.dropped_output = said->output;
      visitor.dropped_turn = std::max(visitor.dropped_turn, said->turn);
    } else {
      visitor.dropped_turn = std::get<Done>(oldest).turn;
    }
    visitor.kept.erase(visitor.kept.begin());
  }
}

// -- time ---------------------------------------------------------------------

void VisitorBook::expire(Moment now) {
  expire(lingering_, now, lingering_.size());
  expire(ended_, now, options_.sessions);
}

// Beyond `most` the oldest go early.
void VisitorBook::expire(Expiries& all, Moment now, std::size_t most) {
  while (!all.empty() && (all.begin()->first <= now || all.size() > most)) {
    const auto id = all.begin()->second;
    all.erase(all.begin());
    if (const auto found = visitors_.find(id); found != visitors_.end()) {
      const bool ended = found->second.ended;
      forget(found);
      if (!ended)
        host_.close(id);
    }
  }
}

std::optional<VisitorBook::Moment> VisitorBook::next_expiry() const {
  if (lingering_.empty() && ended_.empty())
    return std::nullopt;
  if (lingering_.empty() || ended_.empty())
    return (lingering_.empty() ? ended_ : lingering_).begin()->first;
  return std::min(lingering_.begin()->first, ended_.begin()->first);
}

} // namespace parlour::adapters::web
