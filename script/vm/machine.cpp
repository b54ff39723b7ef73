// Call frames, errors, fuel, and running an activation from start to stop.

#include "script/vm/machine.hpp"

#include <algorithm>

#include "script/values/convert.hpp"

namespace parlour::script {

namespace {

// Lines of a script's stack in an error, and the fuel for cleaning up.
constexpr std::size_t stack_lines = 20;
constexpr std::uint64_t clean_up_fuel = 1000;

std::size_t index_of(const CallFrame& frame) {
  return static_cast<std::size_t>(frame.pc - frame.code->instructions.data());
}

Position position_of(const CallFrame& frame) {
  const auto at = index_of(frame);
  return at < frame.code->positions.size() ? frame.code->positions[at]
                                           : Position{};
}

} // namespace

// -- frames -------------------------------------------------------------------

Execution::~Execution() {
  while (top)
    pop();
}

// Replaces the frame above, which may be missing or too small.
CallFrame* Execution::make_above(std::uint32_t registers) {
  release_above();
  auto* memory = heap_->allocate(sizeof(CallFrame) + registers * sizeof(Box));
  auto* frame =
      new (memory) CallFrame{nullptr, top, nullptr, nullptr, registers, 1};
  std::uninitialized_default_construct_n(frame->registers(), registers);
  if (top) {
    top->above = frame;
    frame->depth = top->depth + 1;
  }
  return frame;
}

// Reuses the frame that an earlier call at this depth has left, if it is large
// enough for the code.
CallFrame* Execution::push(const Code& code, std::uint32_t room) {
  auto* frame = top ? top->above : nullptr;
  if (!frame || frame->capacity < code.register_count)
    frame = make_above(code.register_count + room);
  assert(frame->caller == top && frame->depth == (top ? top->depth + 1 : 1));
  frame->code = &code;
  frame->pc = code.instructions.data();
  top = frame;
  return frame;
}

// The frame stays above its caller, except the last one, which is freed with
// everything above it.
void Execution::pop() {
  auto* frame = std::exchange(top, top->caller);
  frame->clear();
  if (!top)
    release(frame);
}

void Execution::release_above() {
  if (top)
    release(std::exchange(top->above, nullptr));
}

void Execution::release(CallFrame* frame) {
  while (frame) {
    auto* next = frame->above;
    heap_->release(frame, sizeof(CallFrame) + frame->capacity * sizeof(Box));
    frame = next;
  }
}

// -- errors -------------------------------------------------------------------

// The place of the error is that of the top frame's current instruction.
bool Machine::raise(ErrorKind kind, std::string message) {
  SourceLocation place;
  if (execution && execution->top)
    place = program->place(position_of(*execution->top));
  error_ = make_error(*heap_, kind, std::move(message), std::move(place));
  raised_ = true;
  note_stack();
  return false;
}

bool Machine::raise(Failure failure) {
  return raise(failure.kind, std::move(failure.message));
}

// An error that was caught and is thrown again keeps its place (language rule
// 9.2); any other value becomes an error of kind Thrown.
bool Machine::raise_box(const Box& error_or_value) {
  const Box value = error_or_value.resolved();
  if (value.is(ObjectType::error)) {
    error_ = value;
    raised_ = true;
    note_stack();
    return false;
  }
  std::string text;
  if (!print(text, value, program->settings.limits.result))
    text = "a value too large to print";
  take(WalkBudget::price_of_bytes(text.size()));
  raise(ErrorKind::thrown, std::move(text));
  error_.error()->value = value;
  return false;
}

bool Machine::within_limits() {
  if (!heap_->over_limit()) [[likely]]
    return true;
  return raise(ErrorKind::limit, "the session's values hold more than " +
                                     std::to_string(heap_->limit()) + " bytes");
}

// The script's call stack for the error message, innermost call first.
void Machine::note_stack() {
  stack_.clear();
  if (!execution)
    return;
  for (auto* frame = execution->top; frame; frame = frame->caller) {
    if (stack_.size() == stack_lines) {
      stack_.emplace_back("…");
      return;
    }
    const auto place = program->place(position_of(*frame));
    stack_.push_back(frame->code->name + " (" + place.file + ":" +
                     std::to_string(place.line) + ")");
  }
}

// The ranges are sorted from the innermost. A limit can be taken by clean-up
// code only (language rule 9.6).
const CatchRange* Machine::find_catch(const CallFrame& frame) const {
  const auto at = index_of(frame);
  const bool limit = error_.error()->kind == ErrorKind::limit;
  for (const auto& range : frame.code->catches)
    if (at >= range.from && at < range.to && (range.always || !limit))
      return &range;
  return nullptr;
}

// Unwinds frame by frame. When a limit is reached, clean-up code such as a
// rollback gets a small extra amount of fuel, once for an event.
bool Machine::recover() {
  if (!raised_)
    return false;
  raised_ = false;
  for (; execution->top; execution->pop()) {
    auto& frame = *execution->top;
    // The error becomes a value in the handler's register.
    if (const auto* range = find_catch(frame)) {
      if (error_.error()->kind == ErrorKind::limit && !grace_given_) {
        grace_given_ = true; // for a rollback
        left_ += clean_up_fuel;
        take_slice();
      }
      frame.registers()[range->error_register] = std::move(error_);
      frame.pc = frame.code->instructions.data() + range->target;
      return true;
    }
    copy_out(frame);
  }
  stop_ = Stop::failed;
  return false;
}

// Fuel is kept in two parts: `fuel` counts down within the slice, and `left_`
// is the rest of the event's. Only when `fuel` is used up does anything more
// expensive than a subtraction happen.
// -- fuel ---------------------------------------------------------------------

void Machine::new_event() {
  left_ = instructions;
  grace_given_ = false;
}

void Machine::set_event_fuel(const EventFuel& event_fuel) {
  instructions = event_fuel.instructions;
  left_ = event_fuel.left; // may come from a forged state
  if (left_ > instructions && left_ - instructions > clean_up_fuel)
    left_ = instructions;
  grace_given_ = event_fuel.grace_given;
}

// Returns what is left of the old slice to the event and takes a new one.
void Machine::take_slice() {
  give_back_fuel();
  const auto taken = std::min(left_, slice);
  left_ -= taken;
  fuel = static_cast<std::int64_t>(taken);
}

// What is unused of the slice belongs to the event, and what was used beyond
// the slice is taken from it.
std::uint64_t Machine::fuel_left() const {
  const auto overdrawn = static_cast<std::uint64_t>(fuel < 0 ? -fuel : 0);
  return left_ - std::min(left_, overdrawn) +
         static_cast<std::uint64_t>(fuel < 0 ? 0 : fuel);
}

void Machine::give_back_fuel() {
  left_ = fuel_left();
  fuel = 0;
}

// Takes the next slice. Returns true only for a run that must not yield.
bool Machine::refuel() {
  take_slice();
  if (fuel == 0)
    return raise(ErrorKind::limit, "the script took more than " +
                                       std::to_string(instructions) +
                                       " instructions for one event");
  if (to_the_end_)
    return true;
  execution->release_above();
  stop_ = Stop::yielded;
  return false;
}

// The overdraft is fine as long as the event's fuel covers it.
bool Machine::goes_on_beyond_slice() {
  if (static_cast<std::uint64_t>(-fuel) < left_) [[likely]]
    return true;
  left_ = 0;
  return refuel();
}

// -- running ------------------------------------------------------------------

// Saves the members that belong to a run and sets those of the new one. Runs
// can be nested, because a host may run another activation while it performs an
// effect.
class RunScope {
public:
  RunScope(Machine& machine, Execution& execution, Host& host, bool to_the_end)
      : machine_(machine), host_(machine.host), execution_(machine.execution),
        fuel_(machine.fuel), stop_(machine.stop_), watched_(machine.watched),
        to_the_end_(machine.to_the_end_) {
    machine.host = &host;
    machine.execution = &execution;
    machine.fuel = 0;
    machine.stop_ = Stop::none;
    machine.raised_ = false;
    machine.watched = host.watches_branches();
    machine.to_the_end_ = to_the_end;
    machine.take_slice();
  }
  RunScope(const RunScope&) = delete;
  RunScope& operator=(const RunScope&) = delete;
  ~RunScope() {
    machine_.give_back_fuel();
    machine_.host = host_;
    machine_.execution = execution_;
    machine_.fuel = fuel_;
    machine_.stop_ = stop_;
    machine_.watched = watched_;
    machine_.to_the_end_ = to_the_end_;
  }

private:
  Machine& machine_;
  Host* host_;
  Execution* execution_;
  std::int64_t fuel_;
  Stop stop_;
  bool watched_;
  bool to_the_end_;
};

Machine::Machine(std::shared_ptr<const Program> shared_program)
    : heap_(std::make_shared<Heap>(shared_program,
                                   shared_program->settings.limits.bytes)),
      program(std::move(shared_program)), code(program->code.data()),
      instructions(program->settings.limits.instructions) {
  variables.resize(program->variables.size());
  new_event();
}

// The heap's limit is checked after the next instruction that makes something.
void Machine::make_initial(std::size_t index) {
  variables[index] =
      to_box(*heap_, (*program->initial_values)[index], *program->pool);
}

// Arguments that are not given are marked as missing if the code has defaults.
std::unique_ptr<Execution> Machine::start(CodeId body,
                                          const std::vector<Value>& values,
                                          ActivationContext context) {
  const auto& callee = program->code[body];
  auto activation = std::exchange(spare_, nullptr);
  if (activation)
    activation->begin(std::move(context));
  else
    activation = adopt(std::move(context));
  auto* frame = activation->push(callee);
  const auto given =
      std::min<std::size_t>(values.size(), callee.parameter_count);
  for (std::size_t i = 0; i < given; ++i)
    frame->registers()[i] = to_box(*heap_, values[i]);
  for (std::size_t i = given; callee.body > 0 && i < callee.parameter_count;
       ++i)
    frame->registers()[i] = Box::missing();
  return activation;
}

std::unique_ptr<Execution> Machine::adopt(ActivationContext context) {
  return std::make_unique<Execution>(heap_, std::move(context));
}

// Translates the reason for stopping into a result for the caller.
RunResult Machine::outcome() {
  RunResult result;
  switch (stop_) {
  case Stop::finished: {
    auto budget = walk_budget();
    result.value = to_value(value_, budget);
    take(budget.price());
    value_ = Box();
    break;
  }
  case Stop::waiting:
    result.status = RunStatus::waiting;
    break;
  case Stop::yielded:
    result.status = RunStatus::yielded;
    break;
  default:
    result.status = RunStatus::failed;
    result.error = to_error(*error_.error());
    result.stack = std::move(stack_);
    error_ = Box();
  }
  return result;
}

RunResult Machine::run(Execution& activation, Host& current_host,
                       bool to_the_end) {
  RunScope scope(*this, activation, current_host, to_the_end);
  if (!activation.top)
    return {};
  if (activation.waiting) // only resume() ends a wait
    return {RunStatus::waiting, {}, {}, {}};
  dispatch();
  return outcome();
}

std::optional<RunResult> Machine::run_body(Execution& activation,
                                           Host& current_host) {
  RunScope scope(*this, activation, current_host, false);
  dispatch();
  if (stop_ != Stop::finished)
    return outcome();
  value_ = Box();
  return std::nullopt;
}

// The frame still stands at its effect instruction, whose register `a` takes
// the outcome.
RunResult Machine::resume(Execution& activation,
                          const Expected<Value>& outcome_of_wait,
                          Host& current_host) {
  if (!activation.waiting)
    return run(activation, current_host, false);
  RunScope scope(*this, activation, current_host, false);
  auto* frame = activation.top;
  activation.waiting = false;
  if (!frame)
    return {};
  if (outcome_of_wait) {
    frame->registers()[frame->pc->a] = taken_in(*outcome_of_wait);
    ++frame->pc;
    if (!within_limits() && !recover())
      return outcome();
  } else {
    const auto& error = outcome_of_wait.error();
    raise(error.kind, error.message);
    if (!recover())
      return outcome();
  }
  dispatch();
  return outcome();
}

} // namespace parlour::script
