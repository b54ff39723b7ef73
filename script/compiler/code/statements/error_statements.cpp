// Errors (language rule 9).
#include "script/compiler/code/statements/error_statements.hpp"

namespace parlour::script {

// An error that was caught and is thrown again is recognised at run time
// (Machine::raise_box).
void ErrorStatements::throw_(const Element& element) {
  const auto mark = b_.mark();
  const auto value = b_.allocate();
  initial(element, value);
  b_.emit(Operation::raise, value);
  b_.release(mark);
}

// Guards what was emitted since `from` by a handler, which may be null: the
// error is then dropped. Ranges are added when their blocks end, so inner ones
// come first.
//
//   from:  …                        the guarded block
//       jump end
//   catch [from, here): …           the handler; the error is in a register
//   end:
//
// The register has the name that the author gave it and also the name _ERROR
// (language rule 9.3).
void ErrorStatements::catch_errors(std::uint32_t from, const Element* handler) {
  const auto to = b_.here();
  const auto done = b_.emit(Operation::jump);
  b_.open_scope();
  const auto* name = handler ? handler->attribute("name") : nullptr;
  const auto error_register = b_.declare(name ? name->value : " ");
  b_.alias("_ERROR", error_register);
  b_.code.catches.push_back({from, to, b_.here(), error_register, false});
  if (handler) {
    reached(*handler);
    block(*handler);
  }
  b_.close_scope();
  b_.land(done);
}

// Without a <catch> the block is simply compiled.
void ErrorStatements::try_(const Element& element) {
  const auto from = b_.here();
  block(element, {"catch"});
  if (const auto* handler = element.child("catch"))
    return catch_errors(from, handler);
  b_.findings.add({Severity::warning,
                   {element.position},
                   "<try> needs a <catch>; without one, errors pass on",
                   "catchless-try"});
}

} // namespace parlour::script
