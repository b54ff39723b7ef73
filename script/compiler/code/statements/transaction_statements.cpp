// Transactions (language rules 11.3 and 11.4).
#include "script/compiler/code/statements/transaction_statements.hpp"

namespace parlour::script {

// The body is guarded by a range that also takes limits (CatchRange::always):
// it rolls back and throws the error again (language rule 11.3). The commit
// lies within the range, so its failure rolls back, too.
//
//       begin
//   from:  …                        the body
//       commit
//       jump end
//   catch [from, here): rollback
//       raise the error again
//   end:
void TransactionStatements::transaction(const Element& element) {
  if (!body_.transactions.empty())
    error(element.position, "a <transaction> cannot stand in another one");
  b_.open_scope();
  const auto database = b_.allocate();
  const auto outcome = b_.allocate();
  operand(element, "db", OperandForm::text, database);
  perform(EffectKind::begin, outcome, database, 1);
  body_.transactions.push_back(database);
  const auto from = b_.here();
  block(element);
  body_.transactions.pop_back();
  b_.at(element.position);
  perform(EffectKind::commit, outcome, database, 1);
  const auto done = b_.emit(Operation::jump);
  const auto failure = b_.allocate();
  b_.code.catches.push_back({from, b_.here(), b_.here(), failure, true});
  perform(EffectKind::rollback, outcome, database, 1);
  b_.emit(Operation::raise, failure);
  b_.land(done);
  b_.close_scope();
}

// Leaving a transaction by return, break or continue commits it (language rule
// 11.3).
void TransactionStatements::end(std::size_t outside) {
  const auto mark = b_.mark();
  const auto outcome = b_.allocate();
  for (auto i = body_.transactions.size(); i > outside; --i)
    perform(EffectKind::commit, outcome, body_.transactions[i - 1], 1);
  b_.release(mark);
}

} // namespace parlour::script
