#include "script/program/effect_search.hpp"

#include "script/program/code_queue.hpp"
#include "script/program/instruction.hpp"

namespace parlour::script {

namespace {

// A breadth-first search over calls, so that the effect found is the nearest
// and its message the easiest to understand.
class EffectSearch {
public:
  EffectSearch(const Program& program,
               const std::function<bool(EffectKind)>& wanted)
      : program_(program), wanted_(wanted), waiting_(program) {}

  std::optional<EffectFound> find(CodeId code) {
    waiting_.add({code, {}, false});
    for (auto next = waiting_.take(); next && !found_; next = waiting_.take())
      look_at(*next);
    return found_;
  }

private:
  struct Callee {
    CodeId code = no_code;
    Position call; // in the first code
    bool is_called = false;
  };

  void look_at(const Callee& one) {
    const auto& code = program_.code[one.code];
    for (std::size_t i = 0; i < code.instructions.size(); ++i) {
      const auto& instruction = code.instructions[i];
      const auto position = code.positions[i];
      const auto operation = static_cast<Operation>(instruction.operation);
      if (operation == Operation::call)
        waiting_.add(
            {instruction.wide(), one.is_called ? one.call : position, true});
      else if (operation == Operation::effect)
        take(code.effects[instruction.c], position, one);
    }
  }

  // The first effect found is the nearest.
  void take(const EffectShape& effect, Position position, const Callee& one) {
    const auto kind = static_cast<EffectKind>(effect.kind);
    if (!found_ && wanted_(kind))
      found_ = EffectFound{kind, position, one.call, one.is_called};
  }

  const Program& program_;
  const std::function<bool(EffectKind)>& wanted_;
  CodeQueue<Callee> waiting_;
  std::optional<EffectFound> found_;
};

} // namespace

std::optional<EffectFound>
find_effect(const Program& program, CodeId code,
            const std::function<bool(EffectKind)>& wanted) {
  return EffectSearch(program, wanted).find(code);
}

} // namespace parlour::script
