#include "script/dialogue/frame/frame_evaluator.hpp"

#include "script/dialogue/frame/frame_view.hpp"
#include "script/program/computing_host.hpp"
#include "script/program/constant_text.hpp"
#include "script/values/convert.hpp"

namespace parlour::dialogue {

namespace {

class FrameHost : public script::ComputingHost {
public:
  FrameHost(const script::Program& program, const TopicFrame& frame,
            Timestamp now, std::vector<SlotId>* reads)
      : ComputingHost("a condition or text", now), program_(program),
        frame_(frame), reads_(reads) {}

  Value slot(TopicId, SlotId slot) const override {
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
  std::vector<SlotId>* reads_; // may be null
};

Expected<Value> evaluate_in(script::Interpreter& interpreter, CodeId code,
                            const TopicFrame& frame, Timestamp now,
                            std::vector<SlotId>* reads) {
  if (const auto* constant =
          script::constant_of(interpreter.program().code[code]))
    return script::to_value(*constant); // no world is needed
  FrameHost host(interpreter.program(), frame, now, reads);
  script::ActivationContext context;
  context.topic = frame.topic;
  return interpreter.evaluate(code, {}, std::move(context), host);
}

} // namespace

FrameEvaluator make_frame_evaluator(script::Interpreter& interpreter,
                                    Timestamp now) {
  return [&interpreter, now](CodeId code, const TopicFrame& frame,
                             std::vector<SlotId>* reads) {
    return evaluate_in(interpreter, code, frame, now, reads);
  };
}

FrameEvaluator
make_frame_evaluator(std::shared_ptr<const script::Program> program,
                     std::shared_ptr<const List> variables, Timestamp now) {
  auto interpreter = std::make_shared<script::Interpreter>(std::move(program));
  if (variables)
    for (std::size_t i = 0; i < variables->size(); ++i)
      interpreter->set_variable(i, (*variables)[i]);
  return [interpreter, now](CodeId code, const TopicFrame& frame,
                            std::vector<SlotId>* reads) {
    return evaluate_in(*interpreter, code, frame, now, reads);
  };
}

} // namespace parlour::dialogue
