// The part of a conversation that says what happens with each input, and what
// silence leads to (engine rules 1 to 3).
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/engine/conversation.hpp"
#include "script/dialogue/engine/conversation_implementation.hpp"

namespace parlour::dialogue {

namespace {

using namespace std::string_view_literals;

const std::string recogniser = "ASR";

// What the engine itself has an ear for, besides who reacts to it.
constexpr std::string_view heard_commands[] = {
    "RecognitionResult", "SpeechStarted", "Partial",      "Rejected",
    "Finished",          "AgentOnline",   "AgentOffline", "PhraseFailed"};

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

// The user was heard to speak, but not yet understood.
bool is_speech(const Port& port, const Message& message) {
  return (message.command == "SpeechStarted"sv &&
          port.is_source("VAD", message.source)) ||
         (message.command == "Partial"sv &&
          port.is_source(recogniser, message.source));
}

} // namespace

// -- inputs -------------------------------------------------------------------

void Conversation::Implementation::receive(
    std::shared_ptr<const Message> message) {
  const bool heard = is_heard(*message);
  context.received = std::max(context.received, message->number);
  Input input;
  input.begins_turn = heard && message->command == "RecognitionResult"sv &&
                      context.port.is_source(recogniser, message->source);
  if (input.begins_turn && !context.turns.any_said(context.now))
    context.apologies.user_speaks();
  input.turn = input.begins_turn ? context.turns.begin()
                                 : context.turns.of(message->correlation);
  context.turns.hold(input.turn);
  if (heard && is_speech(context.port, *message)) // known before a release
    context.turns.speaks(std::max(context.now, message->time) +
                         defaults::speech_without_words.count());
  if (!input.begins_turn)
    context.turns.answered(message->correlation);
  input.message = std::move(message);
  context.inbox.push_back(std::move(input));
}

// What a <fire> of the recogniser's message would lead to.
void Conversation::Implementation::take_acts(std::span<const ActPointer> acts) {
  begin_event();
  user_begins();
  context.apologies.user_speaks();
  const auto turn = context.turns.begin();
  StepList item;
  for (const auto& act : acts) {
    context.turns.hold(turn);
    auto& step = item.add(StepKind::take_act);
    step.act = act;
    step.turn = turn;
  }
  item.add(StepKind::conclude).turn = turn;
  context.lane.queue(std::move(item));
  go_on();
}

void Conversation::Implementation::user_begins() {
  stop_silence();
  output.turn_begins();
}

// While the session ends it only hears what is not the user's: the words that
// it still waits for.
Fifo<Input>::Place Conversation::Implementation::next_input() {
  if (!context.ending)
    return context.inbox.begin();
  return std::find_if(context.inbox.begin(), context.inbox.end(),
                      [](const Input& input) { return !input.begins_turn; });
}

bool Conversation::Implementation::has_work() {
  return !context.ended && !topics.awaiting_frame() &&
         (output.wants_release() || runner.has_slices() ||
          !context.internal.empty() ||
          (!context.inbox.empty() && next_input() != context.inbox.end()));
}

void Conversation::Implementation::begin_event() {
  context.internal_events = 0;
  context.rounds = 0;
  context.chased = false;
  context.interpreter.new_event();
}

// Outputs first: by the time of this step, whatever was in the mailbox is in
// the inbox, so that a turn that has begun is known (engine rule 3).
void Conversation::Implementation::take_input() {
  if (output.wants_release()) {
    if (output.release())
      stop_silence();
  } else if (auto slice = runner.take_slice(); slice != 0) {
    waits.resume(slice, Value());
  } else if (!context.internal.empty()) {
    auto input = context.internal.take();
    if (context.one_more_internal_event())
      process(std::move(input));
    else
      output.drop(input);
  } else if (auto next = next_input(); next != context.inbox.end()) {
    auto input = context.inbox.take(next);
    begin_event();
    process(std::move(input));
  }
  go_on();
}

void Conversation::Implementation::process(Input&& input) {
  const auto& message = *input.message;
  if (context.port.is_source(recogniser, message.source)) {
    context.privacy.hear(topics.asks_in_private());
    user_begins();
  }
  if (input.begins_turn)
    output.give_up_interrupted();
  if (is_heard(message) && (hear_speech(message) || hear_speaker(message) ||
                            machine.agent_changed(message) ||
                            output.hear_failure(message, input.turn)))
    input.raised = true;        // somebody took it
  if (effects.reply(message)) { // a script's loop may have many
    context.turns.let_go(input.turn);
  } else {
    context.rounds = message.rounds;
    pipeline.take(std::move(input));
  }
}

// Barge-in (engine rule 3).
bool Conversation::Implementation::hear_speech(const Message& message) {
  if (message.command == "Rejected"sv &&
      context.port.is_source(recogniser, message.source))
    context.turns.speech_is_over();
  if (!is_speech(context.port, message))
    return false;
  stop_silence();
  context.turns.speaks(context.now + defaults::speech_without_words.count());
  if (output.can_be_interrupted())
    for (const auto* role : {"TTS", "Speaker"})
      if (context.port.reachable(role))
        context.post(role, "Stop", {}, 0);
  return true;
}

// Finished(utterance, played, interrupted, spoken_text): what was heard of an
// output; the utterance is the output's id.
bool Conversation::Implementation::hear_speaker(const Message& message) {
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

void Conversation::Implementation::timer_fired(TimerId id) {
  if (watch_ && watch_->id == id)
    watch_.reset();
  auto timer = context.timers.fired(id);
  if (!timer)
    return;
  begin_event();
  act_on(std::move(*timer));
  go_on();
}

void Conversation::Implementation::act_on(Timer timer) {
  switch (timer.purpose) {
  case Timer::Purpose::script:
    ring(std::move(timer));
    break;
  case Timer::Purpose::wait:
    if (timer.correlation == 0)
      waits.resume(timer.wait, Value());
    else
      waits.resume(timer.wait,
                   fail(ErrorKind::timeout, "no reply came in time"));
    break;
  case Timer::Purpose::wording:
    output.give_up_wording(timer.correlation);
    break;
  case Timer::Purpose::silence:
    topics.silence();
    break;
  case Timer::Purpose::patience: // what is due now is found by go_on
    break;
  case Timer::Purpose::closing:
    context.ending = true;
    break;
  case Timer::Purpose::leaving:
    finish();
    break;
  }
}

void Conversation::Implementation::ring(Timer timer) {
  context.raise("Timer", "Fired", {timer.name});
  const auto ring = context.timers.ring(timer);
  if (!ring)
    return;
  auto step = body_step(timer.code, 0);
  step.kind = StepKind::ring;
  step.origin = {.visit = timer.visit, .timer = timer.code};
  step.topic = timer.topic;
  step.matter().arguments = std::move(timer.arguments);
  step.matter().ring = ring;
  auto end = conclude_step(0);
  end.matter().ring = ring;
  context.lane.queue({std::move(step), std::move(end)});
}

void Conversation::Implementation::go_on() {
  if (leaving_ != Leaving::no) {
    if (!context.ended)
      leave();
    return;
  }
  give_up_turns();
  if (output.was_interrupted() && !context.turns.any_open(context.now))
    output.take_up_interrupted();
  run_lane();
  if (topics.nothing_followed())
    run_lane();
  if (!context.turns.any_open(context.now) && context.inbox.empty())
    context.privacy.settle(context.received);
  if (context.ending && !topics.awaiting_frame() && !output.wants_release() &&
      output.all_released())
    close();
  else
    watch_silence();
}

// The understanding of what was said never came.
void Conversation::Implementation::give_up_turns() {
  if (!context.turns.asked_anything())
    return;
  for (auto turn : context.turns.expire(context.now)) {
    answers.forget(turn);
    Step step;
    step.kind = StepKind::no_match;
    step.turn = turn;
    context.turns.hold(turn);
    context.lane.queue({std::move(step)});
  }
}

// -- silence ------------------------------------------------------------------

void Conversation::Implementation::watch_silence() {
  if (context.ending || !context.lane.idle() || !output.silent() ||
      topics.awaiting_frame()) {
    stop_silence();
  } else if (context.turns.any_open(context.now)) {
    // Nobody may ever answer on the turn's behalf.
    if (auto until = context.turns.open_until(context.now))
      watch_for(Milliseconds(*until - context.now), Timer::Purpose::patience);
    else
      stop_silence();
  } else if (context.internal.empty() && context.inbox.empty()) {
    watch_nobody();
  }
}

// Nothing closes while something is due.
void Conversation::Implementation::watch_nobody() {
  if (auto wanted = topics.silence_wanted())
    watch_for(*wanted, Timer::Purpose::silence);
  else if (context.timers.keep_open() || effects.waits_for_answer())
    stop_silence();
  else
    watch_for(context.program->settings.sessions.closes_after,
              Timer::Purpose::closing);
}

// A timer that watches already goes on, so that silence lasts from where it
// began.
void Conversation::Implementation::watch_for(Milliseconds length,
                                             Timer::Purpose purpose) {
  if (watch_ && watch_->purpose == purpose &&
      (watch_->length == length || purpose == Timer::Purpose::patience))
    return;
  stop_silence();
  watch_ = Watch{context.timers.start(length, purpose), purpose, length};
}

void Conversation::Implementation::stop_silence() {
  if (!watch_)
    return;
  context.timers.cancel(watch_->id);
  watch_.reset();
}

} // namespace parlour::dialogue
