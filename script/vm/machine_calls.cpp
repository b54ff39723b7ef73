// Calls, effects, and what a machine asks of the world.
#include <algorithm>
#include <span>

#include "script/expression/builtins.hpp"
#include "script/values/convert.hpp"
#include "script/vm/builtin_call.hpp"
#include "script/vm/builtin_functions.hpp"
#include "script/vm/machine.hpp"

namespace parlour::script {

namespace {

// An effect takes about as long as this many instructions.
constexpr std::size_t effect_cost = 5;

std::string arguments(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " argument" : " arguments");
}

} // namespace

// Called only when a new frame is needed, so the depth costs nothing otherwise.
bool Machine::may_call(const Code& callee) {
  if (execution->top->depth < program->settings.limits.depth)
    return true;
  return raise(ErrorKind::limit,
               "more than " + std::to_string(program->settings.limits.depth) +
                   " calls inside of each other, the last one of " +
                   callee.name);
}

bool Machine::call(const Code& callee, Box* arguments, std::size_t count) {
  if (!enter(execution->top, callee, arguments, count))
    return false;
  fuel -= callee.cost;
  return fuel > 0 || (within_limits() && refuel());
}

// The result goes through a local box, because it may be the register of an
// argument that the function still reads.
bool Machine::call_builtin(std::uint16_t index, Box* arguments,
                           std::size_t count, Box& result) {
  Box value;
  BuiltinCall made{*this, builtin(index).name, arguments, count, value};
  take(builtin_cost);
  if (!builtin_function(index)(made))
    return false;
  result = std::move(value);
  return within_limits();
}

// <call> with a computed name: the arguments are prepared as for a call by
// reference, so for a built-in the references are replaced by their values.
bool Machine::call_named(Box* named, std::size_t count) {
  std::string name;
  print(name, named[0], 1000);
  // The arguments follow the register of the name.
  auto* given = named + 1;
  if (auto there = program->functions.find(name);
      there != program->functions.end()) {
    const auto& callee = program->code[there->second];
    if (count < callee.required_count || count > callee.parameter_count)
      return raise(ErrorKind::type,
                   "'" + name + "' does not take " + arguments(count));
    return call(callee, given, count);
  }
  for (std::size_t i = 0; i < count; ++i)
    if (given[i].is_reference())
      given[i] = Box(*given[i].target());
  const auto index = builtin_index(name);
  if (!index)
    return raise(ErrorKind::type, "there is no function '" + name + "'");
  if (count < builtin(*index).minimum || count > builtin(*index).maximum)
    return raise(ErrorKind::type,
                 "'" + name + "' does not take " + arguments(count));
  if (!call_builtin(*index, given, count, named[0]))
    return false;
  ++execution->top->pc;
  return true;
}

// The slow path of `leave` (handlers_calls.hpp).
bool Machine::give_back(Box value) {
  auto* caller = execution->top->caller;
  copy_out(*execution->top);
  execution->pop();
  if (!caller) {
    value_ = std::move(value);
    stop_ = Stop::finished;
    return false;
  }
  caller->registers()[caller->pc->a] = std::move(value);
  ++caller->pc;
  return true;
}

// -- parameters by reference across a wait (language rule 7.3) ----------------

namespace {

// Only parameters can be bound.
bool has_bound_parameter(CallFrame& frame) {
  for (std::uint16_t i = 0; i < frame.code->parameter_count; ++i)
    if (frame.registers()[i].is_reference())
      return true;
  return false;
}

} // namespace

// While an activation waits, other scripts may set the session variables, and
// the state may be written to bytes. A parameter that is bound to a session
// variable therefore becomes a copy of it before the wait, and the copy is
// stored back when its frame ends. Several parameters may be bound to one
// variable: the outermost gets the copy and the others are bound to it, so that
// they still see each other's changes.
void Machine::release_bindings() {
  bool bound = false;
  for (auto* frame = execution->top; frame; frame = frame->caller)
    bound = bound || has_bound_parameter(*frame);
  if (!bound)
    return;
  std::vector<CallFrame*> frames;
  for (auto* frame = execution->top; frame; frame = frame->caller)
    frames.push_back(frame);
  // The parameter that holds the copy of each variable, if any.
  std::vector<Box*> held(variables.size(), nullptr);
  const std::less<const Box*> before;
  auto& pending = execution->copy_outs;
  // From the outermost frame in, so that the outermost gets the copy.
  for (auto each = frames.rbegin(); each != frames.rend(); ++each)
    for (std::uint16_t i = 0; i < (*each)->code->parameter_count; ++i) {
      auto& parameter = (*each)->registers()[i];
      if (!parameter.is_reference())
        continue;
      auto* target = parameter.target();
      if (before(target, variables.data()) ||
          !before(target, variables.data() + variables.size()))
        continue; // a register waits with us
      const auto variable = static_cast<std::size_t>(target - variables.data());
      if (held[variable]) {
        parameter = Box::reference(held[variable]);
        continue;
      }
      held[variable] = &parameter;
      parameter = Box(*target);
      if (!pending)
        pending = std::make_unique<std::vector<CopyOut>>();
      pending->push_back({*each, i, static_cast<std::uint32_t>(variable)});
    }
}

