// Playout decides what a speaker plays: utterances one after the other, faded
// when they are stopped. It knows no device; whoever has one pulls samples,
// says how many of them have been heard, and carries out the events.
//
// Utterances belong to the session that sent them, so two sessions may use the
// same numbers.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "adapters/audio/utterance.hpp"
#include "runtime/base/clock.hpp"

namespace parlour::adapters {

struct PlayoutLimits {
  Milliseconds longest{300'000}; // of audio that waits
  std::size_t utterances = 100;
  std::size_t marks = 10'000;  // of all utterances
  std::size_t pieces = 50'000; // messages with audio that waits
  // An utterance begins once so much of it is there, because its audio may come
  // just in time, or when it has waited for that long.
  Milliseconds preroll{40};
  // An utterance gets no more audio, nor its end, for so long while it is the
  // next: whoever spoke it is gone.
  Milliseconds patience{10'000};
};

// An event of the role Speaker, for the message `to`.
struct PlayoutEvent {
  std::uint64_t at; // how many samples were pulled before it
  Message to;
  std::string command; // Started, Playing or Finished
  std::vector<Value> params;
};

// For one thread at a time.
class Playout {
public:
  // All audio has 16,000 samples a second and one channel.
  explicit Playout(PlayoutLimits limits = {});

  // Commands of the role Speaker. Errors say why the message is refused.
  Expected<void> play(const Message& from, std::int64_t utterance,
                      const Value& audio);
  Expected<void> mark(const Message& from, std::int64_t utterance,
                      const std::string& word, std::int64_t position);
  Expected<void> finish(const Message& from, std::int64_t utterance);
  // All utterances of the session if none is named.
  void stop(const SessionId& session, std::optional<std::int64_t> utterance);

  // Fills `out` with what goes out next; returns how many of the samples, from
  // the first, may be more than silence.
  std::size_t pull(std::span<Sample> out);
  // What has happened before so many of all samples were heard, in order. Each
  // event is returned once.
  std::vector<PlayoutEvent> events(std::uint64_t heard);
  // The device is lost: what was pulled beyond `heard` never sounds, and every
  // utterance is over. Returns all events that are left.
  std::vector<PlayoutEvent> abandon(std::uint64_t heard);

  std::uint64_t pulled() const {
    return pulled_;
  }
  // No utterance is there: only silence would be pulled.
  bool is_idle() const {
    return queue_.empty();
  }
  // The same, but events that nobody has been told of count, too.
  bool has_work() const {
    return !queue_.empty() || !events_.empty();
  }
  // The event Playing for the samples that were pulled last, of which some are
  // more than silence: its position is that of the first of them, in ms of the
  // audio of its utterance.
  PlayoutEvent playing(std::span<const Sample> samples) const;

private:
  // The end of an utterance whose Finish has not come yet.
  struct Ended {
    SessionId session;
    std::int64_t utterance;
    std::vector<Value> params;
  };

  Utterance* find(const SessionId& session, std::int64_t utterance);
  std::deque<Ended>::iterator find_ended(const SessionId& session,
                                         std::int64_t utterance);
  // The utterance, which is added if it is new; an error if there are too many.
  Expected<Utterance*> find_or_add(const Message& from, std::int64_t utterance);
  bool may_begin(const Utterance& utterance) const;
  // Moves samples of the first utterance to `out`, which begins `offset`
  // samples after what was pulled before.
  std::size_t take(std::span<Sample> out, std::size_t offset);
  void count_waiting(std::size_t silent);
  void end_first(std::uint64_t at, std::size_t heard);
  void end(Utterance utterance, std::uint64_t at, std::size_t heard);

  PlayoutLimits limits_;
  std::deque<Utterance> queue_; // the first one is being played
  std::deque<PlayoutEvent> events_;
  std::deque<Ended> ended_;
  std::uint64_t pulled_ = 0;
  std::size_t waited_ = 0; // samples of silence for the first utterance
  Message sounding_;       // the order of the utterance that sounded last
  std::int64_t position_ = 0;
};

} // namespace parlour::adapters
