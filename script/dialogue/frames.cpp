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

// By itself, or by way of a function.
bool reads_variables(const script::Program& program, script::CodeId code) {
  using enum script::Operation;
  if (code == script::no_code)
    return false;
  const auto& instructions = program.code[code].instructions;
  return std::any_of(
      instructions.begin(), instructions.end(), [](const auto& instruction) {
        const auto operation =
            static_cast<script::Operation>(instruction.operation);
        return operation == load_variable || operation == call ||
               operation == call_named;
      });
}

bool reads_variables(const script::Program& program, const script::Slot& slot) {
  const auto reads = [&](script::CodeId code) {
    return reads_variables(program, code);
  };
  const auto& values = slot.cardinality.values;
  return reads(slot.initial) || reads(slot.cardinality.minimum) ||
         reads(slot.cardinality.maximum) ||
         std::any_of(values.begin(), values.end(), reads);
}

// Whether what a frame computes of itself may read session variables.
bool reads_variables(const script::Program& program,
                     const script::Topic& topic) {
  return !topic.constraints.empty() ||
         std::any_of(topic.slots.begin(), topic.slots.end(),
                     [&](const script::Slot& slot) {
                       return reads_variables(program, slot);
                     });
}

std::shared_ptr<const List>
variables_of(const script::Interpreter& interpreter) {
  List values;
  for (std::size_t i = 0; i < interpreter.program().variables.size(); ++i)
    values.push_back(interpreter.variable(i));
  return std::make_shared<const List>(std::move(values));
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
