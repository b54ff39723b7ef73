// Bodies that run later or elsewhere: <timer> and <transit> (language rule 10).
#include "script/compiler/code/statements/detached_statements.hpp"

#include "script/compiler/code/expressions/mentioned_names.hpp"

namespace parlour::script {

namespace {

using F = OperandForm;
using K = EffectKind;

// A constant name is part of its body's name: by it a timer goes on when the
// script is changed (engine rule 7.12).
std::string timer_name(const Element& element) {
  const auto* name = element.attribute("name");
  return name && name->value.find('{') == std::string::npos
             ? "timer '" + name->value + "'"
             : "timer";
}

} // namespace

// Compiles the element's statements into a code of their own, as they run when
// this code may have ended. The visible locals that they mention become its
// parameters and are copied when the effect is performed (language rule 10.2).
CodeId DetachedStatements::detached(const Element& element, bool in_timer,
                                    std::vector<const Local*>& captured) {
  const auto mentioned = mentioned_names(element);
  for (const auto& local : b_.locals())
    if (b_.find(local.name).local == &local // not hidden
        && mentioned.contains(local.name))
      captured.push_back(&local);
  auto context = b_.context;
  context.in_timer |= in_timer;
  context.name =
      (in_timer ? timer_name(element) : "transit") + " in " + b_.code.name;
  CodeBuilder builder(b_.program, b_.names, b_.findings, context);
  builder.at(element.position);
  for (const auto* local : captured) {
    builder.adopt(local->name, local->is_constant);
    builder.code.parameter_names.push_back(local->name);
  }
  builder.code.parameter_count = static_cast<std::uint16_t>(captured.size());
  body_.body_apart(element, builder);
  b_.program.code.push_back(builder.finish());
  return static_cast<CodeId>(b_.program.code.size() - 1);
}

// Copies the captured locals into the registers behind an effect's operands.
Register
DetachedStatements::capture(const std::vector<const Local*>& captured) {
  const auto base = b_.allocate(captured.size());
  for (std::size_t i = 0; i < captured.size(); ++i)
    b_.emit(Operation::load_parameter, base + i, captured[i]->reg);
  return base;
}

void DetachedStatements::timer(const Element& element) {
  const auto base = b_.allocate(5);
  operand(element, "name", F::text, base);
  operand(element, "after", F::duration, static_cast<Register>(base + 1));
  operand(element, "repeat", F::value, static_cast<Register>(base + 2));
  operand(element, "keeps-open", F::value, static_cast<Register>(base + 3));
  operand(element, "ends-with", F::text, static_cast<Register>(base + 4));
  std::vector<const Local*> captured;
  const auto body = detached(element, true, captured);
  capture(captured);
  b_.at(element.position);
  perform(
      K::timer, base, base, 5,
      {.body = body, .captured = static_cast<std::uint16_t>(captured.size())});
  b_.release(base);
}

void DetachedStatements::transit(const Element& element) {
  const auto base = b_.allocate();
  operand(element, "state", F::state, base);
  std::vector<const Local*> captured;
  const auto body =
      element.children.empty() ? no_code : detached(element, false, captured);
  capture(captured);
  b_.at(element.position);
  perform(K::transit, base, base, 1,
          {.body = body,
           .captured = static_cast<std::uint16_t>(captured.size()),
           .target = meaning(element.attribute("state"), F::state)});
  b_.release(base);
}

} // namespace parlour::script
