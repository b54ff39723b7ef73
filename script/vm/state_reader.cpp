// Reads the format of interpreter_state.hpp. A state may come from a file that
// was damaged or forged, so each number is checked before it is used.

#include <algorithm>
#include <limits>

#include "runtime/base/value_bytes.hpp"
#include "script/program/instruction.hpp"
#include "script/values/object_bytes.hpp"
#include "script/vm/frame_check.hpp"
#include "script/vm/interpreter_state.hpp"
#include "script/vm/program_identity.hpp"

namespace parlour::script {

namespace {

// Reads a state in the order in which StateWriter wrote it. Every index is
// checked against what it indexes, and every register by FrameCheck.
class StateReader {
public:
  StateReader(Machine& machine, std::string_view bytes)
      : machine_(machine), program_(*machine.program), bytes_(bytes),
        objects_(bytes_, machine.heap(), *machine.program->pool) {}

  Expected<Executions> read();

private:
  void read_header();
  Box read_variable(std::size_t index);
  void read_fuel();
  void read_messages();
  Message read_message();
  std::unique_ptr<Execution> read_execution();
  ActivationContext read_context();
  void read_frames(Execution& execution);
  void read_frame(Execution& execution);
  void read_registers(CallFrame& frame);
  Box read_register(std::uint16_t reg, const FrameCheck& check);
  Box read_bound_register(std::uint16_t reg);
  void check_frames(const Execution& execution);
  void check_bindings(CallFrame& frame);
  bool goes_on_with(const CallFrame& caller, const CallFrame& callee) const;
  void read_copy_outs(Execution& execution);

