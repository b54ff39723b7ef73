// SQLiteTransactions keeps track of which session holds the database's only
// transaction and which messages wait for its end. It runs no statement; the
// plug-in does. Not thread-safe.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "adapters/database/lost_transactions.hpp"
#include "runtime/message/message.hpp"

namespace parlour::adapters {

class SQLiteTransactions {
public:
  // A number that names one transaction or one waiting message, and is never
  // used again. A timer that fires late finds by it that its transaction has
  // ended.
  using Ticket = std::uint64_t;

  bool held() const {
    return holder_.has_value();
  }
  bool held_by(const SessionId& session) const {
    return holder_ == session;
  }
  // Whether the session's transaction was taken away and the session has not
  // been told (see LostTransactions).
  bool lost_by(const SessionId& session) const;

  // Makes the session the holder. There must be none.
  Ticket hold(const SessionId& session);
  bool holds(Ticket ticket) const {
    return held() && ticket_ == ticket;
  }
  // The ticket of the current or last holder.
  Ticket ticket() const {
    return ticket_;
  }
  // The holder's transaction ended as the holder asked.
  void release();
  // The holder's transaction was rolled back against its will.
  void take_away();
  void forget_loss(const SessionId& session);

  // Adds a message to the queue, or returns nothing if the queue is full.
  std::optional<Ticket> wait(const Message& message);
  struct Waiting {
    Ticket ticket;
    Message message;
  };
  // Removes the message that has waited longest.
  std::optional<Waiting> next();
  // Removes the message with this ticket, if it still waits.
  std::optional<Message> leave(Ticket ticket);

private:
  std::optional<SessionId> holder_;
  LostTransactions lost_;
  std::deque<Waiting> waiting_;
  // The holder's ticket, and the last ticket that was given to any message.
  Ticket ticket_ = 0;
  Ticket last_ticket_ = 0;
};

} // namespace parlour::adapters
