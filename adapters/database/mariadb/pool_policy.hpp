// PoolPolicy decides what a MariaDBPool does, and does none of it: which order
// runs on which connection, when connections are opened and closed, how long an
// order may wait, and what becomes of it when its connection is lost. It has no
// thread, no socket and no clock: the pool tells it what happens and when, then
// carries out its deeds.
//
// An order runs on any free connection; inside of a transaction it runs on the
// connection on which the transaction began. Connections are opened when orders
// need them, one at a time. After a failed attempt the pool waits before the
// next one: 50 ms, then twice as long each time, up to 5 s.
//
// A connection (`Place`):
//
//  closed    decide(): somebody needs one         Open, opening
//  opening   opened(): success                    idle
//            opened(): an error                   Close, closed, pause
//  idle      decide(): an order can run           Run, running
//            decide(): its transaction is too old Close, Warn, closed
//            hung_up()                            Close, closed
//  running   ended(): success                     idle
//            ended(): an error of a statement     idle, or Close, closed if it
//                                                 ended the transaction
//            ended(): an error of Begin, Commit   Close, closed: nobody knows
//                     or Rollback                 what the server did
//            ended(): lost                        Close, closed
//
// An order whose connection is lost:
//
//  outside of a transaction
//    a read, or not yet sent     repeated on another connection
//    a write that was sent       fails with kind InDoubt
//  inside of a transaction
//    a commit that was sent      fails with kind InDoubt
//    anything else               fails: the server has rolled back
//
// A connection that is given up because the server did not answer in time is
// lost as well; its order is not repeated.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "adapters/database/database_command.hpp"
#include "adapters/database/lost_transactions.hpp"
#include "adapters/database/statement.hpp"
#include "adapters/loop/backoff.hpp"
#include "runtime/base/clock.hpp"
#include "runtime/message/message.hpp"

namespace parlour::adapters {

// A message with its command, read once.
struct DatabaseOrder {
  DatabaseCommand kind = DatabaseCommand::query;
  // For a query, its parameters are SQL and values.
  Message message;
  bool write = false;
};

// Not thread-safe. Every order that was queued gets exactly one answer.
class PoolPolicy {
public:
  using Moment = std::chrono::steady_clock::time_point;
  // The number of a connection, from 0.
  using Place = std::size_t;

  struct Limits {
    std::size_t connections = 1;
    // How long an order may wait for a connection.
    Milliseconds busy_timeout{};
    Milliseconds transaction_timeout{};
  };
  // How many orders may be without an answer; the pool refuses further ones.
  static constexpr std::size_t max_pending = 1'000;

  // What the pool is to do. Open and Run end with opened() and ended().
  struct Open {
    Place place;
    // No connection was open before: create the database if it is missing.
    bool sets_up;
  };
  // Starts order(place).
  struct Run {
    Place place;
  };
  // Closes the connection, which may have a task.
  struct Close {
    Place place;
  };
  // Logs the text.
  struct Warn {
    std::string_view text; // of static storage
  };
  using Deed = std::variant<Open, Run, Close, Warn>;

  struct Answer {
    Message message;
    StatementOutcome outcome;
  };

  // What a connection knows after a task, beside the outcome.
  struct State {
    // It cannot be used any more.
    bool lost = false;
    // It was lost after the statement was sent and before it was answered.
    bool in_doubt = false;
    // The server has rolled the transaction back.
    bool ended_transaction = false;
    // What a statement may do without a round trip before it.
    Access access = Access::write;
  };

  explicit PoolPolicy(Limits limits);

  // -- what happens -----------------------------------------------------------

  // Opens the first connection, although no order needs it.
  void begin();
  // `deadline`: until when the order may wait for a connection.
  void queue(DatabaseOrder order, Moment deadline);
  void opened(Place place, const StatementOutcome& outcome, Moment now);
  void ended(Place place, StatementOutcome outcome, const State& state,
             Moment now);
  // The server has closed an idle connection.
  void hung_up(Place place);
  // Lets pass what is too late, starts orders on free connections, and opens a
  // connection if one is missing. Call it after the others, and at
  // next_moment().
  void decide(Moment now);
  // Closes all connections and answers every order.
  void end();

  // -- what follows -----------------------------------------------------------

  // What is to be done, in this order; each deed is returned once.
  std::vector<Deed> deeds();
  std::vector<Answer> answers();

  // The order that runs there.
  const DatabaseOrder& order(Place place) const;
  // Whether no order can be started, as every connection has a task.
  bool is_busy() const;
  // When to call decide() although nothing happens; max() for never. While the
  // pool is busy it may not hear of new orders: then it is busy_timeout at
  // most, so that such an order still expires in time.
  Moment next_moment(Moment now) const;

private:
  enum class Phase : std::uint8_t { closed, opening, idle, running };

  // An order in the queue, or running.
  struct Waiting {
    DatabaseOrder order;
    Moment deadline;
    // How many connections were lost while they executed it.
    std::size_t deaths = 0;
  };

  struct Connection {
    Phase phase = Phase::closed;
    // While it is running.
    std::optional<Waiting> waiting = {};
    // The session whose transaction is open on it.
    std::optional<SessionId> session = {};
    Moment transaction_ends = Moment::max();
    Access access = Access::write;
  };

  void end_transactions(Moment now);
  void expire(Moment now);
  void assign();
  bool assign(Waiting& waiting);
  std::optional<Error> objection(const DatabaseOrder& order);
  void open_if_needed(Moment now);
  void open(Place place);
  void succeeded(Connection& connection, DatabaseCommand kind, Moment now);
  void failed(Place place, Waiting waiting, const Error& error, Moment now,
              const State& state);
  void lose(Place place, Waiting waiting, const Error& error, Moment now,
            bool in_doubt);
  void close(Place place);
  void take_away(Place place);
  void tell(Waiting&& waiting, StatementOutcome outcome);

  std::optional<Place> holder(const SessionId& session) const;
  std::optional<Place> free_place(Access access) const;
  std::optional<Place> place_in(Phase phase) const;
  bool is_connected() const;
  bool somebody_needs_one() const;
  Error why_it_waited() const;

  const Limits limits_;
  std::vector<Connection> connections_;
  std::deque<Waiting> queue_;
  std::vector<Deed> deeds_;
  std::vector<Answer> answers_;
  LostTransactions lost_;
  bool set_up_ = false;
  // Of attempts to connect that fail in succession.
  Backoff backoff_{Milliseconds(50), Milliseconds(5'000)};
  // The earliest time of the next attempt; the default has long passed.
  Moment next_attempt_{};
  // When to try, because an order needs a connection; max if none does.
  Moment open_at_ = Moment::max();
  // Why the last attempt failed.
  std::optional<Error> trouble_;
};

} // namespace parlour::adapters
