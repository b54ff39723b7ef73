// The dispatch loop. With GCC and Clang every handler ends in its own indirect
// jump to the next instruction's label ("threaded code"), so the processor
// predicts each of these jumps separately; that is where most of an
// interpreter's time goes otherwise. Other compilers get a switch in a loop.
//
// A handler returns false if something else must happen first: an error is
// raised, or the activation waits, yields or ends. Then recover() finds the
// <catch> to continue at, or the loop is left.
#include "script/program/instruction.hpp"
#include "script/vm/handlers_calls.hpp"
#include "script/vm/machine.hpp"

namespace parlour::script {

const char* name_of(Operation operation) {
  static constexpr const char* names[] = {
#define INSTRUCTION(name, sentence) #name,
#include "script/program/instructions.def"
#undef INSTRUCTION
  };
  return names[static_cast<std::size_t>(operation)];
}

#if defined(__GNUC__)

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic" // labels as values

void Machine::dispatch() {
  static const void* const labels[] = {
#define INSTRUCTION(name, sentence) &&at_##name,
#include "script/program/instructions.def"
#undef INSTRUCTION
  };
  auto cursor = handlers::at_top(*execution);
  goto* labels[cursor.pc->operation];
#define INSTRUCTION(name, sentence)                                            \
  at_##name : if (handlers::name(*this, cursor))                               \
                  [[likely]] goto* labels[cursor.pc->operation];               \
  goto stopped;
#include "script/program/instructions.def"
#undef INSTRUCTION
stopped:
  if (!recover())
    return;
  cursor = handlers::at_top(*execution);
  goto* labels[cursor.pc->operation];
}

#pragma GCC diagnostic pop

#else

void Machine::dispatch() {
  auto cursor = handlers::at_top(*execution);
  for (;;) {
    bool ok = true;
    switch (static_cast<Operation>(cursor.pc->operation)) {
#define INSTRUCTION(name, sentence)                                            \
  case Operation::name:                                                        \
    ok = handlers::name(*this, cursor);                                        \
    break;
#include "script/program/instructions.def"
#undef INSTRUCTION
    }
    if (!ok) {
      if (!recover())
        return;
      cursor = handlers::at_top(*execution);
    }
  }
}

#endif

} // namespace parlour::script
