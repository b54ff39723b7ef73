// Writes the format of interpreter_state.hpp.

#include <algorithm>

#include "runtime/base/value_bytes.hpp"
#include "script/values/object_bytes.hpp"
#include "script/vm/frame_check.hpp"
#include "script/vm/interpreter_state.hpp"
#include "script/vm/program_identity.hpp"

namespace parlour::script {

namespace {

// Writes everything that refers to objects into a buffer first, as the objects
// that are found on the way must stand before it.
class StateWriter {
public:
  StateWriter(const Machine& machine,
              const std::vector<const Execution*>& executions)
      : machine_(machine), executions_(executions) {}

  std::string write();

private:
  void write_fuel();
  void write_messages();
  void write_message(const Message& message);
  void write(const Execution& execution);
  void write(const ActivationContext& context);
  void write(CallFrame& frame);
  void write_variable(const Box& variable);
  void write(const CopyOut& copy_out);
  void write_register(const Box& box, const FrameCheck& check,
                      std::uint16_t reg);
  void write_binding(const Box* target);
  void put(RegisterTag tag) {
    bytes_.byte(static_cast<std::uint8_t>(tag));
  }

  const Machine& machine_;
  const std::vector<const Execution*>& executions_;
  ByteWriter bytes_;
  ObjectWriter objects_;
  std::vector<const Message*> messages_;
  std::vector<CallFrame*> frames_; // of the execution being written
};

// The parts that refer to objects are written first, and put behind the objects
// in the end.
std::string StateWriter::write() {
  write_fuel();
  for (const auto& variable : machine_.variables)
    write_variable(variable);
  write_messages();
  bytes_.number(executions_.size());
  for (const auto* execution : executions_)
    write(*execution);
  ByteWriter whole;
  whole.byte(state_version);
  whole.fixed(identity_of(*machine_.program));
  objects_.write_objects(whole);
  whole.add(bytes_);
  return whole.take();
}

// What nobody has looked at is made from the program again.
void StateWriter::write_variable(const Box& variable) {
  if (variable.is_missing())
    return put(RegisterTag::missing);
  objects_.write(bytes_, variable);
}

// A restored event has as much fuel left as it had.
void StateWriter::write_fuel() {
  const auto fuel = machine_.event_fuel();
  bytes_.number(fuel.instructions);
  bytes_.number(fuel.left);
  bytes_.byte(fuel.grace_given);
}

// Each message is written once; all activations that an event started share it.
void StateWriter::write_messages() {
  for (const auto* execution : executions_) {
    const auto* message = execution->context().message.get();
    if (message && std::count(messages_.begin(), messages_.end(), message) == 0)
      messages_.push_back(message);
  }
  bytes_.number(messages_.size());
  for (const auto* message : messages_)
    write_message(*message);
}

void StateWriter::write_message(const Message& message) {
  bytes_.signed_number(message.time);
  bytes_.number(message.number);
  bytes_.text(message.source);
  bytes_.text(message.command);
  bytes_.number(message.params.size());
  for (const auto& param : message.params)
    parlour::write(bytes_, param);
  bytes_.number(message.sinks.size());
  for (const auto& sink : message.sinks)
    bytes_.text(sink);
  bytes_.text(message.session);
  bytes_.number(message.correlation);
  bytes_.number(message.rounds);
}

// Frames are linked from the top, and written from the outermost.
void StateWriter::write(const Execution& execution) {
  write(execution.context());
  bytes_.byte(execution.waiting);
  frames_.clear();
  for (auto* frame = execution.top; frame; frame = frame->caller)
    frames_.push_back(frame);
  std::reverse(frames_.begin(), frames_.end());
  bytes_.number(frames_.size());
  for (auto* frame : frames_)
    write(*frame);
  bytes_.number(execution.copy_outs ? execution.copy_outs->size() : 0);
  if (execution.copy_outs)
    for (const auto& copy_out : *execution.copy_outs)
      write(copy_out);
}

// The message by its position among the messages, plus one.
void StateWriter::write(const ActivationContext& context) {
  const auto message =
      std::find(messages_.begin(), messages_.end(), context.message.get());
  bytes_.number(message == messages_.end()
                    ? 0
                    : static_cast<std::size_t>(message - messages_.begin()) +
                          1);
  bytes_.number(static_cast<std::uint32_t>(context.topic + 1)); // no_id: 0
  bytes_.number(static_cast<std::uint32_t>(context.slot + 1));
  bytes_.number(context.turn);
  bytes_.byte(context.handles_error);
  bytes_.byte(context.writes);
  bytes_.byte(context.leaves_state);
}

// Code and instruction are written as indices into the program.
void StateWriter::write(CallFrame& frame) {
  const auto at = frame.pc - frame.code->instructions.data();
  bytes_.number(
      static_cast<std::size_t>(frame.code - machine_.program->code.data()));
  bytes_.number(static_cast<std::size_t>(at));
  bytes_.number(frame.capacity - frame.code->register_count);
  const FrameCheck check(*frame.code, static_cast<std::uint32_t>(at));
  for (std::uint16_t i = 0; i < frame.code->register_count; ++i)
    write_register(frame.registers()[i], check, i);
}

// A binding or missing argument that a failed call has left behind is never
// read again; it is written as unknown.
void StateWriter::write_register(const Box& box, const FrameCheck& check,
                                 std::uint16_t reg) {
  if (box.is_reference() && check.may_be_bound(reg))
    return write_binding(box.target());
  if (box.is_missing() && check.may_be_missing(reg))
    return put(RegisterTag::missing);
  objects_.write(bytes_, box.is_reference() || box.is_missing() ? Box() : box);
}

// Finds out by its address what a parameter is bound to.
void StateWriter::write_binding(const Box* target) {
  const auto within = [&](const Box* first, std::size_t count) {
    const std::less<const Box*> before;
    return !before(target, first) && before(target, first + count);
  };
  const auto& variables = machine_.variables;
  if (within(variables.data(), variables.size())) {
    put(RegisterTag::bound_variable);
    return bytes_.number(static_cast<std::size_t>(target - variables.data()));
  }
  const auto frame =
      std::find_if(frames_.begin(), frames_.end(), [&](CallFrame* candidate) {
        return within(candidate->registers(), candidate->code->register_count);
      });
  if (frame == frames_.end())
    return put(RegisterTag::missing); // impossible: targets outlive bindings
  put(RegisterTag::bound_register);
  bytes_.number(static_cast<std::size_t>(frame - frames_.begin()));
  bytes_.number(static_cast<std::size_t>(target - (*frame)->registers()));
}

// The frame is one of those just written.
void StateWriter::write(const CopyOut& copy_out) {
  const auto frame = std::find(frames_.begin(), frames_.end(), copy_out.frame);
  bytes_.number(static_cast<std::size_t>(frame - frames_.begin()));
  bytes_.number(copy_out.parameter);
  bytes_.number(copy_out.variable);
}

} // namespace

std::string state_of(const Machine& machine,
                     const std::vector<const Execution*>& executions) {
  return StateWriter(machine, executions).write();
}

} // namespace parlour::script
