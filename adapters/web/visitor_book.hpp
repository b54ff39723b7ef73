// VisitorBook: who visits, which turns of each visitor are taken and answered,
// and what is kept to be told again to who has lost the connection. No socket,
// thread or clock of its own; the server calls it on its thread.
//
// A visitor has one session. It outlives its connection for a time if the
// visitor can name it, and is closed when the visitor goes for good.
#pragma once

#include <chrono>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "adapters/web/protocol.hpp"
#include "runtime/base/clock.hpp"

namespace parlour::adapters::web {

// Never used again.
using VisitorId = std::uint64_t;

// Who holds the conversations. Nobody waits for these; each returns at once.
class Host {
public:
  virtual ~Host() = default;
  // A session is to begin; VisitorBook::began follows.
  virtual void open(VisitorId visitor) = 0;
  // Numbers rise by one, from 1. VisitorBook::done follows.
  virtual void take(VisitorId visitor, const Turn& turn) = 0;
  // Nobody will come back: its session ends, and all of it is forgotten.
  // Nothing happens where it is over already.
  virtual void close(VisitorId visitor) = 0;
  // What the platform's clock shows.
  virtual std::string clock() = 0;
};

// A connection, as the book knows it.
class Connection {
public:
  virtual ~Connection() = default;
  virtual void tell(const Told& told) = 0;
  // What was told is still sent. The book does not call it any more.
  virtual void close() = 0;
  // There is room for turns again, or the last one is answered.
  virtual void go_on() {}
};

// From the command line of `parlour serve`.
struct BookOptions {
  std::size_t sessions = 1'000; // at a time
  // How long a session outlives its connection.
  Milliseconds linger{60'000};
};

// A visitor of a run that was killed, whose session goes on.
// Made from the journal (tools/parlour/serve).
struct LeftVisitor {
  std::string session;
  std::uint64_t taken = 0; // the turns up to this one
  std::uint64_t done = 0;
  std::vector<Said> said; // since the last turn that was taken
};

// Since the beginning.
// Shown by the metrics of `parlour serve`.
struct BookCounters {
  std::uint64_t visitors = 0;
  std::uint64_t turns = 0;
  std::uint64_t resumed = 0;
  std::uint64_t refused = 0; // for want of room
};

// Everything about a visitor that does not depend on sockets is decided here,
// and tested without them.
//
// A turn is counted once: its number is the visitor's own, so that a turn that
// is sent again, because the connection broke before its Done, is not taken
// again but answered from what was kept.
//
// The life of a visitor:
//
//   come()     its session is asked for; turns wait in `early`
//   began()    it is welcome; turns go to the host
//   lose()     no connection: it lingers, if it can come back
//   come()     with the session's id: what it has not seen is told again
//   ended()    its session is over; who lingers may still hear the last words
//   expire()   its time without a connection is over: it is forgotten
class VisitorBook {
public:
  using Moment = std::chrono::steady_clock::time_point;

  VisitorBook(BookOptions options, Host& host)
      : options_(options), host_(host) {}

  // -- connections; 0: refused, the connection was told why and is to close ---

  // Before all others: its session has begun, and it may come to resume it.
  VisitorId bring_back(LeftVisitor left, Moment now);
  // Somebody who will not come back.
  VisitorId come(Connection& connection);
  VisitorId come(Connection& connection, const Hello& hello);
  // A turn that was taken already is not taken again, but answered again. False
  // where it is refused; the connection was told why.
  bool take(VisitorId visitor, const Turn& turn);
  // Whether one more turn may be taken, and which number it has.
  bool has_room(VisitorId visitor) const;
  std::uint64_t next_turn(VisitorId visitor) const;
  bool is_answered(VisitorId visitor) const;
  // The connection is gone.
  void lose(VisitorId visitor, const Connection& connection, Moment now);
  // The visitor wants its session to end.
  void finish(VisitorId visitor);

  // -- conversations ----------------------------------------------------------

  void began(VisitorId visitor, const std::string& session);
  void said(VisitorId visitor, const std::string& session, Said what);
  void done(VisitorId visitor, const std::string& session, std::uint64_t turn);
  void ended(VisitorId visitor, const std::string& session, Moment now);

  // -- time -------------------------------------------------------------------

  // Those who have not come back in time are closed.
  // Call it at next_expiry().
  void expire(Moment now);
  std::optional<Moment> next_expiry() const;

  // Sessions that go on.
  std::size_t size() const {
    return going_on_;
  }
  const BookCounters& counters() const {
    return counters_;
  }

private:
  // `done` <= `taken`; the turns between are open. `kept` is empty for somebody
  // who cannot come back.
  struct Visitor {
    Connection* connection = nullptr; // null: it has none at present
    bool can_return = false;
    bool ended = false;
    bool finished = false; // at the visitor's wish
    std::string session;   // empty: it has not begun
    std::uint64_t taken = 0;
    std::uint64_t done = 0;
    std::vector<Turn> early; // before it has begun
    std::vector<Told> kept;  // Said and Done, the last
    std::size_t kept_bytes = 0;
    // The last of what is not kept any more.
    std::uint64_t dropped_turn = 0;
    std::uint64_t dropped_output = 0;
    Moment expires{};
  };
  using Visitors = std::unordered_map<VisitorId, Visitor>;
  using Expiries = std::set<std::pair<Moment, VisitorId>>;

  VisitorId add(Connection& connection, bool can_return);
  VisitorId resume(Connection& connection, const Hello& hello);
  void welcome(Visitor& visitor, const Hello& hello);
  static bool is_kept_since(const Visitor& visitor, const Hello& hello);
  // Tells again what was said to a turn; false where that is not kept.
  bool repeat(Visitor& visitor, std::uint64_t turn);
  void tell(Visitor& visitor, const Told& told);
  void keep(Visitor& visitor, Told told);
  // The visitor has no connection, and may come back for some time.
  void linger(VisitorId id, Visitor& visitor, Moment now);
  void expire(Expiries& all, Moment now, std::size_t most);
  void forget(Visitors::iterator found);
  Visitor* find(VisitorId id);
  const Visitor* find(VisitorId id) const;
  // Of that session, which has begun.
  Visitor* find(VisitorId id, const std::string& session);
  VisitorId refuse(Connection& connection, Refused why);

  const BookOptions options_;
  Host& host_;
  Visitors visitors_;
  std::unordered_map<std::string, VisitorId> by_session_;
  // Those without a connection, by the time when they are closed: whose session
  // goes on, and whose session has ended.
  Expiries lingering_;
  Expiries ended_;
  std::size_t going_on_ = 0;
  VisitorId last_ = 0;
  BookCounters counters_;
};

} // namespace parlour::adapters::web
