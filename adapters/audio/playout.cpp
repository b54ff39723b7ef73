#include "adapters/audio/playout.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "runtime/plugin/open_messages.hpp"

namespace parlour::adapters {

namespace {

constexpr std::size_t max_ended = 100;
constexpr std::size_t max_word = 1'000; // bytes

std::size_t samples(Milliseconds time) {
  return static_cast<std::size_t>(time.count()) * speech_rate / 1'000;
}

tl::unexpected<Error> too_much(const std::string& what) {
  return fail(ErrorKind::limit,
              what + " wait to be played; send less at a time");
}

template <class Count>
std::size_t sum(const std::deque<Utterance>& queue, Count count) {
  std::size_t all = 0;
  for (const auto& one : queue)
    all += (one.*count)();
  return all;
}

} // namespace

Playout::Playout(PlayoutLimits limits) : limits_(limits) {}

// -- commands
// ------------------------------------------------------------------

Utterance* Playout::find(const SessionId& session, std::int64_t utterance) {
  const auto found = std::ranges::find_if(
      queue_, [&](const Utterance& one) { return one.is(session, utterance); });
  return found == queue_.end() ? nullptr : &*found;
}

std::deque<Playout::Ended>::iterator
Playout::find_ended(const SessionId& session, std::int64_t utterance) {
  return std::ranges::find_if(ended_, [&](const Ended& one) {
    return one.session == session && one.utterance == utterance;
  });
}

Expected<Utterance*> Playout::find_or_add(const Message& from,
                                          std::int64_t utterance) {
  if (auto* known = find(from.session, utterance))
    return known;
  if (queue_.size() >= limits_.utterances)
    return too_much(std::to_string(queue_.size()) + " utterances");
  return &queue_.emplace_back(without_its_way(from), utterance);
}

// What was stopped may still be on its way from a voice, and is dropped.
Expected<void> Playout::play(const Message& from, std::int64_t utterance,
                             const Value& audio) {
  const auto samples_of_it = speech_samples(audio);
  if (!samples_of_it)
    return tl::make_unexpected(samples_of_it.error());
  if (find_ended(from.session, utterance) != ended_.end())
    return {};
  const auto waiting = sum(queue_, &Utterance::waiting) + samples_of_it->size();
  if (waiting > samples(limits_.longest))
    return too_much(std::to_string(limits_.longest.count() / 1'000) +
                    " seconds of sound");
  if (sum(queue_, &Utterance::piece_count) >= limits_.pieces)
    return too_much("too many pieces of sound");
  return find_or_add(from, utterance).map([&](Utterance* one) {
    one->append(audio, *samples_of_it);
  });
}

Expected<void> Playout::mark(const Message& from, std::int64_t utterance,
                             const std::string& word, std::int64_t position) {
  if (find_ended(from.session, utterance) != ended_.end())
    return {};
  if (word.size() > max_word)
    return fail(ErrorKind::limit, "this word is too long for a mark");
  if (sum(queue_, &Utterance::mark_count) >= limits_.marks)
    return too_much("too many words");
  return find_or_add(from, utterance).map([&](Utterance* one) {
    one->mark(word, position);
  });
}

// An utterance that was stopped has been reported, so only somebody who waits
// for the answer gets it again. An utterance without audio is over at once.
Expected<void> Playout::finish(const Message& from, std::int64_t utterance) {
  auto order = without_its_way(from);
  if (const auto ended = find_ended(from.session, utterance);
      ended != ended_.end()) {
    if (from.correlation != 0)
      events_.push_back({pulled_, order, "Finished", std::move(ended->params)});
    ended_.erase(ended);
    return {};
  }
  auto* one = find(from.session, utterance);
  if (!one)
    events_.push_back(
        {pulled_, order, "Finished", {utterance, 0, false, Value()}});
  else if (one->is_finished())
    return fail(ErrorKind::refused, "this utterance is finished already");
  else
    one->finish(std::move(order));
  return {};
}

void Playout::stop(const SessionId& session,
                   std::optional<std::int64_t> utterance) {
  for (auto& one : queue_)
    if (one.is(session, utterance.value_or(one.id())))
      one.stop();
  // The first one fades; the others never begin.
  auto before = std::exchange(queue_, {});
  for (auto& one : before) {
    const auto heard = one.taken();
    if (one.is_over() && one.is_stopped())
      end(std::move(one), pulled_, heard);
    else
      queue_.push_back(std::move(one));
  }
}

// -- sound
// ---------------------------------------------------------------------

bool Playout::may_begin(const Utterance& utterance) const {
  const auto enough = samples(limits_.preroll);
  return utterance.taken() > 0 || utterance.is_finished() ||
         utterance.waiting() >= enough || waited_ >= enough;
}

std::size_t Playout::take(std::span<Sample> out, std::size_t offset) {
  auto& first = queue_.front();
  if (!may_begin(first))
    return 0;
  const auto before = first.taken();
  const auto count = first.take(out);
  if (count > 0 && before == 0)
    events_.push_back(
        {pulled_ + offset, first.order(), "Started", {first.id()}});
  if (count > 0 && offset == 0) {
    sounding_ = first.order();
    position_ = duration(before);
  }
  return count;
}

std::size_t Playout::pull(std::span<Sample> out) {
  std::size_t done = 0;
  while (done < out.size() && !queue_.empty()) {
    const auto count = take(out.subspan(done), done);
    done += count;
    if (count > 0)
      waited_ = 0;
    if (queue_.front().is_over())
      end_first(pulled_ + done, queue_.front().taken());
    else if (count == 0)
      break;
  }
  std::ranges::fill(out.subspan(done), Sample{0});
  pulled_ += out.size();
  if (!queue_.empty())
    count_waiting(out.size() - done);
  return done;
}

// An utterance whose audio stops coming would keep the others waiting for ever.
void Playout::count_waiting(std::size_t silent) {
  waited_ += silent;
  if (waited_ < samples(limits_.patience))
    return;
  queue_.front().stop();
  end_first(pulled_, queue_.front().taken());
}

void Playout::end_first(std::uint64_t at, std::size_t heard) {
  auto first = std::move(queue_.front());
  queue_.pop_front();
  waited_ = 0;
  end(std::move(first), at, heard);
}

void Playout::end(Utterance utterance, std::uint64_t at, std::size_t heard) {
  std::vector<Value> params = {utterance.id(), duration(heard),
                               utterance.is_stopped(),
                               utterance.spoken_text(heard)};
  events_.push_back({at, utterance.order(), "Finished", params});
  if (utterance.is_finished())
    return;
  if (ended_.size() >= max_ended)
    ended_.pop_front();
  ended_.push_back(
      {utterance.order().session, utterance.id(), std::move(params)});
}

PlayoutEvent Playout::playing(std::span<const Sample> samples) const {
  return {pulled_, sounding_, "Playing", {pcm_value(samples), position_}};
}

// -- events
// --------------------------------------------------------------------

std::vector<PlayoutEvent> Playout::events(std::uint64_t heard) {
  const auto end = std::ranges::find_if(
      events_, [&](const PlayoutEvent& event) { return event.at > heard; });
  std::vector<PlayoutEvent> due(std::make_move_iterator(events_.begin()),
                                std::make_move_iterator(end));
  events_.erase(events_.begin(), end);
  return due;
}

// Only the first utterance can have samples on their way to the ear, but for
// the last moments of the one before it, which counts as played.
std::vector<PlayoutEvent> Playout::abandon(std::uint64_t heard) {
  const auto lost =
      static_cast<std::size_t>(pulled_ - std::min(pulled_, heard));
  while (!queue_.empty()) {
    auto& first = queue_.front();
    first.stop();
    const auto taken = first.taken();
    end_first(pulled_, taken - std::min(taken, lost));
  }
  return events(pulled_);
}

} // namespace parlour::adapters
