#include "adapters/agents/delivery/link.hpp"

#include <algorithm>
#include <utility>

namespace parlour::adapters::agents {
namespace {

bool is_numbered_kind(MessageKind kind) {
  return kind == MessageKind::text || kind == MessageKind::binary;
}

bool is_withdrawn(const AgentMessage& message) {
  return is_numbered_kind(message.kind) && message.number &&
         message.command.empty();
}

} // namespace

Link::Link(std::string incarnation, std::uint64_t window)
    : incarnation_(std::move(incarnation)), own_window_(window) {}

Introduction Link::introduction() const {
  return {incarnation_, peer_incarnation_, received_, own_window_, false};
}

// -- the connection -----------------------------------------------------------

// The same incarnation is the same process. But it may have spoken with another
// process in between, and then it numbers its messages for that one.
bool Link::goes_on_with(const Introduction& peer) const {
  return !peer.incarnation.empty() && peer.incarnation == peer_incarnation_ &&
         peer.seen_incarnation == incarnation_ &&
         peer.seen_number >= acknowledged_ && peer.seen_number <= highest_sent_;
}

bool Link::is_behind(const Introduction& peer) const {
  return peer.seen_incarnation == incarnation_ &&
         peer.seen_number > highest_sent_;
}

void Link::renew(std::string incarnation) {
  incarnation_ = std::move(incarnation);
}

// A peer that goes on says what it has received, and the rest is sent again.
// Another one begins with number 1.
void Link::connect(const Introduction& peer, Timestamp now) {
  const bool is_same = goes_on_with(peer);
  if (!is_same)
    begin_afresh();
  peer_incarnation_ = peer.incarnation;
  peer_window_ = std::max<std::uint64_t>(peer.window, 1);
  sent_ = 0;
  if (is_same)
    acknowledged(peer.seen_number);
  connected_ = true;
  gap_ = gap_is_told_ = false;
  heard_ = said_ = number_said_ = now;
}

void Link::disconnect() {
  connected_ = false;
}

void Link::withdraw_requests() {
  for (std::size_t i = 0; i < outbox_.size(); ++i) {
    auto& message = outbox_[i];
    if (!message.deadline)
      continue;
    outbox_bytes_ -= content_bytes(message);
    AgentMessage withdrawn;
    withdrawn.number = message.number;
    message = std::move(withdrawn);
  }
}

void Link::erase_withdrawn() {
  for (auto& message : outbox_.take())
    if (!is_withdrawn(message))
      outbox_.push_back(std::move(message));
}

std::vector<AgentMessage> Link::give_up() {
  erase_withdrawn();
  auto waiting = outbox_.take();
  outbox_bytes_ = sent_ = 0;
  peer_incarnation_.clear();
  return waiting;
}

// Another process is at the other end. What waits gets the numbers that it
// expects.
void Link::begin_afresh() {
  acknowledged_ = highest_sent_ = received_ = handed_on_ = told_ = 0;
  erase_withdrawn();
  for (std::size_t i = 0; i < outbox_.size(); ++i)
    outbox_[i].number = i + 1;
}

// -- sending ------------------------------------------------------------------

bool Link::send(AgentMessage&& message) {
  const auto bytes = content_bytes(message);
  if (outbox_.size() >= max_waiting ||
      outbox_bytes_ + bytes > max_waiting_bytes)
    return false;
  message.number = acknowledged_ + outbox_.size() + 1;
  outbox_bytes_ += bytes;
  outbox_.push_back(std::move(message));
  return true;
}

std::uint64_t Link::last_sent() const {
  return acknowledged_ + sent_;
}

// Forgets the messages up to this number.
void Link::acknowledged(std::uint64_t number) {
  while (acknowledged_ < number && !outbox_.empty()) {
    outbox_bytes_ -= content_bytes(outbox_.front());
    outbox_.pop_front();
    ++acknowledged_;
    sent_ -= std::min<std::size_t>(sent_, 1);
  }
}

// Every message may carry an acknowledgement, which saves messages of their
// own.
void Link::acknowledge_in(AgentMessage& message) {
  if (handed_on_ > 0)
    message.acknowledged = handed_on_;
  else
    message.acknowledged.reset();
  told_ = handed_on_;
}

// As many as the peer's window allows. They stay in the outbox, and are not
// copied.
bool Link::write_messages(const Write& write) {
  const auto before = sent_;
  while (sent_ < outbox_.size() && sent_ < peer_window_) {
    auto& message = outbox_[sent_++];
    acknowledge_in(message);
    write(message);
  }
  highest_sent_ = std::max(highest_sent_, last_sent());
  return sent_ > before;
}

// After half of the window or 100 ms, whichever comes first.
bool Link::ack_is_due(Timestamp now) const {
  return owes_many() || (handed_on_ > told_ &&
                         now - unacknowledged_since_ >= ack_after.count());
}

void Link::write_output(Timestamp now, const Write& write) {
  if (!connected_)
    return;
  bool has_spoken = write_messages(write);
  if (has_spoken)
    number_said_ = now;
  has_spoken |= write_own_ack(now, write);
  if (beat_is_due(!has_spoken, now)) {
    write(own_beat());
    has_spoken = true;
    number_said_ = now;
  }
  if (has_spoken)
    said_ = now;
}

bool Link::write_own_ack(Timestamp now, const Write& write) {
  if (!gap_ && !ack_is_due(now))
    return false;
  write(own_ack());
  return true;
}

// Acknowledgements do not tell the last number: if they are all that is said,
// the peer would not notice that the last message was lost.
bool Link::beat_is_due(bool is_silent, Timestamp now) const {
  return (is_silent && now - said_ >= beat_after.count()) ||
         (sent_ > 0 && now - number_said_ >= beat_after.count());
}

AgentMessage Link::own_ack() {
  AgentMessage own;
  own.kind = MessageKind::ack;
  own.gap = std::exchange(gap_, false);
  acknowledge_in(own);
  // 0 as well: the peer learns that nothing has arrived.
  own.acknowledged = handed_on_;
  return own;
}

AgentMessage Link::own_beat() {
  AgentMessage own;
  own.kind = MessageKind::beat;
  acknowledge_in(own);
  if (last_sent() > 0)
    own.number = last_sent();
  return own;
}

// -- receiving ----------------------------------------------------------------

Link::Arrival Link::receive(const AgentMessage& message, Timestamp now) {
  heard_ = now;
  if (auto error = take_acknowledgement(message))
    return {false, std::move(error)};
  if (is_withdrawn(message))
    return take_withdrawn(*message.number, now);
  if (is_numbered_kind(message.kind))
    return message.number ? take_numbered(*message.number, now)
                          : take_unnumbered(now);
  // The number of the peer's last message: if the last ones were lost, nothing
  // that follows shows it.
  if (message.kind == MessageKind::beat && message.number)
    gap_ = gap_ || *message.number > received_;
  return {};
}

std::optional<WireError>
Link::take_acknowledgement(const AgentMessage& message) {
  if (!message.acknowledged)
    return {};
  if (*message.acknowledged > highest_sent_)
    return WireError{WireErrorKind::malformed,
                     "acknowledges what was never sent"};
  acknowledged(*message.acknowledged);
  if (message.window)
    peer_window_ = std::max<std::uint64_t>(*message.window, 1);
  if (message.gap)
    // Everything after the acknowledged number is sent again.
    sent_ = 0;
  return {};
}

Link::Arrival Link::take_unnumbered(Timestamp now) {
  if (now - unnumbered_since_ >= 1000) {
    unnumbered_since_ = now;
    unnumbered_ = 0;
  }
  if (++unnumbered_ > max_unnumbered_per_second)
    return {false, WireError{WireErrorKind::flood,
                             "more messages without number came than a second "
                             "may have"}};
  return {true, {}};
}

Link::Arrival Link::take_numbered(std::uint64_t number, Timestamp now) {
  if (number <= received_) {
    // Received before: its acknowledgement was lost with a connection, and is
    // sent again.
    told_ = std::min(told_, number - 1);
    return {};
  }
  if (number > handed_on_ + own_window_)
    return {false, WireError{WireErrorKind::flood,
                             "more messages came than the window allows"}};
  if (number != received_ + 1) {
    // Reported once for each gap: messages that follow it and are on their way
    // say nothing new.
    gap_ = gap_ || !gap_is_told_;
    gap_is_told_ = true;
    return {};
  }
  gap_is_told_ = false;
  received_ = number;
  if (handed_on_ == told_)
    unacknowledged_since_ = now;
  return {true, {}};
}

// It counts like any other, but means nothing to anybody.
Link::Arrival Link::take_withdrawn(std::uint64_t number, Timestamp now) {
  auto arrival = take_numbered(number, now);
  if (std::exchange(arrival.deliver, false))
    handed_on();
  return arrival;
}

void Link::handed_on() {
  if (handed_on_ < received_)
    ++handed_on_;
}

// -- time ---------------------------------------------------------------------

bool Link::tick(Timestamp now) const {
  return !connected_ || peer_incarnation_.empty() ||
         now - heard_ < offline_after.count();
}

std::optional<Timestamp> Link::next_tick() const {
  if (!connected_)
    return {};
  auto next = said_ + beat_after.count();
  if (!peer_incarnation_.empty())
    next = std::min(next, heard_ + offline_after.count());
  if (sent_ > 0)
    next = std::min(next, number_said_ + beat_after.count());
  if (handed_on_ > told_)
    next = std::min(next, unacknowledged_since_ + ack_after.count());
  return next;
}

} // namespace parlour::adapters::agents
