// Link is one side of the promise that no message between the platform and an
// agent is lost or received twice (adapters/agents/PROTOCOL.md 4). It outlives
// connections. The platform has one for each agent, and the program `parlour
// agent` has one for the platform.
//
// Each side numbers its messages. The sender keeps them until they are
// acknowledged, and after a gap or a new connection sends them again. The
// receiver takes them in order only:
//
//  sender                           receiver
//  outbox_ [5][6][7][8]             received_ = 6, handed_on_ = 5
//  acknowledged_ = 4, sent_ = 4     7 was lost; 8 is dropped, gap_ is set
//
// A plain state machine without socket, thread or clock. Its owner tells it
// what has arrived and what time it is, and write_output()
// gives it what is to be written to the current connection. Not thread-safe.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "adapters/agents/delivery/outbox.hpp"
#include "adapters/agents/wire/agent_message.hpp"
#include "runtime/base/clock.hpp"

namespace parlour::adapters::agents {

// What a side says about itself when a connection begins
// (adapters/agents/PROTOCOL.md 3.1 and 3.2).
struct Introduction {
  // Empty: a new one each time.
  std::string incarnation;
  // The other side's last message that this side has, and of which incarnation.
  std::string seen_incarnation;
  std::uint64_t seen_number = 0;
  std::uint64_t window = 100;
  // It reads packed messages (2.5). The link does not know.
  bool packed = false;

  bool operator==(const Introduction&) const = default;
};

class Link {
public:
  // The limits and times of adapters/agents/PROTOCOL.md 4.2 to 4.5.
  static constexpr std::size_t max_waiting = 1000;
  static constexpr std::size_t max_waiting_bytes = 4 << 20;
  static constexpr std::uint64_t usual_window = 100;
  // Half of what the protocol allows: the other half is for the owner's timer.
  static constexpr Milliseconds ack_after{50};
  static constexpr Milliseconds beat_after{1000};
  static constexpr Milliseconds offline_after{3000};
  // Messages without number: nothing else holds them back.
  static constexpr int max_unnumbered_per_second = 1000;

  // `window`: how many messages the peer may send ahead.
  explicit Link(std::string incarnation, std::uint64_t window = usual_window);

  // What this side's next hello or welcome is to say.
  Introduction introduction() const;

  // Whether the peer remembers this side, and this side the peer: both go on
  // where they were. Otherwise both begin afresh.
  bool goes_on_with(const Introduction& peer) const;
  // The peer has received more of this incarnation than this side knows to have
  // sent: to it, this side must be another one (renew()).
  bool is_behind(const Introduction& peer) const;
  // Who begins afresh although the other side would go on must look to it like
  // another process, so that it does the same.
  void renew(std::string incarnation);
  // The peer's hello or welcome has arrived: messages may be exchanged.
  void connect(const Introduction& peer, Timestamp now);
  // The connection has ended. Messages that wait are kept.
  void disconnect();
  // Whether the peer can go on where it was, if it connects again: a peer
  // without an incarnation cannot.
  bool may_return() const {
    return !peer_incarnation_.empty();
  }
  // Requests that wait for the peer have ended without it: nobody must carry
  // them out later. Each leaves an empty message with its number behind
  // (adapters/agents/PROTOCOL.md 4.8).
  void withdraw_requests();
  bool is_connected() const {
    return connected_;
  }

  // Returns what waits, because the peer has stayed away, and forgets the peer.
  std::vector<AgentMessage> give_up();

  // Queues a `text` or `binary` message. False if the outbox is full: the
  // message is left as it was, and its author must be told
  // (adapters/agents/PROTOCOL.md 4.3).
  bool send(AgentMessage&& message);
  std::size_t waiting() const {
    return outbox_.size();
  }
  bool has_half_free() const {
    return outbox_.size() <= max_waiting / 2 &&
           outbox_bytes_ <= max_waiting_bytes / 2;
  }

  // What is to be done with a message that has arrived.
  struct Arrival {
    // The owner hands the message on, then calls handed_on() if it has a
    // number.
    bool deliver = false;
    // What was wrong with it. After the kind `flood` the connection ends.
    std::optional<WireError> error;
  };
  // Takes any message but hello and welcome, and reads the acknowledgement in
  // it.
  Arrival receive(const AgentMessage& message, Timestamp now);
  // Some bytes have arrived, which need not be a whole message.
  void heard(Timestamp now) {
    heard_ = now;
  }
  // The oldest delivered message that was not reported yet has reached its
  // receiver and may be acknowledged.
  void handed_on();

  // To be called as time passes. False if the peer has been silent for too
  // long: the owner closes the connection and calls disconnect().
  bool tick(Timestamp now) const;
  // When tick() has something to do next; nothing without a connection.
  std::optional<Timestamp> next_tick() const;

  // Gets a message that is to be written. It must not call the link.
  using Write = std::function<void(const AgentMessage& message)>;
  // Writes what is to be written now; nothing without a connection.
  void write_output(Timestamp now, const Write& write);
  // So much has been received and not yet acknowledged that it should be done
  // now, and not only when the time has come.
  bool owes_many() const {
    return handed_on_ - told_ >= own_window_ / 2;
  }

private:
  void erase_withdrawn();
  void acknowledged(std::uint64_t number);
  void begin_afresh();
  std::optional<WireError> take_acknowledgement(const AgentMessage& message);
  Arrival take_numbered(std::uint64_t number, Timestamp now);
  Arrival take_withdrawn(std::uint64_t number, Timestamp now);
  Arrival take_unnumbered(Timestamp now);
  bool write_messages(const Write& write);
  bool write_own_ack(Timestamp now, const Write& write);
  AgentMessage own_ack();
  AgentMessage own_beat();
  bool beat_is_due(bool is_silent, Timestamp now) const;
  bool ack_is_due(Timestamp now) const;
  void acknowledge_in(AgentMessage& message);
  std::uint64_t last_sent() const;

  std::string incarnation_;
  std::uint64_t own_window_;
  // Empty: no peer yet, or one at a terminal, who sends no beats.
  std::string peer_incarnation_;
  bool connected_ = false;

  // To the peer. The outbox holds the messages after acknowledged_, in the
  // order of their numbers; the first `sent_` of them went out on the present
  // connection.
  Outbox outbox_;
  std::size_t outbox_bytes_ = 0;
  std::size_t sent_ = 0;
  std::uint64_t acknowledged_ = 0;
  // The highest number that went out to this process: what was sent again may
  // be acknowledged twice.
  std::uint64_t highest_sent_ = 0;
  std::uint64_t peer_window_ = usual_window;

  // From the peer, as numbers of messages: the last that arrived, the last that
  // the platform has taken, and the last that was acknowledged. told_ <=
  // handed_on_ <= received_.
  std::uint64_t received_ = 0;
  std::uint64_t handed_on_ = 0;
  std::uint64_t told_ = 0;
  // A gap is to be reported with the next acknowledgement.
  bool gap_ = false;
  // The gap has been reported, and the missing message has not arrived yet.
  bool gap_is_told_ = false;

  // When something last arrived, and when something was last sent.
  Timestamp heard_ = 0;
  Timestamp said_ = 0;
  // When the peer was last told the number of the last message.
  Timestamp number_said_ = 0;
  Timestamp unacknowledged_since_ = 0;
  // The present second of messages without number, and how many it has had.
  Timestamp unnumbered_since_ = 0;
  int unnumbered_ = 0;
};

} // namespace parlour::adapters::agents
