// Operands of effects, in the order of effects.def.
#include "script/compiler/code/statements/effect_group.hpp"

#include "runtime/base/clock.hpp"
#include "runtime/message/roles.hpp"

namespace parlour::script {

namespace {

bool is_computed(const std::string& text) {
  return text.find('{') != std::string::npos;
}

std::vector<std::string> keys(const auto& map) {
  std::vector<std::string> all;
  for (const auto& [name, value] : map)
    all.push_back(name);
  return all;
}

} // namespace

// Emits the effect; operands are consecutive registers from `base`.
void EffectGroup::perform(EffectKind kind, Register result, Register base,
                          std::size_t operands, EffectShape others) {
  others.kind = static_cast<std::uint8_t>(kind);
  others.operands = static_cast<std::uint16_t>(operands);
  b_.emit(Operation::effect, result, base, b_.shape(others));
}

void EffectGroup::operand(const Element& element, const char* attribute,
                          OperandForm form, Register target) {
  if (form == OperandForm::params)
    return params(element, target, false);
  const auto* given = element.attribute(attribute);
  if (!given)
    return b_.load(target, Box());
  const auto source = source_of(*given);
  switch (form) {
  case OperandForm::either:
    return expressions_.text_or_expression(source, target);
  case OperandForm::value:
    return expressions_.expression(source, target);
  case OperandForm::duration:
    return duration(*given, target);
  case OperandForm::text:
    return expressions_.text(source, target);
  default:
    return checked_name(*given, form, target);
  }
}

void EffectGroup::duration(const Attribute& attribute, Register target) {
  if (is_computed(attribute.value)) {
    expressions_.text(source_of(attribute), target);
    b_.emit(Operation::milliseconds, target, target);
    return;
  }
  const auto parsed = parse_duration(attribute.value);
  if (!parsed)
    return error(attribute.value_position, parsed.error().message);
  b_.load(target, b_.program.pool->integer(parsed->count()));
}

// Names of states, topics, handlers and slots are checked here, unless they are
// computed (language rule 12.1).
void EffectGroup::checked_name(const Attribute& attribute, OperandForm form,
                               Register target) {
  expressions_.text(source_of(attribute), target);
  const auto& name = attribute.value;
  if (is_computed(name))
    return;
  if (form == OperandForm::source)
    return check_source(attribute);
  if (form == OperandForm::new_source)
    return check_new_source(attribute);
  std::vector<std::string> known;
  const char* what = "slot";
  if (form == OperandForm::slot) {
    if (!b_.context.topic)
      return error(attribute.position, "a slot has a meaning in a topic only");
    for (const auto& slot : b_.context.topic->slots)
      known.push_back(slot.name);
  } else if (form == OperandForm::state) {
    what = "state";
    known = keys(b_.names.states);
  } else if (form == OperandForm::topic) {
    what = "topic";
    known = keys(b_.names.topics);
  } else {
    what = "handler";
    known = keys(b_.names.handlers);
  }
  for (const auto& each : known)
    if (each == name)
      return;
  error(attribute.value_position, std::string("there is no ") + what + " '" +
                                      name + "'" + did_you_mean(name, known));
}

// The platform's own sources need no subscription (language rule 12.15).
void EffectGroup::check_source(const Attribute& attribute) {
  const auto* role = find_role(attribute.value);
  if (role && role->reserved)
    error(attribute.value_position,
          "events of '" + role->name +
              "' come without <subscribe> to whoever takes them in <messages>");
}

void EffectGroup::check_new_source(const Attribute& attribute) {
  if (auto fault = wrong_source_name(attribute.value); !fault.empty())
    error(attribute.value_position, std::move(fault));
}

// The state or topic of a literal name, found now instead of at each run.
std::uint32_t EffectGroup::meaning(const Attribute* name,
                                   OperandForm form) const {
  if (!name || is_computed(name->value))
    return no_id;
  switch (form) {
  case OperandForm::state:
    return b_.program.state(name->value);
  case OperandForm::topic:
    return b_.program.topic(name->value);
  default:
    return no_id;
  }
}

// An empty `param` means no parameters. Without any, a <post> forwards those of
// the message being handled (language rule 12.6).
void EffectGroup::params(const Element& element, Register target,
                         bool forwards) {
  std::vector<const Attribute*> given;
  for (const auto& child : element.children)
    if (child.is("param"))
      given.push_back(child.attribute("expr"));
  const auto* single = element.attribute("param");
  if (given.empty() && !single && forwards) {
    b_.emit(Operation::load_message_parameters, target);
    return;
  }
  const bool has_single = single && !single->value.empty();
  const auto count = given.size() + has_single;
  const auto base = b_.allocate(count);
  if (has_single)
    expressions_.text_or_expression(source_of(*single), base);
  for (std::size_t i = 0; i < given.size(); ++i)
    if (given[i])
      expressions_.expression(source_of(*given[i]),
                              static_cast<Register>(base + has_single + i));
  b_.emit(Operation::new_list, target, base, count);
  b_.release(base);
}

} // namespace parlour::script
