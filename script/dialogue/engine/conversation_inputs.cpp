// The part of a conversation that says what happens with each input, and what
// silence leads to (engine rules 1 to 3).
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <utility>

#include "script/dialogue/engine/conversation_implementation.hpp"
#include "script/dialogue/engine/effects/heard_texts.hpp"

namespace parlour::dialogue {

namespace {

using namespace std::string_view_literals;

const std::string recogniser = "ASR";
const std::string endpointer = "Endpointer";

// Where the end of a turn is never told: no endpointer takes that long.
constexpr Milliseconds longest_turn{300'000};

// What the engine itself has an ear for, besides who reacts to it.
constexpr std::string_view heard_commands[] = {
    "RecognitionResult", "SpeechStarted", "Partial",      "Rejected",
    "TurnStarted",       "TurnEnded",     "TurnDropped",  "Finished",
    "AgentOnline",       "AgentOffline",  "PhraseFailed", "Failed"};

constexpr std::uint64_t lengths_of_heard = [] {
  std::uint64_t lengths = 0;
  for (const auto command : heard_commands)
    lengths |= std::uint64_t{1} << command.size();
  return lengths;
}();

// Most messages are none of them, which mostly their length tells.
bool is_heard(const Message& message) {
  const auto length = message.command.size();
  return length < 64 && (lengths_of_heard >> length & 1) != 0 &&
         std::ranges::find(heard_commands, message.command) !=
             std::end(heard_commands);
}

// How long the words of a user who was heard to speak may take to arrive;
// nothing: the message tells of no speech. A turn that has started lasts until
// its end is told.
std::optional<Milliseconds> words_come_within(const Port& port,
                                              const Message& message) {
  const auto is = [&](std::string_view command, const std::string& role) {
    return message.command == command && port.is_source(role, message.source);
  };
  if (is("TurnStarted", endpointer))
    return longest_turn;
  if (is("TurnEnded", endpointer) || is("SpeechStarted", "VAD") ||
      is("Partial", recogniser))
    return defaults::speech_without_words;
  return std::nullopt;
}

bool is_rejected(const Port& port, const Message& message) {
  return message.command == "Rejected"sv &&
         port.is_source(recogniser, message.source);
}

bool ends_speech(const Port& port, const Message& message) {
  return is_rejected(port, message) ||
         (message.command == "TurnDropped"sv &&
          port.is_source(endpointer, message.source));
}

} // namespace

// -- inputs -------------------------------------------------------------------

// A message is only put into its turn here. Whatever arrives together is so
// known before any of it is dealt with.
void ConversationImplementation::receive(
    std::shared_ptr<const Message> message) {
  const bool heard = is_heard(*message);
  Input input{.message = message};
  input.begins_turn = heard && message->command == "RecognitionResult"sv &&
                      context.port.is_source(recogniser, message->source);
  if (input.begins_turn && !context.turns.any_said(context.now))
    output.user_speaks();
  input.turn = input.begins_turn ? context.turns.begin(heard_texts(*message))
                                 : context.turns.of(message->correlation);
  const bool begins_turn = input.begins_turn;
  inbox.receive(std::move(input));
  if (heard) // known before a release
    note_speech(*message, std::max(context.now, message->time));
  if (!begins_turn)
    context.turns.answered(message->correlation);
}

// What a <fire> of the recogniser's message would lead to.
void ConversationImplementation::take_acts(std::span<const ActPointer> acts) {
  begin_event();
  user_begins();
  output.user_speaks();
  const auto turn = context.turns.begin();
  StepList item;
  for (const auto& act : acts) {
    context.turns.hold(turn);
    item.add(steps::TakeAct{act, turn});
  }
  item.add(steps::Conclude{turn});
  context.lane.queue(std::move(item));
  go_on();
}

void ConversationImplementation::user_begins() {
  stop_silence();
  output.turn_begins();
}

// While the session ends it only hears what is not the user's: the words that
// it still waits for.
Inbox::Of ConversationImplementation::heard() const {
  return context.ending.is_wished() ? Inbox::Of::all_but_user : Inbox::Of::all;
}

bool ConversationImplementation::has_work() const {
  return !context.ending.is_over() && !topics.awaiting_frame() &&
         (output.wants_release() || !lost_.empty() || runner.has_slices() ||
          inbox.has_internal() || inbox.has_message(heard()));
}

void ConversationImplementation::begin_event() {
  inbox.external_event_begins();
  interpreter.new_event();
  output.event_begins();
}

// Outputs first: by the time of this step, whatever was in the mailbox is in
// the inbox, so that a turn that has begun is known (engine rule 3).
void ConversationImplementation::take_input() {
  if (output.wants_release()) {
    if (output.release())
      stop_silence();
  } else if (!lost_.empty()) {
    begin_event();
    end_wait(lost_.take());
  } else if (auto slice = runner.take_slice(); slice != 0) {
    end_wait({slice, Value()});
  } else if (inbox.has_internal()) {
    auto input = inbox.take_internal();
    if (messenger.one_more_internal_event())
      process(std::move(input));
    else
      output.drop(input);
  } else if (auto input = inbox.take_message(heard())) {
    begin_event();
    process(std::move(*input));
  }
  go_on();
}

// First what the engine itself hears in it, then a request that waits for it,
// then the reactions of scripts.
void ConversationImplementation::process(Input&& input) {
  const auto& message = *input.message;
  if (context.port.is_source(recogniser, message.source)) {
    context.privacy.hear(question.asks_in_private());
    user_begins();
  }
  if (input.begins_turn)
    output.give_up_interrupted();
  input.is_unclear = is_rejected(context.port, message) &&
                     context.turns.speaking(context.now) && output.silent() &&
                     !output.was_interrupted();
  if (is_heard(message) && (hear_speech(message) || hear_speaker(message) ||
                            machine.agent_changed(message) ||
                            output.hear_failure(message, input.turn)))
    input.raised = true;                     // somebody took it
  if (auto over = requests.reply(message)) { // a script's loop may have many
    end_wait(std::move(*over));
    context.turns.let_go(input.turn);
  } else {
    inbox.handles(message);
    pipeline.take(std::move(input));
  }
}

// Where the user was heard to speak. Partial results tell nothing of how long
// the turn goes on; its end does.
void ConversationImplementation::note_speech(const Message& message,
                                             Timestamp now) {
  const auto lasts = words_come_within(context.port, message);
  if (!lasts)
    return;
  if (message.command == "Partial"sv)
    context.turns.speaks_on(now + lasts->count());
  else
    context.turns.speaks(now + lasts->count());
}

// Barge-in (engine rule 3).
bool ConversationImplementation::hear_speech(const Message& message) {
  if (ends_speech(context.port, message))
    context.turns.speech_is_over();
  if (!words_come_within(context.port, message))
    return false;
  // It was noted when it arrived, and words that have arrived since ended it.
  if (context.turns.speaking(0))
    note_speech(message, context.now);
  stop_silence();
  if (output.can_be_interrupted())
    for (const auto* role : {"TTS", "Speaker"})
      if (context.port.reachable(role))
        messenger.post(role, "Stop", {}, 0);
  return true;
}

// Finished(utterance, played, interrupted, spoken_text): what was heard of an
// output; the utterance is the output's id.
bool ConversationImplementation::hear_speaker(const Message& message) {
  if (message.command == "Failed"sv &&
      (context.port.is_source("TTS", message.source) ||
       context.port.is_source("Speaker", message.source)))
    output.voice_failed(); // others may take it, too
  if (message.command != "Finished"sv ||
      !context.port.is_source("Speaker", message.source))
    return false;
  const Value params(message.params);
  const auto id = static_cast<OutputId>(params.at(0).integer_or(0));
  if (params.at(2))
    output.interrupted(id, params.at(3).is_unknown() ? std::string()
                                                     : params.at(3).text());
  else
    output.finished(id);
  return true;
}

void ConversationImplementation::timer_fired(TimerId id) {
  if (watch_ && watch_->id == id)
    watch_.reset();
  auto timer = timers.fired(id, context.now);
  if (!timer)
    return;
  begin_event();
  act_on(std::move(*timer));
  go_on();
}

// `patience` needs no deed: go_on(), which follows, gives up the turns whose
// time is over.
void ConversationImplementation::act_on(Timer timer) {
  switch (timer.purpose) {
  case Timer::Purpose::script:
    ring(std::move(timer));
    break;
  case Timer::Purpose::wait:
    if (timer.correlation == 0)
      end_wait({timer.wait, Value()});
    else
      end_wait({timer.wait, fail(ErrorKind::timeout, "no reply came in time")});
    break;
  case Timer::Purpose::wording:
    output.give_up_wording(timer.correlation);
    break;
  case Timer::Purpose::silence:
    output.turn_begins();
    topics.silence();
    break;
  case Timer::Purpose::patience: // what is due now is found by go_on
    break;
  case Timer::Purpose::closing:
    context.ending.wish();
    break;
  case Timer::Purpose::leaving:
    finish();
    break;
  }
}

void ConversationImplementation::answered(QueryId id, Expected<Value> outcome) {
  if (auto over = outside.answered(id, std::move(outcome))) {
    end_wait(std::move(*over));
    go_on();
  }
}

void ConversationImplementation::end_wait(WaitOutcome over) {
  waits.forget_request(over.wait);
  if (context.lane.waits(over.wait))
    context.lane.wake(over.wait,
                      outcome_step(over.wait, std::move(over.outcome)));
  else
    pipeline.resume(over.wait, std::move(over.outcome));
}

void ConversationImplementation::ring(Timer timer) {
  messenger.raise("Timer", "Fired", {timer.name});
  const auto ring = timers.ring(timer);
  if (!ring)
    return;
  Body body{.code = timer.code,
            .topic = timer.topic,
            .origin = {.visit = timer.visit, .timer = timer.code},
            .input = input_of(std::move(timer.arguments))};
  context.lane.queue(
      {steps::RunTimer{std::move(body), ring}, steps::Conclude{.ring = ring}});
}

// The order matters: words that never came are given up before the lane runs; a
// yes that waited for its breath to end is taken when the lane is idle; silence
// is watched last.
void ConversationImplementation::go_on() {
  if (context.ending.has_begun()) {
    if (!context.ending.is_over())
      leave();
    return;
  }
  give_up_turns();
  if (output.was_interrupted() && !context.turns.any_open(context.now))
    output.take_up_interrupted();
  run_lane();
  if (topics.nothing_followed())
    run_lane();
  heard_grammar.tell();
  if (!context.turns.any_open(context.now) &&
      !inbox.has_message(Inbox::Of::all))
    if (const auto received = inbox.take_received())
      context.privacy.settle(*received);
  if (context.ending.is_wished() && !topics.awaiting_frame() &&
      !output.wants_release() && output.all_released())
    close();
  else
    watch_silence();
}

// The understanding of what was said never came.
void ConversationImplementation::give_up_turns() {
  if (!context.turns.asked_anything())
    return;
  for (auto turn : context.turns.expire(context.now)) {
    answers.forget(turn);
    context.turns.hold(turn);
    context.lane.queue(steps::NoMatch{turn});
  }
}

// -- silence ------------------------------------------------------------------

// Silence counts only where nothing goes on (engine rule 3.8). While a turn is
// open, what is watched is not silence but how long the turn may still stay
// open.
void ConversationImplementation::watch_silence() {
  if (context.ending.is_wished() || !context.lane.idle() || !output.silent() ||
      topics.awaiting_frame()) {
    stop_silence();
  } else if (context.turns.any_open(context.now)) {
    // Nobody may ever answer on the turn's behalf.
    if (auto until = context.turns.open_until(context.now))
      watch_for(Milliseconds(*until - context.now), Timer::Purpose::patience);
    else
      stop_silence();
  } else if (!inbox.has_internal() && !inbox.has_message(Inbox::Of::all)) {
    output.falls_silent();
    watch_nobody();
  }
}

// Nothing closes while something is due.
void ConversationImplementation::watch_nobody() {
  if (auto wanted = topics.silence_wanted())
    watch_for(*wanted, Timer::Purpose::silence);
  else if (timers.keep_open() || requests.waits_for_answer() ||
           outside.waits_for_answer())
    stop_silence();
  else
    watch_for(context.closes_after(), Timer::Purpose::closing);
}

// A timer that watches already goes on, so that silence lasts from where it
// began.
void ConversationImplementation::watch_for(Milliseconds length,
                                           Timer::Purpose purpose) {
  if (watch_ && watch_->purpose == purpose &&
      (watch_->length == length || purpose == Timer::Purpose::patience))
    return;
  stop_silence();
  watch_ = Watch{timers.start(context.in(length), purpose), purpose, length};
}

void ConversationImplementation::stop_silence() {
  if (!watch_)
    return;
  timers.cancel(watch_->id);
  watch_.reset();
}

} // namespace parlour::dialogue
