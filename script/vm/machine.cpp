#include "script/vm/machine.hpp"

#include <algorithm>

#include "script/values/convert.hpp"

namespace parlour::script {

namespace {

constexpr std::size_t stack_lines = 20;
constexpr std::uint64_t clean_up_fuel = 1000;

std::size_t index_of(const Frame& frame) {
  return static_cast<std::size_t>(frame.pc - frame.code->instructions.data());
}

Position position_of(const Frame& frame) {
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

// In place of a smaller one that may be there.
Frame* Execution::make_above(std::uint32_t registers) {
  release_above();
  auto* memory = heap_->allocate(sizeof(Frame) + registers * sizeof(Box));
  auto* frame =
      new (memory) Frame{nullptr, top, nullptr, nullptr, registers, 1};
  std::uninitialized_default_construct_n(frame->registers(), registers);
  if (top) {
    top->above = frame;
    frame->depth = top->depth + 1;
  }
  return frame;
}

Frame* Execution::push(const Code& code, std::uint32_t room) {
  auto* frame = top ? top->above : nullptr;
  if (!frame || frame->capacity < code.register_count)
    frame = make_above(code.register_count + room);
  frame->code = &code;
  frame->pc = code.instructions.data();
  top = frame;
  return frame;
}

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

void Execution::release(Frame* frame) {
  while (frame) {
    auto* next = frame->above;
    heap_->release(frame, sizeof(Frame) + frame->capacity * sizeof(Box));
    frame = next;
  }
}

// -- errors -------------------------------------------------------------------

bool Machine::raise(ErrorKind kind, std::string message) {
  Place place;
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

// A caught error thrown again keeps its place (language rule 9.2).
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
  raise(ErrorKind::thrown, std::move(text));
  error_.error()->value = value;
  return false;
}

bool Machine::check(Outcome outcome) {
  return !outcome || raise(std::move(*outcome));
}

bool Machine::within_limits() {
  if (!heap_->over_limit()) [[likely]]
    return true;
  return raise(ErrorKind::limit, "the session's values hold more than " +
                                     std::to_string(heap_->limit()) + " bytes");
}

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

const CatchRange* Machine::find_catch(const Frame& frame) const {
  const auto at = index_of(frame);
  const bool limit = error_.error()->kind == ErrorKind::limit;
  for (const auto& range : frame.code->catches)
    if (at >= range.from && at < range.to && (range.always || !limit))
      return &range;
  return nullptr;
}

bool Machine::recover() {
  if (!raised_)
    return false;
  raised_ = false;
  for (; execution->top; execution->pop()) {
    auto& frame = *execution->top;
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

// -- fuel ---------------------------------------------------------------------

void Machine::new_event() {
  left_ = instructions;
  grace_given_ = false;
}

void Machine::set_event_fuel(const EventFuel& event_fuel) {
  instructions = event_fuel.instructions;
  left_ = event_fuel.left; // from bytes: never more than an event may have
  if (left_ > instructions && left_ - instructions > clean_up_fuel)
    left_ = instructions;
  grace_given_ = event_fuel.grace_given;
}

void Machine::take_slice() {
  give_back_fuel();
  const auto taken = std::min(left_, slice);
  left_ -= taken;
  fuel = static_cast<std::int64_t>(taken);
}

// What the run left of its slice is the event's, and what it took beyond it.
std::uint64_t Machine::fuel_left() const {
  const auto overdrawn = static_cast<std::uint64_t>(fuel < 0 ? -fuel : 0);
  return left_ - std::min(left_, overdrawn) +
         static_cast<std::uint64_t>(fuel < 0 ? 0 : fuel);
}

void Machine::give_back_fuel() {
  left_ = fuel_left();
  fuel = 0;
}

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

bool Machine::goes_on_beyond_slice() {
  if (static_cast<std::uint64_t>(-fuel) < left_) [[likely]]
    return true;
  left_ = 0;
  return refuel();
}

std::size_t Machine::walk_budget() const {
  const auto most = heap_->limit() / sizeof(Box);
  return 2 * std::min<std::size_t>(fuel_left(), most / 2) + 1000;
}

// -- running ------------------------------------------------------------------

// What belongs to the run in progress; a host may let another activation run
// while it performs an effect.
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

RunResult Machine::outcome() {
  RunResult result;
  switch (stop_) {
  case Stop::finished: {
    bool truncated = false;
    result.value = to_value(value_, walk_budget(), &truncated);
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
  if (activation.waiting) // only resume() ends that
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
    frame->registers()[frame->pc->a] = to_box(*heap_, *outcome_of_wait);
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
