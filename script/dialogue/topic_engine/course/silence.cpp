#include "script/dialogue/topic_engine/course/silence.hpp"

#include <algorithm>
#include <utility>

#include "script/dialogue/context/asked.hpp"

namespace parlour::dialogue {

namespace {

bool listens_to_silence(const script::State& state) {
  return std::any_of(state.messages.begin(), state.messages.end(),
                     [](const script::Reaction& reaction) {
                       return reaction.event == "no_input" &&
                              reaction.source == dialogue_source;
                     });
}

// Unanswered questions in a row after which the engine stops asking, and the
// session may close (engine rule 3.8). With more, a robot talks to an empty
// room; with fewer, somebody who looks for a paper is given up.
constexpr int max_reprompts = 5;

} // namespace

Silence::Silence(DialogueContext& context, TopicFrames& frames,
                 const ActivationRunner& runner, Offers& offers,
                 OpenQuestion& question, Asking& asking,
                 Confirmations& confirmations, Reprompts& reprompts,
                 NextQuestion& next_question, TopicChanges& topic_changes)
    : context_(context), frames_(frames), runner_(runner), offers_(offers),
      question_(question), asking_(asking), confirmations_(confirmations),
      reprompts_(reprompts), next_question_(next_question),
      topic_changes_(topic_changes) {
  for (const auto& state : context.program->states)
    listens_to_silence_.push_back(listens_to_silence(state));
}

// Reactions to Dialogue.no_input may keep a silence for themselves, so it is
// offered like an act. The lane is idle when silence is due; what resumes a
// topic is queued.
void Silence::silence() {
  switch (due()) {
  case Due::nothing:
    return;
  case Due::reprompt:
  case Due::state: {
    ++no_input_;
    const auto number = offers_.next_offer();
    offers_.offer("no_input", {}, number, steps::NoInput{number});
    return;
  }
  case Due::again:
    ask_again();
    return;
  case Due::confirmation: {
    auto steps = topic_changes_.back_to(confirmations_.innermost().topic);
    steps.add(steps::AskConfirm{});
    context_.lane.queue(std::move(steps));
    return;
  }
  case Due::question: {
    const auto topic = *frames_.order().current();
    reprompts_.ask_slot(topic, next_question_.to_ask(topic), OutputAct::resume,
                        0);
    return;
  }
  case Due::topic:
    context_.lane.queue(steps::ResumeTopic{frames_.order().next()->topic});
  }
}

std::optional<Milliseconds> Silence::silence_wanted() const {
  const auto& settings = context_.program->settings.sessions;
  switch (due()) {
  case Due::nothing:
    return std::nullopt;
  case Due::reprompt:
  case Due::state:
    return settings.no_input_after;
  default:
    return settings.resume_after;
  }
}

// Back to an unfinished topic, or on to one of system initiative. With
// resume="ask" the topic stays suspended until the yes: after a no there is
// nothing to take back.
void Silence::take(const steps::ResumeTopic& step) {
  const bool suspended = frames_[step.topic].status == TopicStatus::suspended;
  if (suspended &&
      context_.topic(step.topic).resume == script::ResumePolicy::ask) {
    Asked asked;
    asked.purpose = Asked::For::resume;
    asked.topic = step.topic;
    asking_.put(std::move(asked), "resume", {}, {}, OutputAct::resume, 0);
    return;
  }
  topic_changes_.take_up(step.topic);
}

// A question comes before everything else, then <confirm>s that others were put
// in front of. In a pushed state no topic comes: the state is a subtask, and
// topics go on when it is popped. A question that still waits for its release
// is due by itself, without silence.
Silence::Due Silence::due() const {
  if (question_ && question_->heard && !question_->interrupted)
    return no_input_ < max_reprompts ? Due::reprompt : Due::nothing;
  if (question_)
    return question_->pending ? Due::nothing : Due::again;
  if (confirmations_.any())
    return Due::confirmation;
  if (context_.states.pushed())
    return state_listens() ? Due::state : Due::nothing;
  if (runner_.topic_waits()) // its script says when to go on
    return Due::nothing;
  auto current = frames_.order().current();
  if (current && next_question_.to_ask(*current) != script::no_id)
    return Due::question;
  if (frames_.order().next())
    return Due::topic;
  return state_listens() ? Due::state : Due::nothing;
}

// The active state says what silence means where nothing is asked.
bool Silence::state_listens() const {
  const auto state = context_.states.active();
  return state != script::no_id && no_input_ < max_reprompts &&
         listens_to_silence_[state];
}

void Silence::repeat() {
  if (due() == Due::reprompt)
    reprompts_.repeat_question(0);
}

// The question that was withdrawn, unless a script has answered it meanwhile.
void Silence::ask_again() {
  const auto asked = *question_;
  if (asked.slot == script::no_id) {
    reprompts_.repeat_question(0);
    return;
  }
  question_.reset();
  if (frames_[asked.topic].slots[asked.slot].status != SlotStatus::filled)
    reprompts_.ask_slot(asked.topic, asked.slot, OutputAct::resume, 0);
}

} // namespace parlour::dialogue
