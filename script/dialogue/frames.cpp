#include "script/dialogue/frames.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "script/dialogue/frame_evaluator.hpp"

namespace parlour::dialogue {

namespace {

// Changes that are kept for the frame's actor; more travel as the frame.
constexpr std::size_t most_untold = 256;

// Whether what the topic computes for a frame may read session variables.
bool computes(const script::Topic& topic) {
  const auto in_slot = [](const script::Slot& slot) {
    const auto& values = slot.cardinality;
    return slot.initial != script::no_code ||
           values.minimum != script::no_code ||
           values.maximum != script::no_code || !values.values.empty();
  };
  return !topic.constraints.empty() ||
         std::any_of(topic.slots.begin(), topic.slots.end(), in_slot);
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
  if (computes(program_->topics[topic]))
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
