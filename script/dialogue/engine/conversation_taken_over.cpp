// The part of a conversation that goes on with another program (engine rule
// 7.12): what it knows is found again there by its names.
#include <utility>

#include "script/dialogue/agenda/saved_step.hpp"
#include "script/dialogue/engine/conversation.hpp"
#include "script/dialogue/engine/conversation_implementation.hpp"
#include "script/dialogue/saved/reader.hpp"
#include "script/dialogue/saved/renaming_writer.hpp"

namespace parlour::dialogue {

namespace {

// What a part names, and the other program has not.
enum class Missing : bool { keeps_it_out, is_left_out };

// Writes the part as the other program names things, and reads it back there.
// False: it names something that is missing there, and nothing was taken; or it
// could not be read.
template <class Part>
[[nodiscard]] bool take_part(Part& part, const Part& before,
                             const Renames& renames,
                             Missing missing = Missing::keeps_it_out) {
  RenamingWriter writer(renames);
  writer.write(before);
  if (writer.misses() && missing == Missing::keeps_it_out)
    return false;
  const auto bytes = writer.take();
  Reader reader(renames.to(), bytes);
  reader(part);
  return reader.finish().has_value();
}

std::string quoted(const char* kind, const std::string& name) {
  return std::string(kind) + " '" + name + "'";
}

// As sure as can be: it was accepted once, and is not to be asked for again.
FrameChange fill_with(SlotId slot, Value value) {
  FrameChange change{.kind = FrameChange::Kind::fill, .slot = slot};
  change.value = std::move(value);
  change.confidence = 1.0;
  return change;
}

// What to say to the other program's slot so that it gets the same value: of
// several values each with its amount; of several candidates all of them.
void refill(SlotId slot, const SlotState& was, bool many,
            std::vector<FrameChange>& fills) {
  const auto* items = many ? was.value.if_list() : nullptr;
  if (!items) {
    fills.push_back(fill_with(slot, was.value));
    if (was.status == SlotStatus::ambiguous)
      fills.back().candidates = was.candidates;
    return;
  }
  for (const auto& item : *items) {
    fills.push_back(fill_with(slot, item["value"]));
    fills.back().amount = item["amount"];
  }
}

// What was said for it stays said, as the other program's slot reads it: its
// value is the newly checked one, all else about it is as before. False: the
// value is lost, because the slot does not take it. A slot that nobody has
// filled keeps the counts of its questions.
bool take_slot(SlotState& slot, const SlotState& was) {
  if (was.status == SlotStatus::empty || was.by_default) {
    slot.asked = was.asked;
    slot.no_input = was.no_input;
    slot.no_match = was.no_match;
    slot.offered = was.offered;
    return true;
  }
  const auto fits = [](const SlotState& one) {
    return one.status != SlotStatus::empty && !one.by_default;
  };
  if (!fits(slot))
    return false;
  if (slot.status == SlotStatus::unconfirmed ||
      was.status != SlotStatus::ambiguous) {
    auto taken = was;
    taken.value = std::move(slot.value);
    taken.applies = slot.applies;
    slot = std::move(taken);
  }
  return true;
}

} // namespace

bool Conversation::is_at_rest(Timestamp now) const {
  const auto& parts = *implementation_;
  return !ended() && !parts.context.turns.any_open(now) && parts.is_at_rest();
}

void Conversation::end_scripts(Timestamp now) {
  if (ended() || awaiting_frame())
    return;
  implementation_->context.now = now;
  implementation_->begin_event();
  implementation_->end_scripts();
  implementation_->go_on();
}

Conversation::TakenOver Conversation::take_over(const Conversation& before,
                                                const Renames& renames,
                                                Options options, Port& port,
                                                Timestamp now) {
  TakenOver taken;
  taken.conversation =
      std::make_unique<Conversation>(renames.to(), std::move(options), port);
  auto& parts = *taken.conversation->implementation_;
  parts.context.now = now;
  taken.lost = parts.take_over(*before.implementation_, renames);
  return taken;
}

std::unique_ptr<Conversation>
Conversation::begin_instead(const Conversation& before,
                            std::shared_ptr<const script::Program> program,
                            Options options, Port& port) {
  auto next = std::make_unique<Conversation>(std::move(program),
                                             std::move(options), port);
  auto& parts = *next->implementation_;
  const auto& parts_before = *before.implementation_;
  parts.context.number_after(parts_before.context);
  parts.timers.take_over(parts_before.timers, [](Timer&) { return false; });
  return next;
}

// What is listed here has no counterpart in another program: activations, and
// what they or the topics wait for. Timers, the question that was asked and
// silence have.
bool ConversationImplementation::is_at_rest() const {
  return !has_work() && !topics.awaiting_frame() &&
         !topics.waits_for_answer() && context.lane.idle() &&
         !context.lane.waits() && !runner.anything_waits() &&
         !requests.waits_for_answer() && !outside.waits_for_answer() &&
         output.silent() && !inbox.has_message(Inbox::Of::all) &&
         !context.ending.is_wished();
}

// Waits::cancel leaves what the pipeline lane's handlers want of components;
// that is given up here, too.
void ConversationImplementation::end_scripts() {
  auto steps = waits.cancel(pipeline.waits());
  for (auto wait : pipeline.waits())
    if (runner.waits_for(wait) != WaitFor::user) {
      waits.forget_request(wait);
      steps.add(outcome_step(
          wait, fail(ErrorKind::cancelled, "the script was changed")));
    }
  context.lane.now(std::move(steps));
}

// The states first: timers and the question stand on them.
std::vector<std::string>
ConversationImplementation::take_over(const ConversationImplementation& before,
                                      const Renames& renames) {
  Losses lost;
  context.number_after(before.context);
  take_variables(before, renames, lost);
  take_frames(before, renames, lost);
  take_states(before, renames, lost);
  take_timers(before, renames, lost);
  take_question(before, renames, lost);
  const auto take = [&](auto& part, const auto& part_before, const char* what,
                        Missing missing = Missing::keeps_it_out) {
    if (!take_part(part, part_before, renames, missing))
      lost.emplace_back(what);
  };
  take(context.turns, before.context.turns, "what was said");
  take(reactions, before.reactions, "which handlers take no part");
  take(sockets, before.sockets, "the sockets");
  take(outside, before.outside, "the subscriptions");
  take(view, before.view, "where chance stands");
  take(running, before.running, "what scripts have done", Missing::is_left_out);
  take(heard_grammar, before.heard_grammar,
       "the grammar that the recogniser was told");
  take(output, before.output, "the outputs", Missing::is_left_out);
  frames.conceal();
  messenger.raise("System", "Reloaded",
                  {Value(List(lost.begin(), lost.end()))});
  return lost;
}

// Initial values are computed first, as those of new variables and of constants
// count; then the old values take their places.
void ConversationImplementation::take_variables(
    const ConversationImplementation& before, const Renames& renames,
    Losses& lost) {
  interpreter.initialise_what_computes(effects);
  const auto& variables = renames.from().variables;
  for (std::uint32_t id = 0; id < variables.size(); ++id)
    if (const auto here = renames.variable(id); here != script::no_id)
      interpreter.set_variable(here, before.interpreter.variable(id));
    else if (!variables[id].is_constant)
      lost.push_back(quoted("the variable", variables[id].name));
}

void ConversationImplementation::take_frames(
    const ConversationImplementation& before, const Renames& renames,
    Losses& lost) {
  const auto& topics_before = renames.from().topics;
  for (TopicId topic = 0; topic < topics_before.size(); ++topic) {
    if (!before.frames.has(topic))
      continue;
    const auto& frame = before.frames[topic];
    if (const auto here = renames.topic(topic); here != script::no_id)
      take_frame(frame, here, renames, lost);
    else if (frame.status != TopicStatus::untouched)
      lost.push_back(quoted("the topic", topics_before[topic].name));
  }
  frames.order().take_over(before.frames.order(),
                           [&](TopicId topic) { return renames.topic(topic); });
}

// What was said is heard again: a value has to fit the slot and the constraints
// that the other program has. It is asked for, confirmed and counted as before.
// First all values are filled in one event, so that constraints see them
// together; then what the event cannot know is copied over.
void ConversationImplementation::take_frame(const TopicFrame& before,
                                            TopicId topic,
                                            const Renames& renames,
                                            Losses& lost) {
  const auto& definition = renames.from().topics[before.topic];
  std::vector<FrameChange> fills;
  for (SlotId slot = 0; slot < before.slots.size(); ++slot) {
    const auto& was = before.slots[slot];
    const auto here = renames.slot(before.topic, slot);
    if (was.status != SlotStatus::empty && !was.by_default &&
        here != script::no_id)
      refill(here, was, context.topic(topic).slots[here].many, fills);
  }
  frames.apply(topic, fills);
  auto frame = std::make_shared<TopicFrame>(frames[topic]);
  frame->status = before.status;
  frame->done = before.done;
  frame->sure = before.sure;
  frame->certain = before.certain;
  frame->last = before.last;
  frame->rows = before.rows;
  frame->asked = before.asked;
  frame->relaxed = before.relaxed;
  for (SlotId slot = 0; slot < before.slots.size(); ++slot) {
    const auto& was = before.slots[slot];
    const auto here = renames.slot(before.topic, slot);
    const bool had = was.status != SlotStatus::empty && !was.by_default;
    if (here == script::no_id ? had : !take_slot(frame->slots[here], was))
      lost.push_back(
          quoted(here == script::no_id ? "the slot" : "the value of the slot",
                 definition.name + "." + definition.slots[slot].name));
  }
  frames.store(std::move(frame));
}

// A state that is not there any more falls back to the one below it. Visits
// keep their numbers, so that timers still end with them. Where all states are
// gone, the conversation begins anew.
void ConversationImplementation::take_states(
    const ConversationImplementation& before, const Renames& renames,
    Losses& lost) {
  const auto& known = before.context.states.levels();
  std::vector<StateStack::Level> levels;
  for (const auto& level : known) {
    const auto here = renames.state(level.state);
    if (level.state != script::no_id && here == script::no_id)
      lost.push_back(
          quoted("the state", renames.from().states[level.state].name));
    else if (levels.empty() || here != script::no_id)
      levels.push_back({here, level.visit, {0, renames.topic(level.by.topic)}});
  }
  const bool had_one = known.back().state != script::no_id;
  if (levels.empty())
    levels.emplace_back();
  const bool has_one = levels.back().state != script::no_id;
  context.states.take_over(before.context.states, std::move(levels));
  if (had_one && !has_one)
    context.lane.queue(beginning());
}

// Of the engine's own timers only silence and the closing of the session can be
// due while a conversation rests. A <timer> is kept where its statements, its
// topic and its state are there.
void ConversationImplementation::take_timers(
    const ConversationImplementation& before, const Renames& renames,
    Losses& lost) {
  using enum Timer::Purpose;
  const auto given_up = timers.take_over(before.timers, [&](Timer& timer) {
    if (timer.purpose == silence || timer.purpose == closing)
      return true;
    const bool has_topic = timer.topic != script::no_id;
    timer.code = renames.code(timer.code);
    timer.topic = renames.topic(timer.topic);
    return timer.purpose == script && timer.code != script::no_code &&
           (!has_topic || timer.topic != script::no_id) &&
           (timer.visit == 0 || context.states.lasts(timer.visit));
  });
  for (const auto& timer : given_up)
    if (timer.purpose == script)
      lost.push_back(quoted("the timer", timer.name));
  if (before.watch_ &&
      (before.watch_->purpose == silence || before.watch_->purpose == closing))
    watch_ = before.watch_;
}

// The parts that ask are taken with the question: what they have counted is
// about it. A question that was asked on another level of states would never be
// answered.
void ConversationImplementation::take_question(
    const ConversationImplementation& before, const Renames& renames,
    Losses& lost) {
  const bool asked = take_part(questions, before.questions, renames);
  if (!take_part(topics, before.topics, renames) || !asked)
    lost.push_back("what the topics have counted");
  if (!before.question)
    return;
  const bool stands_there =
      before.context.states.levels().size() == context.states.levels().size();
  if (!stands_there || !take_part(question, before.question, renames)) {
    question.reset();
    lost.push_back("the question that waited for an answer");
  }
}

} // namespace parlour::dialogue
