#include "script/program/constant_text.hpp"

#include "script/program/instruction.hpp"
#include "script/values/objects.hpp"

namespace parlour::script {

const Box* constant_of(const Code& code) {
  if (code.body > 0 || code.instructions.size() < 2)
    return nullptr;
  const auto& load = code.instructions[0];
  const auto& give = code.instructions[1];
  const bool constant =
      load.operation == static_cast<std::uint8_t>(Operation::load_constant) &&
      give.operation == static_cast<std::uint8_t>(Operation::give_back) &&
      load.a == give.a;
  return constant ? &code.constants[load.b] : nullptr;
}

std::optional<std::string_view> constant_text(const Program& program,
                                              CodeId code) {
  const auto* constant = constant_of(program.code[code]);
  if (!constant || !constant->is(ObjectType::string))
    return std::nullopt;
  return constant->text();
}

} // namespace parlour::script
