#include "script/compiler/variable_use.hpp"

#include <vector>

#include "script/program/code_queue.hpp"
#include "script/program/instruction.hpp"

namespace parlour::script {

namespace {

struct Callee {
  CodeId code = no_code;
};

// The code that a filling event runs.
CodeQueue<Callee> code_of(const Program& program, const Topic& topic) {
  CodeQueue<Callee> queue(program);
  for (const auto& constraint : topic.constraints)
    for (const auto code : {constraint.condition, constraint.message})
      queue.add({code});
  for (const auto& slot : topic.slots) {
    for (const auto code : {slot.initial, slot.condition,
                            slot.cardinality.minimum, slot.cardinality.maximum})
      queue.add({code});
    for (const auto code : slot.cardinality.values)
      queue.add({code});
  }
  return queue;
}

// For each session variable, whether the topic's conditions and texts name it,
// or the functions that these call. All, where a function is called by a name
// that is computed.
std::vector<bool> variables_read(const Program& program, const Topic& topic) {
  std::vector<bool> read(program.variables.size());
  auto queue = code_of(program, topic);
  while (const auto next = queue.take())
    for (const auto& instruction : program.code[next->code].instructions) {
      const auto operation = static_cast<Operation>(instruction.operation);
      if (operation == Operation::load_variable ||
          operation == Operation::bind_variable)
        read[instruction.b] = true;
      else if (operation == Operation::call)
        queue.add({instruction.wide()});
      else if (operation == Operation::call_named)
        return std::vector<bool>(read.size(), true);
    }
  return read;
}

} // namespace

void note_read_variables(Program& program) {
  for (auto& topic : program.topics) {
    const auto read = variables_read(program, topic);
    for (std::size_t at = 0; at < read.size(); ++at)
      if (read[at])
        topic.read_variables.push_back(at);
  }
}

} // namespace parlour::script
