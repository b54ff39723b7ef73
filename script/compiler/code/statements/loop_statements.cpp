// Loops (language rule 6).
#include "script/compiler/code/statements/loop_statements.hpp"

#include "script/compiler/code/statements/transaction_statements.hpp"

namespace parlour::script {

// Lands the jumps of <break>.
void LoopStatements::end_loop() {
  b_.land(body_.loops.back().breaks);
  body_.loops.pop_back();
}

// Five registers control the loop; Machine::for_prepare describes them. The
// fifth is the loop variable, which is declared last.
//
//       for_prepare -> end          if there is no round
//   body:  …
//       for_next -> body            also the target of <continue>
//   end:
void LoopStatements::for_(const Element& element) {
  if (element.attribute("each"))
    return for_each(element);
  b_.open_scope();
  const auto base = b_.allocate(4); // see Machine::for_prepare
  if (const auto* from = required(element, "from"))
    expressions_.expression(source_of(*from), static_cast<Register>(base + 1));
  b_.load(static_cast<Register>(base + 2), Box::small(1));
  if (const auto* step = element.attribute("step"))
    expressions_.expression(source_of(*step), static_cast<Register>(base + 2));
  if (const auto* to = required(element, "to"))
    expressions_.expression(source_of(*to), static_cast<Register>(base + 3));
  const auto* name = required(element, "name");
  b_.declare(name ? name->value : " ");
  b_.at(element.position);
  const auto none = b_.emit(Operation::for_prepare, base);
  const auto body = b_.here();
  body_.loops.push_back({{}, {}, body_.transactions.size()});
  block(element);
  b_.land(body_.loops.back().continues);
  b_.at(element.position);
  b_.back(Operation::for_next, base, body);
  b_.land(none);
  end_loop();
  b_.close_scope();
}

// Four registers: the list, the position, the element and its index.
//
//       each_prepare
//   next: each_next -> end
//       …                           the body
//       loop -> next                also the target of <continue>
//   end:
void LoopStatements::for_each(const Element& element) {
  b_.open_scope();
  const auto base = b_.allocate(2); // the list and the position
  if (const auto* collection = required(element, "in"))
    expressions_.expression(source_of(*collection), base);
  b_.emit(Operation::each_prepare, base, base);
  const auto* index = element.attribute("index");
  b_.declare(element.attribute("each")->value);
  b_.declare(index ? index->value : " ");
  const auto next = b_.here();
  const auto done = b_.emit(Operation::each_next, base);
  body_.loops.push_back({{}, {}, body_.transactions.size()});
  block(element);
  b_.land(body_.loops.back().continues);
  b_.at(element.position);
  b_.back(Operation::loop, 0, next);
  b_.land(done);
  end_loop();
  b_.close_scope();
}

// The condition is tested at the top; <continue> jumps to the jump back.
//
//   start: condition -> end
//       …                           the body
//       loop -> start               costs fuel for one round
//   end:
void LoopStatements::while_(const Element& element) {
  const auto start = b_.here();
  const auto otherwise = condition(element, "cond");
  body_.loops.push_back({{}, {}, body_.transactions.size()});
  block(element);
  b_.land(body_.loops.back().continues);
  b_.at(element.position);
  b_.back(Operation::loop, 0, start);
  b_.land(otherwise);
  end_loop();
}

// Transactions that were opened inside of the loop are committed before leaving
// (language rule 11.3); those around it stay open.
void LoopStatements::break_(const Element& element) {
  if (body_.loops.empty())
    return error(element.position,
                 body_.in_case
                     ? "<break> stands outside of a loop; a <case> ends "
                       "by itself: leave it out"
                     : "<break> stands outside of a loop");
  TransactionStatements(body_).end(body_.loops.back().transactions);
  body_.loops.back().breaks.push_back(b_.emit(Operation::jump));
}

void LoopStatements::continue_(const Element& element) {
  if (body_.loops.empty())
    return error(element.position, "<continue> stands outside of a loop");
  TransactionStatements(body_).end(body_.loops.back().transactions);
  body_.loops.back().continues.push_back(b_.emit(Operation::jump));
}

} // namespace parlour::script
