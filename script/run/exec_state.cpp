// The state of a run as bytes (runtime/base/bytes.hpp):
//
//   version      a byte, exec_state_version
//   clock        signed, the time of the event
//   random       fixed, the generator's state
//   order        number, of what was set last
//   started      a byte
//   running      a byte: an activation has yielded
//   interpreter  a block (interpreter_state.hpp): the activation that yielded,
//                then those that wait, in the order below
//   due          count; for each its time (signed), its order, and a byte that
//                tells whether it waits; if not, the timer's name, period, body
//                and arguments (the value of a list)
#include <algorithm>

#include "runtime/base/value_bytes.hpp"
#include "script/program/timer_limits.hpp"
#include "script/run/exec_run.hpp"

namespace parlour::script {

namespace {

constexpr std::uint8_t exec_state_version = 1;

// Times are limited so that adding durations cannot overflow.
Timestamp read_time(ByteReader& bytes, Timestamp latest) {
  const auto time = bytes.signed_number();
  if (time > latest || time < -latest)
    bytes.fail("a time is too far away");
  return bytes.ok() ? time : 0;
}

} // namespace

// -- writing ------------------------------------------------------------------

std::string ExecRun::save() const {
  std::vector<const Activation*> activations;
  if (current_)
    activations.push_back(current_.get());
  for (const auto& due : due_)
    if (due.waiting)
      activations.push_back(due.waiting.get());
  ByteWriter bytes;
  bytes.byte(exec_state_version);
  bytes.signed_number(now_);
  bytes.fixed(dice_.state());
  bytes.number(order_);
  bytes.byte(started_);
  bytes.byte(current_ != nullptr);
  bytes.text(interpreter_.save(activations));
  bytes.number(due_.size());
  for (const auto& due : due_)
    write(bytes, due);
  return bytes.take();
}

void ExecRun::write(ByteWriter& bytes, const Due& due) {
  bytes.signed_number(due.at);
  bytes.number(due.order);
  bytes.byte(due.waiting != nullptr);
  if (due.waiting)
    return;
  bytes.text(due.timer);
  bytes.number(static_cast<std::uint64_t>(due.every.count()));
  bytes.number(due.body);
  parlour::write(bytes, Value(due.arguments));
}

// -- reading ------------------------------------------------------------------

// The header is checked before the interpreter's part is read.
Expected<std::unique_ptr<ExecRun>>
ExecRun::restore(std::shared_ptr<const Program> program, ExecOptions options,
                 std::string_view bytes) {
  auto run = std::make_unique<ExecRun>(program, std::move(options));
  ByteReader reader(bytes);
  if (reader.byte() != exec_state_version)
    reader.fail("these are not the bytes of a run, or of another version");
  run->now_ = read_time(reader, latest);
  run->dice_ = Random(reader.fixed());
  run->order_ = reader.number();
  run->started_ = reader.below(2, "a flag");
  const bool running = reader.below(2, "a flag");
  const auto inside = reader.block();
  if (!reader.ok())
    return tl::make_unexpected(reader.error());
  auto state = Interpreter::restore(std::move(program), inside);
  if (!state)
    return tl::make_unexpected(std::move(state.error()));
  run->read_activations(reader, std::move(*state), running);
  if (!reader.ok())
    return tl::make_unexpected(reader.error());
  return run;
}

// The activations are in one list; each `due` that waits takes the next.
void ExecRun::read_activations(ByteReader& bytes, Restored state,
                               bool running) {
  interpreter_ = std::move(state.interpreter);
  interpreter_.limit_instructions(
      options_.instructions); // the reader's limit counts
  auto next = state.activations.begin();
  const auto take = [&]() -> std::unique_ptr<Activation> {
    if (next != state.activations.end())
      return std::move(*next++);
    bytes.fail("an activation is missing");
    return nullptr;
  };
  if (running)
    current_ = take();
  const auto count = bytes.count("what is due");
  for (std::size_t i = 0; i < count && bytes.ok(); ++i) {
    Due due;
    due.at = read_time(bytes, latest);
    due.order = bytes.number();
    if (bytes.below(2, "a flag"))
      due.waiting = take();
    else
      read_timer(bytes, due);
    due_.push_back(std::move(due));
  }
  if (bytes.ok() && (!bytes.at_end() || next != state.activations.end()))
    bytes.fail("more follows than a run has");
}

void ExecRun::read_timer(ByteReader& bytes, Due& due) const {
  due.timer = bytes.text();
  due.every = Milliseconds(bytes.below(latest + 1, "period"));
  due.body = static_cast<CodeId>(
      bytes.below(interpreter_.program().code.size(), "code"));
  const auto arguments = read_value(bytes);
  if (const auto* list = arguments.if_list())
    due.arguments = *list;
  else
    bytes.fail("a timer has not its arguments");
  due.bytes = remembered(due.arguments);
}

} // namespace parlour::script
