#include "actors/sessions/session_dialogue.hpp"

#include <utility>

#include "script/dialogue/inputs/replay.hpp"
#include "script/vm/program_identity.hpp"

namespace parlour::actors {

namespace {

// A replay and a recovery begin at a state, and so do not take longer than so
// many inputs.
// A smaller number makes the journal larger by a state each time (engine rule
// 7.8 has the sizes), a larger one lets a recovery take longer.
constexpr std::uint64_t inputs_between_states = 1'000;

} // namespace

SessionDialogue::SessionDialogue(std::shared_ptr<const script::Program> program,
                                 dialogue::ConversationOptions options,
                                 std::unique_ptr<SessionPort> port,
                                 JournalUse kept,
                                 const dialogue::SavedSession* saved)
    : program_(std::move(program)), options_(std::move(options)),
      kept_(std::move(kept)), port_(std::move(port)) {
  if (saved) {
    conversation_ = dialogue::Conversation::restore(program_, options_,
                                                    seen(*port_), saved->state)
                        .value();
    inputs_ = saved->inputs;
    turns_ = saved->turns;
  } else {
    conversation_ = std::make_unique<dialogue::Conversation>(program_, options_,
                                                             seen(*port_));
  }
  if (!kept_.journal)
    return;
  part_ = kept_.journal->hold();
  if (saved)
    keep_state();
  else
    keep(opened());
}

// -- the journal --------------------------------------------------------------

dialogue::SessionOpened SessionDialogue::opened() const {
  return {script::identity_of(*program_), options_.seed, kept_.strict,
          options_.seat};
}

// Held before it is appended: what is held is never newer than where it stands.
void SessionDialogue::keep_state() {
  part_ = kept_.journal->hold();
  has_moved_ = has_gap_ = false;
  inputs_in_state_ = inputs_;
  keep(dialogue::StateKept{opened(), inputs_, conversation_->save(), turns_});
}

// Where the journal could not take it, `record` is 0: from then on there is a
// gap, and nothing that is held back may leave.
void SessionDialogue::keep(decltype(dialogue::SessionRecord::what) what) {
  const auto place = kept_.journal->append(
      dialogue::to_bytes({options_.session, std::move(what)}));
  has_moved_ |= place.part != part_->number;
  has_gap_ |= place.record == 0;
  if (place.record == 0)
    return;
  last_record_ = place.record;
  bind_effects();
}

// The call comes at once where the record is on the disk already.
void SessionDialogue::bind_effects() {
  if (port_->effects().wait_for(last_record_, inputs_))
    kept_.journal->when_written(last_record_, kept_.when_written(last_record_));
}

void SessionDialogue::turns_done(const TurnMeter::Answered& answered,
                                 std::uint64_t turn) {
  if (turn != 0)
    port_->tell_turns_done(turn);
  port_->count_turns(answered);
  bind_effects();
}

void SessionDialogue::take(dialogue::SessionInput input, Timestamp now) {
  wake();
  last_input_ = now;
  if (!kept_.journal)
    return dialogue::take(*conversation_, std::move(input), now);
  // Before it is dealt with: the conversation may take it apart.
  auto noted = dialogue::to_bytes(*program_, {now, input});
  turns_.take(input);
  dialogue::take(*conversation_, std::move(input), now);
  ++inputs_;
  turns_.dealt_with(*conversation_, now);
  auto answers = dialogue::to_bytes(*program_, recording_->take_answers());
  // Behind a gap only a state makes sense.
  if (!has_gap_)
    keep(dialogue::InputTaken{std::move(noted), std::move(answers)});
  if (has_gap_ || has_moved_ || inputs_ % inputs_between_states == 0)
    keep_state();
}

// That a post was made is noted, so that a recovery does not make it again.
void SessionDialogue::written(std::uint64_t record) {
  if (const auto input = port_->effects().written(record))
    keep(dialogue::EffectsDone{*input});
}

// The record tells a recovery that there is nothing to bring back. Where it is
// lost, the end waits for what was said last: else the seat would wait for it.
void SessionDialogue::close(std::vector<Message> unread) {
  port_->close(std::move(unread));
  if (!kept_.journal)
    return;
  keep(dialogue::SessionClosed());
  bind_effects();
}

void SessionDialogue::pass_on(const std::vector<Message>& late) {
  port_->pass_on(late);
  bind_effects();
}

// Between the conversation and its port stands what writes down the port's
// answers, as a replay has to repeat them.
dialogue::Port& SessionDialogue::seen(SessionPort& port) {
  if (!kept_.journal)
    return port;
  recording_ = std::make_unique<dialogue::RecordingPort>(port);
  recording_->on_output = [this](const dialogue::Output& output) {
    turns_.release(output);
  };
  return *recording_;
}

// -- rest ---------------------------------------------------------------------

bool SessionDialogue::may_rest(Timestamp now) const {
  return conversation_ && last_input_ != 0 && !change_ &&
         conversation_->is_at_rest(now) && !conversation_->expects_outcome() &&
         port_->effects().none();
}

// The journal has a state of it, from which a recovery takes less time.
void SessionDialogue::rest_if_idle(Milliseconds idle, Timestamp now) {
  if (now - last_input_ < idle.count() || !may_rest(now))
    return;
  if (kept_.journal && inputs_ != inputs_in_state_)
    keep_state();
  at_rest_ = conversation_->save();
  at_rest_.shrink_to_fit();
  conversation_ = nullptr;
  port_->end_frames();
}

// The program is the same, and so the bytes are good.
void SessionDialogue::wake() {
  if (conversation_)
    return;
  dialogue::Port* port = port_.get();
  if (recording_)
    port = recording_.get();
  conversation_ =
      dialogue::Conversation::restore(program_, options_, *port, at_rest_)
          .value();
  at_rest_ = {};
}

// -- another port -------------------------------------------------------------

// The conversation before ends only when the next one is there, as an error
// must leave it in place; its port ends last.
Expected<void> SessionDialogue::renew(Timestamp now) {
  const bool keeps_port =
      conversation_->expects_outcome() || !port_->effects().none();
  auto port = keeps_port ? nullptr : port_->another();
  // The recording port of the conversation before lives as long as that one.
  auto recording = std::move(recording_);
  auto next = dialogue::Conversation::restore(program_, options_,
                                              seen(keeps_port ? *port_ : *port),
                                              conversation_->save());
  if (!next) {
    recording_ = std::move(recording);
    return tl::make_unexpected(std::move(next.error()));
  }
  conversation_ = std::move(*next);
  if (keeps_port)
    return {};
  port_ = std::move(port); // what worked for the one before ends with its port
  take(dialogue::input::Resumed(), now);
  return {};
}

// -- another program ----------------------------------------------------------

// Counted, but not written: a replay begins at the state.
void SessionDialogue::keep_state_behind_gap() {
  ++inputs_;
  if (!kept_.journal)
    return;
  recording_->take_answers();
  keep_state();
}

void SessionDialogue::end_scripts(Timestamp now) {
  wake();
  conversation_->end_scripts(now);
  keep_state_behind_gap();
}

// The recording port of the conversation before lives as long as that one.
std::vector<std::string> SessionDialogue::go_over(Timestamp now) {
  const auto change = std::exchange(change_, nullptr);
  const auto& parts = change->parts();
  const auto before = std::exchange(program_, parts->program);
  const auto recording = std::move(recording_);
  options_.phrases = parts->phrases;
  dialogue::Conversation::TakenOver taken;
  if (change->mode() == ReloadMode::keep) {
    port_->go_over(parts);
    taken = dialogue::Conversation::take_over(*conversation_,
                                              *change->renames_from(before),
                                              options_, seen(*port_), now);
  } else {
    taken.conversation = dialogue::Conversation::begin_instead(
        *conversation_, program_, options_, seen(*port_));
    port_->begin_again(parts);
  }
  conversation_ = std::move(taken.conversation);
  keep_state_behind_gap();
  if (change->mode() == ReloadMode::restart)
    take(dialogue::input::Begun(), now);
  return std::move(taken.lost);
}

std::string SessionDialogue::doing() const {
  if (!conversation_)
    return "is at rest";
  if (conversation_->ended())
    return "has ended";
  const auto state = conversation_->state();
  const std::string at = state.empty() ? "" : " in state " + state;
  if (conversation_->awaiting_frame())
    return "waits for a topic's frame" + at;
  if (conversation_->has_work())
    return "takes what has come" + at;
  if (change_)
    return "ends what it does before it takes the changed scripts" + at;
  const bool waits = conversation_->waits_for_answer();
  return (waits ? "waits for an answer" : "waits") + at;
}

} // namespace parlour::actors
