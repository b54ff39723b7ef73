// Who holds the one transaction that a database has at a time, and who waits.
// Bookkeeping alone; the plug-in runs the statements.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "adapters/database/lost_transactions.hpp"
#include "runtime/base/message.hpp"

namespace parlour::adapters {

class SQLiteTransactions {
public:
  using Ticket = std::uint64_t;

  bool held() const {
    return holder_.has_value();
  }
  bool held_by(const SessionId& session) const {
    return holder_ == session;
  }
  // Its transaction was taken away and it has not been told yet; known of the
  // latest only, as sessions may never ask.
  bool lost_by(const SessionId& session) const;

  // The ticket names this holding, so that a late timeout ends no other.
  Ticket hold(const SessionId& session);
  bool holds(Ticket ticket) const {
    return held() && ticket_ == ticket;
  }
  // Of the holder, where there is one.
  Ticket ticket() const {
    return ticket_;
  }
  void release();
  void take_away();
  void forget_loss(const SessionId& session);

  // Nothing where too many wait already.
  std::optional<Ticket> wait(const Message& message);
  struct Waiting {
    Ticket ticket;
    Message message;
  };
  // What waits longest, or the message with the ticket.
  std::optional<Waiting> next();
  std::optional<Message> leave(Ticket ticket);

private:
  std::optional<SessionId> holder_;
  LostTransactions lost_;
  std::deque<Waiting> waiting_;
  Ticket ticket_ = 0;      // of the holder
  Ticket last_ticket_ = 0; // given to anybody
};

} // namespace parlour::adapters
