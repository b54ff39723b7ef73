// Messages to components and to the conversation (language rules 12.3 to 12.6).
#include "script/compiler/code/statements/message_statements.hpp"

#include "script/compiler/code/statements/error_statements.hpp"

namespace parlour::script {

namespace {

using F = OperandForm;
using K = EffectKind;

} // namespace

void MessageStatements::post(const Element& element) {
  const auto base = b_.allocate(4);
  operand(element, "module", F::text, base);
  operand(element, "command", F::text, static_cast<Register>(base + 1));
  params(element, static_cast<Register>(base + 2), true);
  operand(element, "to-session", F::text, static_cast<Register>(base + 3));
  b_.at(element.position);
  perform(K::post, base, base, 4);
  b_.release(base);
}

void MessageStatements::request(const Element& element) {
  const auto from = b_.here();
  const auto base = b_.allocate(4);
  operand(element, "module", F::text, base);
  operand(element, "command", F::text, static_cast<Register>(base + 1));
  params(element, static_cast<Register>(base + 2), false);
  operand(element, "timeout", F::duration, static_cast<Register>(base + 3));
  b_.at(element.position);
  perform(K::request, base, base, 4);
  store_result(element.attribute("return"), base);
  if (const auto* handler = element.child("catch"))
    ErrorStatements(body_).catch_errors(from, handler);
}

void MessageStatements::fire(const Element& element) {
  const auto base = b_.allocate(2);
  if (element.attribute("event")) {
    operand(element, "event", F::text, base);
    params(element, static_cast<Register>(base + 1), false);
    b_.at(element.position);
    perform(K::fire_event, base, base, 2);
  } else {
    operand(element, "param", F::either, base);
    b_.at(element.position);
    perform(K::fire_frames, base, base, 1);
  }
  b_.release(base);
}

} // namespace parlour::script