  Machine& machine_;
  const Program& program_;
  ByteReader bytes_;
  ObjectReader objects_;
  std::vector<std::shared_ptr<const Message>> messages_;
  std::vector<CallFrame*> frames_; // of the execution being read
  std::vector<FrameCheck> checks_; // of these
};

// A frame that was made for a larger code has unused registers.
constexpr std::size_t max_room = std::numeric_limits<std::uint16_t>::max();

Operation operation_at(const CallFrame& frame) {
  return static_cast<Operation>(frame.pc->operation);
}

// Everything is read into a new machine; after an error it is thrown away.
Expected<Executions> StateReader::read() {
  Executions executions;
  read_header();
  objects_.read_objects();
  read_fuel();
  for (std::size_t i = 0; i < machine_.variables.size() && bytes_.ok(); ++i)
    machine_.variables[i] = read_variable(i);
  read_messages();
  const auto count = bytes_.count("activations");
  for (std::size_t i = 0; i < count && bytes_.ok(); ++i)
    executions.push_back(read_execution());
  if (bytes_.ok() && !bytes_.at_end())
    bytes_.fail("more bytes follow the state");
  if (!bytes_.ok())
    return tl::make_unexpected(bytes_.error());
  return executions;
}

// A state of another program would fit neither code nor constants.
void StateReader::read_header() {
  const auto version = bytes_.byte();
  if (version != state_version)
    bytes_.fail("this state is of version " + std::to_string(version) +
                ", but only " + std::to_string(state_version) +
                " can be read here; start the session anew");
  if (bytes_.fixed() != identity_of(program_))
    bytes_.fail("this state belongs to another program; load the program that "
                "wrote it, or start the session anew");
}

// Only what the program has an initial value for may be missing.
Box StateReader::read_variable(std::size_t index) {
  const auto tag = bytes_.byte();
  if (tag != static_cast<std::uint8_t>(RegisterTag::missing))
    return objects_.read(tag);
  if (!program_.initial_values->has(index))
    bytes_.fail("variable " + std::to_string(index) +
                " has no initial value that every session shares");
  return Box::missing();
}

void StateReader::read_fuel() {
  EventFuel fuel;
  fuel.instructions = bytes_.number();
  fuel.left = bytes_.number();
  fuel.grace_given = bytes_.below(2, "a flag");
  machine_.set_event_fuel(fuel);
}

// Activations share the messages by pointer, as before.
void StateReader::read_messages() {
  const auto count = bytes_.count("messages");
  for (std::size_t i = 0; i < count && bytes_.ok(); ++i)
    messages_.push_back(std::make_shared<const Message>(read_message()));
}

// The message that an activation handles, with all that scripts can see of it.
Message StateReader::read_message() {
  Message message;
  message.time = bytes_.signed_number();
  message.number = bytes_.number();
  message.source = bytes_.text();
  message.command = bytes_.text();
  const auto params = bytes_.count("parameters");
  for (std::size_t i = 0; i < params && bytes_.ok(); ++i)
    message.params.push_back(read_value(bytes_));
  const auto sinks = bytes_.count("sinks");
  for (std::size_t i = 0; i < sinks && bytes_.ok(); ++i)
    message.sinks.emplace_back(bytes_.text());
  message.session = bytes_.text();
  message.correlation = bytes_.number();
  message.rounds =
      static_cast<std::uint32_t>(bytes_.below(std::uint64_t{1} << 32, "round"));
  return message;
}

// The frames are checked only when all of them have been read, as bindings lead
// from one to another.
std::unique_ptr<Execution> StateReader::read_execution() {
  auto execution = machine_.adopt(read_context());
  execution->waiting = bytes_.below(2, "a flag");
  read_frames(*execution);
  if (bytes_.ok())
    check_frames(*execution);
  read_copy_outs(*execution);
  return execution;
}

// Topics and slots are stored plus one, so that 0 is no_id.
ActivationContext StateReader::read_context() {
  ActivationContext context;
  if (const auto message = bytes_.below(messages_.size() + 1, "message"))
    context.message = messages_[message - 1];
  const auto topic = bytes_.below(program_.topics.size() + 1, "topic");
  context.topic = static_cast<TopicId>(topic) - 1; // 0: no_id
  // Without a topic there can be no slot.
  const auto slots = context.topic == no_id || !bytes_.ok()
                         ? std::size_t{0}
                         : program_.topics[context.topic].slots.size();
  context.slot = static_cast<SlotId>(bytes_.below(slots + 1, "slot")) - 1;
  context.turn = bytes_.number();
  context.handles_error = bytes_.below(2, "a flag");
  context.writes = bytes_.below(2, "a flag");
  context.leaves_state = bytes_.below(2, "a flag");
  return context;
}

// No deeper than calls may be; the frames are pushed from the outermost in.
void StateReader::read_frames(Execution& execution) {
  const auto max_depth = program_.settings.limits.depth + std::uint64_t{2};
  const auto count = bytes_.below(max_depth, "depth of calls");
  frames_.clear();
  checks_.clear();
  for (std::size_t i = 0; i < count && bytes_.ok(); ++i)
    read_frame(execution);
}

// The instruction is an index, so it is known to exist before pc is set.
void StateReader::read_frame(Execution& execution) {
  const auto id = bytes_.below(program_.code.size(), "code");
  if (!bytes_.ok())
    return;
  const auto& code = program_.code[id];
  const auto at = bytes_.below(code.instructions.size(), "instruction");
  if (!bytes_.ok())
    return;
  const auto room = std::min(objects_.room_for_more(sizeof(Box)), max_room);
  frames_.push_back(execution.push(code, static_cast<std::uint32_t>(room)));
  frames_.back()->pc += at;
  read_registers(*frames_.back());
}

// Unknown is left in the registers behind an error; the machine is not used
// then.
void StateReader::read_registers(CallFrame& frame) {
  const auto at = frame.pc - frame.code->instructions.data();
  const auto& check =
      checks_.emplace_back(*frame.code, static_cast<std::uint32_t>(at));
  for (std::uint16_t i = 0; i < frame.code->register_count && bytes_.ok(); ++i)
    frame.registers()[i] = read_register(i, check);
  if (!bytes_.ok())
    return;
  if (const auto* broken = check.find_broken_loop(frame.registers()))
    bytes_.fail(broken);
}

// Bound parameters and missing arguments are accepted only where the compiler
// could have put them.
Box StateReader::read_register(std::uint16_t reg, const FrameCheck& check) {
  const auto tag = bytes_.byte();
  switch (static_cast<RegisterTag>(tag)) {
  case RegisterTag::missing:
    if (check.may_be_missing(reg))
      return Box::missing();
    break;
  case RegisterTag::bound_variable:
    if (const auto at = bytes_.below(machine_.variables.size(), "variable");
        bytes_.ok() && check.may_be_bound(reg))
      return Box::reference(&machine_.variables[at]);
    break;
  case RegisterTag::bound_register:
    if (check.may_be_bound(reg))
      return read_bound_register(reg);
    break;
  default:
    return objects_.read(tag);
  }
  bytes_.fail("register " + std::to_string(reg) + " cannot hold this");
  return {};
}

// A parameter may be bound to a register of an outer frame, which lives longer,
// or to an earlier register of its own frame, because variables lie before the
// arguments that are prepared for a call. It may not be bound to a register
// that controls a loop.
Box StateReader::read_bound_register(std::uint16_t reg) {
  const auto at = bytes_.below(frames_.size(), "frame");
  if (!bytes_.ok())
    return {};
  auto& frame = *frames_[at];
  const auto target = static_cast<std::uint16_t>(
      bytes_.below(frame.code->register_count, "register"));
  if (bytes_.ok() && ((&frame == frames_.back() && target >= reg) ||
                      checks_[at].steers_a_loop(target)))
    bytes_.fail("a parameter is bound to what no variable is");
  return bytes_.ok() ? Box::reference(&frame.registers()[target]) : Box();
}

// Each frame but the top must stand at the call of the frame above; a waiting
// activation must stand at an effect.
void StateReader::check_frames(const Execution& execution) {
  for (std::size_t i = 1; i < frames_.size(); ++i)
    if (!goes_on_with(*frames_[i - 1], *frames_[i]))
      return bytes_.fail("a frame was not called by the one below it");
  for (auto* frame : frames_)
    check_bindings(*frame);
  if (execution.waiting &&
      (frames_.empty() || operation_at(*frames_.back()) != Operation::effect))
    bytes_.fail("an activation waits for no effect");
}

// A binding leads to a value directly, never to another binding.
void StateReader::check_bindings(CallFrame& frame) {
  for (std::uint16_t i = 0; i < frame.code->register_count; ++i) {
    const auto& box = frame.registers()[i];
    if (box.is_reference() &&
        (box.target()->is_reference() || box.target()->is_missing()))
      bytes_.fail("a parameter is bound to what holds no value");
  }
}

// A call by name may have any callee; another one has that of its instruction.
bool StateReader::goes_on_with(const CallFrame& caller,
                               const CallFrame& callee) const {
  if (operation_at(caller) == Operation::call_named)
    return true;
  return operation_at(caller) == Operation::call &&
         &program_.code[caller.pc->wide()] == callee.code;
}

// The parameter must hold a copy, not a binding: it is stored to the variable.
void StateReader::read_copy_outs(Execution& execution) {
  const auto count = bytes_.count("parameters to be copied out");
  for (std::size_t i = 0; i < count && bytes_.ok(); ++i) {
    const auto frame = bytes_.below(frames_.size(), "frame");
    if (!bytes_.ok())
      return;
    const auto parameters = frames_[frame]->code->parameter_count;
    const auto parameter = bytes_.below(parameters, "parameter");
    const auto variable = bytes_.below(machine_.variables.size(), "variable");
    if (!bytes_.ok())
      return;
    const auto& box = frames_[frame]->registers()[parameter];
    if (box.is_reference() || box.is_missing())
      return bytes_.fail("what is to be copied out is no value");
    if (!execution.copy_outs)
      execution.copy_outs = std::make_unique<std::vector<CopyOut>>();
    execution.copy_outs->push_back({frames_[frame],
                                    static_cast<std::uint16_t>(parameter),
                                    static_cast<std::uint32_t>(variable)});
  }
}

} // namespace

Expected<Executions> restore_state(Machine& machine, std::string_view bytes) {
  return StateReader(machine, bytes).read();
}

} // namespace parlour::script
