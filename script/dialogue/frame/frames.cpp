#include "script/dialogue/frame/frames.hpp"

#include <algorithm>
#include <utility>

#include "script/dialogue/frame/frame_evaluator.hpp"
#include "script/program/instruction.hpp"
#include "script/support/short_lived.hpp"

namespace parlour::dialogue {

namespace {

std::shared_ptr<const List>
variables_of(const script::Interpreter& interpreter) {
  List values;
  for (std::size_t i = 0; i < interpreter.program().variables.size(); ++i)
    values.push_back(interpreter.variable(i));
  return std::make_shared<const List>(std::move(values));
}

bool is_constant(const script::Instruction& instruction) {
  using enum script::Operation;
  const auto operation = static_cast<script::Operation>(instruction.operation);
  return operation == load_constant || operation == give_back ||
         operation == give_unknown;
}

// What is more than a constant may read variables, if only by a function.
bool is_computed(const script::Program& program, CodeId code) {
  if (code == script::no_code)
    return false;
  const auto& instructions = program.code[code].instructions;
  return !std::all_of(instructions.begin(), instructions.end(), is_constant);
}

bool is_computed(const script::Program& program, const script::Slot& slot) {
  const auto& takes = slot.cardinality;
  return is_computed(program, slot.initial) ||
         is_computed(program, slot.condition) ||
         is_computed(program, takes.minimum) ||
         is_computed(program, takes.maximum) ||
         std::any_of(takes.values.begin(), takes.values.end(),
                     [&](CodeId code) { return is_computed(program, code); });
}

// Whether the frame's actor may have to read variables: for a constraint, an
// initial value, or what a slot takes.
bool reads_variables(const script::Program& program,
                     const script::Topic& topic) {
  return !topic.constraints.empty() ||
         std::any_of(topic.slots.begin(), topic.slots.end(),
                     [&](const script::Slot& slot) {
                       return is_computed(program, slot);
                     });
}

} // namespace

Frames::Frames(const script::Program& program, script::Interpreter& interpreter)
    : program_(&program), interpreter_(&interpreter),
      entries_(program.topics.size()) {}

// Copy on write: `own` is null while the frame is shared.
TopicFrame& Frames::own(TopicId topic, Timestamp now) {
  auto& mine = entry(topic, now);
  if (!mine.own)
    mine.frame = mine.own = std::make_shared<TopicFrame>(*mine.frame);
  return *mine.own;
}

FrameResult Frames::apply(TopicId topic, std::span<const FrameChange> changes,
                          Timestamp now) {
  return apply_in_place(*program_, own(topic, now), changes, evaluator(now));
}

// A frame whose initial values are being made has none yet.
FrameEvaluator Frames::evaluator(Timestamp now) const {
  if (program_->read_elsewhere.empty())
    return make_frame_evaluator(*interpreter_, now);
  return make_frame_evaluator(*interpreter_, now, [this, now](TopicId topic) {
    return entries_[topic].is_made ? nullptr : entry(topic, now).frame.get();
  });
}

FrameRequest Frames::request(TopicId topic, std::vector<FrameChange> changes,
                             Timestamp now) {
  auto& mine = entry(topic, now);
  mine.own.reset(); // it is shared from now on
  FrameRequest request;
  request.frame = mine.frame;
  request.now = now;
  request.changes = std::move(changes);
  if (reads_variables(*program_, program_->topics[topic]))
    request.variables = variables_of(*interpreter_);
  for (auto other : program_->read_elsewhere)
    if (other != topic) {
      auto& read = entry(other, now);
      read.own.reset();
      request.others.push_back(read.frame);
    }
  return request;
}

void Frames::store(FramePointer frame) {
  auto& mine = entries_[frame->topic];
  mine.own.reset();
  mine.frame = std::move(frame);
}

// Made when first looked at, since most topics of an application are not spoken
// of. An initial value may read another topic, whose initial value reads this
// one; `is_made` ends that ring.
Frames::Entry& Frames::entry(TopicId topic, Timestamp now) const {
  auto& mine = entries_[topic];
  if (mine.frame)
    return mine;
  mine.is_made = true;
  mine.frame = mine.own =
      make_short_lived<TopicFrame>(new_frame(*program_, topic, evaluator(now)));
  mine.is_made = false;
  return mine;
}

} // namespace parlour::dialogue
