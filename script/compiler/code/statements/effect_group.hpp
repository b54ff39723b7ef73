// EffectGroup: what the compilers of statements with effects share: operands,
// and the effect itself.
#pragma once

#include "script/compiler/code/statements/statement_group.hpp"

namespace parlour::script {

// How an operand of an effect is written in its element.
enum class OperandForm : std::uint8_t {
  text,     // text with {expr}
  either,   // text or expression
  value,    // expression
  duration, // "1.5s", becomes milliseconds
  params,   // param or <param> children, as a list
  state,    // the name of a state, checked unless it has {expr}
  topic,
  handler,
  slot,
  source,     // a component's, not one of the platform's own
  new_source, // a name that messages will come from
};

class EffectGroup : public StatementGroup {
public:
  using StatementGroup::StatementGroup;

protected:
  // Emits the effect; operands are consecutive registers from `base`.
  void perform(EffectKind kind, Register result, Register base,
               std::size_t operands, EffectShape others = {});
  // Compiles an attribute into a register by its form.
  void operand(const Element& element, const char* attribute, OperandForm form,
               Register target);
  // The parameters of a message as a list.
  void params(const Element& element, Register target, bool forwards);
  // The state or topic of a literal name, found now instead of at each run.
  std::uint32_t meaning(const Attribute* name, OperandForm form) const;

private:
  void checked_name(const Attribute& attribute, OperandForm form,
                    Register target);
  void check_source(const Attribute& attribute);
  void check_new_source(const Attribute& attribute);
  void duration(const Attribute& attribute, Register target);
};

} // namespace parlour::script