// Called whenever a frame ends, also by an error.
void Machine::copy_out(CallFrame& frame) {
  auto& pending = execution->copy_outs;
  if (!pending) [[likely]]
    return;
  std::erase_if(*pending, [&](const CopyOut& copy) {
    if (copy.frame != &frame)
      return false;
    ++writes;
    variables[copy.variable] = frame.registers()[copy.parameter];
    return true;
  });
  if (pending->empty())
    pending.reset();
}

// -- effects ------------------------------------------------------------------

bool Machine::perform(const EffectShape& shape, const Box* operands,
                      Box& result) {
  const std::span given(operands, shape.operands);
  const std::span captured(operands + shape.operands, shape.captured);
  // A value that leaves may be as large as a session's values, and costs fuel
  // by its size.
  auto budget = walk_budget();
  for (const auto& box : std::span(operands, given.size() + captured.size()))
    if (box.is_object() || box.is_reference())
      measure(box, budget);
    else
      budget.values();
  if (!pay(budget, "a value is too large to leave the script"))
    return false;
  take(effect_cost);
  Effect effect(static_cast<EffectKind>(shape.kind), given, captured);
  effect.body = shape.body;
  effect.target = shape.target;
  const auto& frame = *execution->top;
  effect.position = frame.code->positions[static_cast<std::size_t>(
      frame.pc - frame.code->instructions.data())];
  const auto performed = host->perform(*execution, effect);
  if (const auto* value = std::get_if<Value>(&performed)) {
    result = taken_in(*value);
    return within_limits();
  }
  if (const auto* error = std::get_if<Error>(&performed))
    return raise(error->kind, error->message);
  if (to_the_end_)
    return raise(ErrorKind::refused, "nothing can be waited for here");
  release_bindings();
  execution->release_above();
  execution->waiting = true;
  stop_ = Stop::waiting;
  return false;
}

Box Machine::taken_in(const Value& value) {
  const auto before = heap_->used();
  auto box = to_box(*heap_, value);
  take(WalkBudget::price_of_bytes(heap_->used() - before));
  return box;
}

void Machine::load_slot(SlotId slot, Box& result) {
  const auto own = execution->context().topic;
  result = taken_in(is_foreign(slot) ? host->slot(topic_of_foreign(slot),
                                                  slot_of_foreign(slot))
                                     : host->slot(own, slot));
}

void Machine::store_slot(SlotId slot, const Box& value) {
  auto budget = walk_budget();
  auto copy = to_value(value, budget);
  take(budget.price());
  host->set_slot(execution->context().topic, slot, std::move(copy));
}

// What concerns the message comes from the activation; only the rest is asked
// of the host.
void Machine::load_system(SystemVariable variable, Box& result) {
  const auto* message = execution->context().message.get();
  auto text = [&](const std::string* of_message) {
    result = of_message ? make_string(*heap_, *of_message) : Box();
  };
  switch (variable) {
  case SystemVariable::source:
    return text(message ? &message->source : nullptr);
  case SystemVariable::command:
    return text(message ? &message->command : nullptr);
  case SystemVariable::timestamp:
    result = message ? make_integer(*heap_, message->time) : Box();
    return;
  case SystemVariable::params:
    return load_message_parameters(result);
  default:
    result = taken_in(host->system(*execution, variable));
  }
}

void Machine::load_message_parameter(std::size_t index, Box& result) {
  const auto* message = execution->context().message.get();
  result = message && index < message->params.size()
               ? taken_in(message->params[index])
               : Box();
}

// The list is empty if no message is being handled.
void Machine::load_message_parameters(Box& result) {
  const auto* message = execution->context().message.get();
  result = make_list(*heap_);
  if (message)
    for (const auto& param : message->params)
      result.list()->elements.push_back(taken_in(param));
}

} // namespace parlour::script
