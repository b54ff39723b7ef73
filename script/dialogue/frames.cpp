#include "script/dialogue/frames.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "script/dialogue/frame_evaluator.hpp"
#include "script/instruction.hpp"

namespace parlour::dialogue {

namespace {

// Changes that are kept for the frame's actor; more travel as the frame.
constexpr std::size_t most_untold = 256;

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

const Frame& Frames::get(TopicId topic, Timestamp now) const {
  return *entry(topic, now).frame;
}

FrameResult Frames::change(TopicId topic, FrameChange change, Timestamp now) {
  auto& mine = entry(topic, now);
  FrameRequest request;
  request.now = now;
  request.changes.push_back(change);
  auto result = apply(*program_, *mine.frame, request,
                      make_frame_evaluator(*interpreter_, now));
  mine.frame = result.frame;
  if (mine.has_actor)
    mine.untold.push_back(std::move(change));
  if (mine.untold.size() > most_untold) { // the whole frame is shorter
    mine.untold.clear();
    mine.has_actor = false;
  }
  return result;
}

FrameRequest Frames::request(TopicId topic, std::vector<FrameChange> changes,
                             Timestamp now) {
  auto& mine = entry(topic, now);
  FrameRequest request;
  request.now = now;
  if (!std::exchange(mine.has_actor, true))
    request.start = mine.frame;
  request.changes = std::exchange(mine.untold, {});
  request.told = request.changes.size();
  request.changes.insert(request.changes.end(),
                         std::make_move_iterator(changes.begin()),
                         std::make_move_iterator(changes.end()));
  if (reads_variables(*program_, program_->topics[topic]))
    request.variables = variables_of(*interpreter_);
  return request;
}

void Frames::store(FramePointer frame) {
  auto topic = frame->topic;
  entries_[topic].frame = std::move(frame);
}

Frames::Entry& Frames::entry(TopicId topic, Timestamp now) const {
  auto& mine = entries_[topic];
  if (!mine.frame)
    mine.frame = std::make_shared<const Frame>(
        new_frame(*program_, topic, make_frame_evaluator(*interpreter_, now)));
  return mine;
}

} // namespace parlour::dialogue
