// Calls, effects and what a machine asks the world for.
#include <algorithm>
#include <span>

#include "script/expression/builtins.hpp"
#include "script/values/convert.hpp"
#include "script/vm/builtin_call.hpp"
#include "script/vm/builtin_functions.hpp"
#include "script/vm/machine.hpp"

namespace parlour::script {

namespace {

// Instructions that take about as long as a call of a built-in.
constexpr std::int64_t builtin_cost = 10;

std::string arguments(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " argument" : " arguments");
}

} // namespace

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

bool Machine::call_builtin(std::uint16_t index, Box* arguments,
                           std::size_t count, Box& result) {
  Box value;
  BuiltinCall made{*this, builtin(index).name, arguments, count, value};
  fuel -= builtin_cost;
  if (!builtin_function(index)(made))
    return false;
  result = std::move(value);
  return within_limits();
}

bool Machine::call_named(Box* named, std::size_t count) {
  std::string name;
  print(name, named[0], 1000);
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

// -- by-reference parameters across a wait (language rule 7.3) ----------------

namespace {

bool has_bound_parameter(Frame& frame) {
  for (std::uint16_t i = 0; i < frame.code->parameter_count; ++i)
    if (frame.registers()[i].is_reference())
      return true;
  return false;
}

} // namespace

void Machine::release_bindings() {
  bool bound = false;
  for (auto* frame = execution->top; frame; frame = frame->caller)
    bound = bound || has_bound_parameter(*frame);
  if (!bound)
    return;
  std::vector<Frame*> frames;
  for (auto* frame = execution->top; frame; frame = frame->caller)
    frames.push_back(frame);
  std::vector<Box*> held(variables.size(), nullptr);
  const std::less<const Box*> before;
  auto& pending = execution->copy_outs;
  for (auto each = frames.rbegin(); each != frames.rend(); ++each)
    for (std::uint16_t i = 0; i < (*each)->code->parameter_count; ++i) {
      auto& parameter = (*each)->registers()[i];
      if (!parameter.is_reference())
        continue;
      auto* target = parameter.target();
      if (before(target, variables.data()) ||
          !before(target, variables.data() + variables.size()))
        continue; // a caller's register waits along with us
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

void Machine::copy_out(Frame& frame) {
  auto& pending = execution->copy_outs;
  if (!pending) [[likely]]
    return;
  std::erase_if(*pending, [&](const CopyOut& copy) {
    if (copy.frame != &frame)
      return false;
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
  // No more than the session could hold, and at the cost of its size.
  const auto most = std::min(walk_budget(), heap_->limit() / sizeof(Box)) + 1;
  auto left = most;
  for (const auto& box : std::span(operands, given.size() + captured.size()))
    if (box.is_object() || box.is_reference())
      weigh(box, left);
    else if (left > 0)
      --left; // one value, whatever it is
  if (left == 0)
    return raise(ErrorKind::limit, "a value is too large to leave the script");
  if (!charge(most - left))
    return false;
  fuel -= 5;
  Effect effect(static_cast<EffectKind>(shape.kind), given, captured);
  effect.body = shape.body;
  effect.target = shape.target;
  const auto& frame = *execution->top;
  effect.position = frame.code->positions[static_cast<std::size_t>(
      frame.pc - frame.code->instructions.data())];
  const auto performed = host->perform(*execution, effect);
  if (const auto* value = std::get_if<Value>(&performed)) {
    result = to_box(*heap_, *value);
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

// What comes in costs by its size.
Box Machine::taken_in(const Value& value) {
  constexpr std::size_t bytes_per_unit = 32;
  const auto before = heap_->used();
  auto box = to_box(*heap_, value);
  fuel -= static_cast<std::int64_t>((heap_->used() - before) / bytes_per_unit);
  return box;
}

void Machine::load_slot(SlotId slot, Box& result) {
  result = taken_in(host->slot(execution->context().topic, slot));
}

void Machine::store_slot(SlotId slot, const Box& value) {
  host->set_slot(execution->context().topic, slot,
                 to_value(value, walk_budget()));
}

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
    result = to_box(*heap_, host->system(*execution, variable));
  }
}

void Machine::load_message_parameter(std::size_t index, Box& result) {
  const auto* message = execution->context().message.get();
  result = message && index < message->params.size()
               ? taken_in(message->params[index])
               : Box();
}

// An empty list where no message is handled.
void Machine::load_message_parameters(Box& result) {
  const auto* message = execution->context().message.get();
  result = make_list(*heap_);
  if (message)
    for (const auto& param : message->params)
      result.list()->elements.push_back(taken_in(param));
}

} // namespace parlour::script
