#include "script/dialogue/frame/frames.hpp"

#include <algorithm>
#include <utility>

#include "script/dialogue/frame/frame_evaluator.hpp"
#include "script/program/instruction.hpp"
#include "script/support/short_lived.hpp"

namespace parlour::dialogue {

namespace {

using script::Operation;

// The code that a filling event may run, each once.
class Reachable {
public:
  explicit Reachable(const script::Program& program)
      : is_there_(program.code.size()) {}

  void add(CodeId code) {
    if (code == script::no_code || is_there_[code])
      return;
    is_there_[code] = true;
    codes_.push_back(code);
  }
  // False: there is no more.
  bool take(CodeId& code) {
    if (codes_.empty())
      return false;
    code = codes_.back();
    codes_.pop_back();
    return true;
  }

private:
  std::vector<bool> is_there_;
  std::vector<CodeId> codes_; // not taken yet
};

Reachable code_of(const script::Program& program, const script::Topic& topic) {
  Reachable reachable(program);
  for (const auto& constraint : topic.constraints) {
    reachable.add(constraint.condition);
    reachable.add(constraint.message);
  }
  for (const auto& slot : topic.slots) {
    reachable.add(slot.initial);
    reachable.add(slot.condition);
    reachable.add(slot.cardinality.minimum);
    reachable.add(slot.cardinality.maximum);
    for (auto value : slot.cardinality.values)
      reachable.add(value);
  }
  return reachable;
}

// For each session variable, whether a filling event of the topic may read it:
// its conditions and texts name it, or the functions that these call. All,
// where a function is called by a name that is computed.
std::vector<bool> variables_read(const script::Program& program,
                                 const script::Topic& topic) {
  std::vector<bool> read(program.variables.size());
  auto reachable = code_of(program, topic);
  for (auto code = script::no_code; reachable.take(code);)
    for (const auto& instruction : program.code[code].instructions) {
      const auto operation = static_cast<Operation>(instruction.operation);
      if (operation == Operation::load_variable ||
          operation == Operation::bind_variable)
        read[instruction.b] = true;
      else if (operation == Operation::call)
        reachable.add(instruction.wide());
      else if (operation == Operation::call_named)
        return std::vector<bool>(read.size(), true);
    }
  return read;
}

// Those that the topic's conditions and texts may read, in their places; null:
// none.
std::shared_ptr<const List> variables_for(const script::Topic& topic,
                                          const script::Interpreter& from) {
  const auto read = variables_read(from.program(), topic);
  if (std::ranges::find(read, true) == read.end())
    return nullptr;
  List values(read.size());
  for (std::size_t i = 0; i < read.size(); ++i)
    if (read[i])
      values[i] = from.variable(i);
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
