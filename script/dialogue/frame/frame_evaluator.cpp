#include "script/dialogue/frame/frame_evaluator.hpp"

#include <algorithm>
#include <utility>

#include "script/dialogue/frame/frame_view.hpp"
#include "script/program/computing_host.hpp"
#include "script/program/constant_text.hpp"
#include "script/values/convert.hpp"

namespace parlour::dialogue {

namespace {

// Answers what a condition or text reads, and refuses every effect. It notes
// slots of its own topic only: constraints refuse no other topic's values.
class FrameHost : public script::ComputingHost {
public:
  FrameHost(const script::Program& program, const TopicFrame& frame,
            Timestamp now, const FindFrame& others, std::vector<SlotId>* reads)
      : ComputingHost("a condition or text", now), program_(program),
        frame_(frame), others_(others), reads_(reads) {}

  Value slot(TopicId topic, SlotId slot) const override {
    if (topic != frame_.topic) {
      const auto* other = others_ ? others_(topic) : nullptr;
      return other ? read_slot(*other, slot) : Value();
    }
    if (reads_)
      reads_->push_back(slot);
    return read_slot(frame_, slot);
  }

  Value system(const script::Activation&,
               script::SystemVariable variable) const override {
    using enum script::SystemVariable;
    if (variable == topic)
      return program_.topics[frame_.topic].name;
    if (variable == frame_done)
      return frame_.done;
    return {};
  }

private:
  const script::Program& program_;
  const TopicFrame& frame_;
  const FindFrame& others_;
  std::vector<SlotId>* reads_; // may be null
};

Expected<Value> evaluate_in(script::Interpreter& interpreter, CodeId code,
                            const TopicFrame& frame, Timestamp now,
                            const FindFrame& others,
                            std::vector<SlotId>* reads) {
  if (const auto* constant =
          script::constant_of(interpreter.program().code[code]))
    return script::to_value(*constant); // no world is needed
  FrameHost host(interpreter.program(), frame, now, others, reads);
  script::ActivationContext context;
  context.topic = frame.topic;
  return interpreter.evaluate(code, {}, std::move(context), host);
}

} // namespace

FrameEvaluator make_frame_evaluator(script::Interpreter& interpreter,
                                    Timestamp now, FindFrame others) {
  return [&interpreter, now, others = std::move(others)](
             CodeId code, const TopicFrame& frame, std::vector<SlotId>* reads) {
    return evaluate_in(interpreter, code, frame, now, others, reads);
  };
}

FrameEvaluator
make_frame_evaluator(std::shared_ptr<const script::Program> program,
                     std::shared_ptr<const List> variables, Timestamp now,
                     std::vector<FramePointer> others) {
  auto interpreter = std::make_shared<script::Interpreter>(std::move(program));
  if (variables)
    for (std::size_t i = 0; i < variables->size(); ++i)
      interpreter->set_variable(i, (*variables)[i]);
  FindFrame find = [others = std::move(others)](TopicId topic) {
    const auto found = std::ranges::find_if(
        others, [&](const auto& other) { return other->topic == topic; });
    return found == others.end() ? static_cast<const TopicFrame*>(nullptr)
                                 : found->get();
  };
  return [interpreter, now, find = std::move(find)](
             CodeId code, const TopicFrame& frame, std::vector<SlotId>* reads) {
    return evaluate_in(*interpreter, code, frame, now, find, reads);
  };
}

} // namespace parlour::dialogue
