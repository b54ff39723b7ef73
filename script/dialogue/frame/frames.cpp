#include "script/dialogue/frame/frames.hpp"

#include <algorithm>
#include <utility>

#include "script/dialogue/frame/frame_evaluator.hpp"
#include "script/support/short_lived.hpp"

namespace parlour::dialogue {

namespace {

// Those that the topic's filling events may read, in their places; null: none.
std::shared_ptr<const List> variables_for(const script::Topic& topic,
                                          const script::Interpreter& from) {
  if (topic.read_variables.empty())
    return nullptr;
  List values(from.program().variables.size());
  for (const auto at : topic.read_variables)
    values[at] = from.variable(at);
  return std::make_shared<const List>(std::move(values));
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
  request.variables = variables_for(program_->topics[topic], *interpreter_);
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
