// From syntax trees to instructions. An example: with the local variables x in
// r0 and y in r1, the expression `x + 1 lt y * 2` becomes
//
//   r3 = r0 + 1       add_constant
//   r4 = r1 * 2       multiply_constant
//   r2 = r3 < r4      less
//
// `into` has a case for each kind of node; `any` avoids a copy for variables;
// `jump` (expression_conditions.cpp) compiles conditions.

#include "script/compiler/code/expressions/expression_compiler.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "script/compiler/code/expressions/literal_arguments.hpp"
#include "script/expression/builtins.hpp"

namespace parlour::script {

namespace {

std::string arguments_text(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " argument" : " arguments");
}

// "1 argument" or "1 to 3 arguments".
std::string range_text(std::size_t minimum, std::size_t maximum) {
  return minimum == maximum
             ? arguments_text(minimum)
             : std::to_string(minimum) + " to " + arguments_text(maximum);
}

std::vector<std::string> slot_names(const Topic& topic) {
  std::vector<std::string> names;
  for (const auto& slot : topic.slots)
    names.push_back(slot.name);
  return names;
}

// In the order of Operator. `unequal` is `equal` with the flag reversed, and
// the greater ones are the less ones with the operands exchanged.
constexpr std::array<Operation, 12> plain_operations{
    Operation::equal,      Operation::equal,  Operation::less,
    Operation::less_equal, Operation::less,   Operation::less_equal,
    Operation::contained,  Operation::add,    Operation::subtract,
    Operation::multiply,   Operation::divide, Operation::modulo};

// The instruction for a small integer on the right side, if there is one.
std::optional<Operation> constant_operation(Operator operation) {
  switch (operation) {
  case Operator::add:
    return Operation::add_constant;
  case Operator::subtract:
    return Operation::subtract_constant;
  case Operator::multiply:
    return Operation::multiply_constant;
  case Operator::modulo:
    return Operation::modulo_constant;
  default:
    return {};
  }
}

} // namespace

// Whether the node is a literal; its value is put into `box`.
bool ExpressionCompiler::constant_of(const Node& node, Box& box) {
  switch (node.kind) {
  case NodeKind::unknown:
    box = Box();
    return true;
  case NodeKind::boolean:
    box = Box::boolean(node.flag);
    return true;
  case NodeKind::integer:
    box = b_.program.pool->integer(node.integer);
    return true;
  case NodeKind::number:
    box = Box::number(node.number);
    return true;
  case NodeKind::string:
    box = b_.program.pool->string(node.text);
    return true;
  default:
    return false;
  }
}

// A local needs no instruction at all: its register is the operand.
Register ExpressionCompiler::any(const Node& node, const Source& source) {
  if (node.kind == NodeKind::name)
    if (auto meaning = b_.find(node.text); meaning.local)
      return meaning.local->reg;
  const auto target = b_.allocate();
  into(node, source, target);
  return target;
}

// Temporaries of the operands are released at the end, so the target must lie
// below them or be a variable.
void ExpressionCompiler::into(const Node& node, const Source& source,
                              Register target) {
  Box box;
  if (constant_of(node, box))
    return b_.load(target, std::move(box));
  const auto mark = b_.mark();
  switch (node.kind) {
  case NodeKind::name:
    name(node, source, target);
    break;
  case NodeKind::list:
  case NodeKind::map:
    elements(node, source, target);
    break;
  case NodeKind::call:
    call(node, source, target);
    break;
  case NodeKind::index: {
    const auto container = any(*node.children[0], source);
    const auto key = any(*node.children[1], source);
    b_.emit(Operation::get_index, target, container, key);
    break;
  }
  case NodeKind::field:
    if (is_this_field(node)) {
      slot(node, source, target);
    } else if (is_foreign_field(node)) {
      foreign_slot(node, source, target);
    } else {
      const auto container = any(*node.children[0], source);
      b_.emit(Operation::get_field, target, container,
              b_.text_constant(node.text));
    }
    break;
  case NodeKind::negate:
  case NodeKind::invert: {
    const auto operand = any(*node.children[0], source);
    b_.emit(node.kind == NodeKind::negate ? Operation::negate
                                          : Operation::invert,
            target, operand);
    break;
  }
  case NodeKind::binary:
    binary(node, source, target);
    break;
  case NodeKind::choice:
    choice(node, source, target);
    break;
  default:
    logical(node, source, target);
  }
  b_.release(mark);
}

// A parameter may be bound to a variable, so reading it looks through the
// binding.
void ExpressionCompiler::name(const Node& node, const Source& source,
                              Register target) {
  const auto meaning = b_.find(node.text);
  switch (meaning.kind) {
  case Meaning::Kind::local:
    b_.emit(meaning.local->is_parameter ? Operation::load_parameter
                                        : Operation::move,
            target, meaning.index);
    return;
  case Meaning::Kind::variable:
    b_.emit(Operation::load_variable, target, meaning.index);
    return;
  case Meaning::Kind::system:
    b_.emit(Operation::load_system, target, meaning.index);
    return;
  case Meaning::Kind::parameter:
    b_.emit(Operation::load_message_parameter, target, meaning.index);
    return;
  case Meaning::Kind::nothing:
    unknown_name(node, source);
  }
}

// Pseudo-slots hide slots of the same name.
SlotId ExpressionCompiler::slot_id(const Node& node, const Source& source) {
  if (!b_.context.topic) {
    error(node, source, "'this' has a meaning in a topic only");
    return no_id;
  }
  if (node.text == "rows")
    return slot_rows;
  if (node.text == "asked")
    return slot_asked;
  if (node.text == "relaxed")
    return slot_relaxed;
  if (node.text == "last")
    return slot_last;
  const auto id = b_.context.topic->slot(node.text);
  if (id != no_id)
    return id;
  auto slots = slot_names(*b_.context.topic);
  slots.insert(slots.end(), {"rows", "asked", "relaxed", "last"});
  error(node, source,
        "the topic '" + b_.context.topic->name + "' has no slot '" + node.text +
            "'" + did_you_mean(node.text, slots));
  return no_id;
}

void ExpressionCompiler::slot(const Node& node, const Source& source,
                              Register target) {
  b_.emit_wide(Operation::load_slot, target, slot_id(node, source));
}

// `Booking.Room`, if no variable hides the topic.
bool ExpressionCompiler::is_foreign_field(const Node& node) const {
  const auto& holder = *node.children[0];
  return holder.kind == NodeKind::name &&
         b_.find(holder.text).kind == Meaning::Kind::nothing &&
         b_.names.topics.contains(holder.text);
}

void ExpressionCompiler::foreign_slot(const Node& node, const Source& source,
                                      Register target) {
  const auto id = b_.program.topic(node.children[0]->text);
  const auto& topic = b_.program.topics[id];
  const auto slot = topic.slot(node.text);
  if (slot == no_id)
    return error(node, source,
                 "the topic '" + topic.name + "' has no slot '" + node.text +
                     "'" + did_you_mean(node.text, slot_names(topic)));
  if (auto& read = b_.program.read_elsewhere;
      std::ranges::find(read, id) == read.end())
    read.push_back(id);
  b_.emit_wide(Operation::load_slot, target, script::foreign_slot(id, slot));
}

// Arguments are computed into consecutive registers from `base`, where the call
// takes them.
void ExpressionCompiler::arguments(const Node& node, const Source& source,
                                   Register base) {
  for (std::size_t i = 0; i < node.children.size(); ++i)
    into(*node.children[i], source, static_cast<Register>(base + i));
}

// Calls need their arguments in consecutive registers at the end of the frame.
// The result of a compiled function comes back in the first of them; a built-in
// can put it anywhere.
void ExpressionCompiler::call(const Node& node, const Source& source,
                              Register target) {
  const auto count = node.children.size();
  // If the target is itself the last temporary, it serves as the first
  // argument's register and no move is needed.
  const bool in_target = b_.is_last_temporary(target);
  const auto base = in_target ? target : b_.allocate(count ? count : 1);
  if (in_target && count > 1)
    b_.allocate(count - 1);
  arguments(node, source, base);
  // The call itself has the position of its name, so that an error in it is
  // reported there.
  const auto before = b_.position();
  b_.at(source.at(node.offset));
  if (const auto* function = b_.function(node.text)) {
    if (count < function->required || count > function->parameters ||
        count > 255)
      error(node, source,
            "'" + node.text + "' takes " +
                range_text(function->required, function->parameters) +
                ", not " + std::to_string(count));
    b_.emit_wide(Operation::call, base, function->code,
                 static_cast<std::uint8_t>(count));
    if (base != target)
      b_.emit(Operation::move, target, base);
  } else if (const auto index = builtin_index(node.text)) {
    const auto& entry = builtin(*index);
    if (count < entry.minimum || count > entry.maximum)
      error(node, source,
            "'" + node.text + "' takes " +
                range_text(entry.minimum, entry.maximum) + ", not " +
                std::to_string(count));
    else if (const auto wrong = wrong_argument(node))
      error(*node.children[wrong->index], source, wrong->message);
    b_.emit(Operation::call_builtin, base, *index, target,
            static_cast<std::uint8_t>(count));
  } else {
    unknown_function(node, source);
  }
  b_.at(before);
}

// Elements (or keys and values) are computed into consecutive registers.
void ExpressionCompiler::elements(const Node& node, const Source& source,
                                  Register target) {
  const bool is_map = node.kind == NodeKind::map;
  const auto count = node.children.size();
  const auto base = b_.allocate(is_map ? 2 * count : count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto at = base + (is_map ? 2 * i : i);
    if (is_map)
      b_.load_text(static_cast<Register>(at), node.keys[i]);
    into(*node.children[i], source,
         static_cast<Register>(is_map ? at + 1 : at));
  }
  b_.emit(is_map ? Operation::new_map : Operation::new_list, target, base,
          count);
}

// Comparisons have no instruction with a constant here; in conditions they have
// (compare_jump).
void ExpressionCompiler::binary(const Node& node, const Source& source,
                                Register target) {
  const auto operation = node.operation;
  const auto left = any(*node.children[0], source);
  Box box;
  const auto with_constant = constant_operation(operation);
  if (with_constant && node.children[1]->kind == NodeKind::integer &&
      constant_of(*node.children[1], box) && box.is_small()) {
    b_.emit(*with_constant, target, left, b_.constant(box));
    return;
  }
  const auto right = any(*node.children[1], source);
  const bool swapped =
      operation == Operator::greater || operation == Operator::greater_equal;
  b_.emit(plain_operations[static_cast<std::size_t>(operation)], target,
          swapped ? right : left, swapped ? left : right,
          operation == Operator::equal);
}

// The operand that decides is the value (language rule 3.10). It is computed in
// a register of its own if the second operand could still read the target, as
// in x = y or x.
void ExpressionCompiler::logical(const Node& node, const Source& source,
                                 Register target) {
  const auto value = b_.is_last_temporary(target) ? target : b_.allocate();
  into(*node.children[0], source, value);
  const auto decided =
      b_.emit(Operation::jump_if, value, 0, 0, node.kind == NodeKind::either);
  into(*node.children[1], source, value);
  b_.land(decided);
  if (value != target)
    b_.emit(Operation::move, target, value);
}

// The condition jumps to the second branch if it is false.
void ExpressionCompiler::choice(const Node& node, const Source& source,
                                Register target) {
  std::vector<Label> otherwise;
  jump(*node.children[0], source, false, otherwise);
  into(*node.children[1], source, target);
  const auto done = b_.emit(Operation::jump);
  b_.land(otherwise);
  into(*node.children[2], source, target);
  b_.land(done);
}

// -- assignment ---------------------------------------------------------------

// A slot or session variable is stored to directly. An element or a field needs
// its container in a register; containers are shared by reference, so changing
// them there changes the variable's value (language rule 2.6).
bool ExpressionCompiler::assign(const Node& node, const Source& source,
                                Register from) {
  if (is_this_field(node)) {
    const auto id = slot_id(node, source);
    if (id >= slot_rows && id != no_id)
      error(node, source, "'this." + node.text + "' cannot be set");
    b_.emit_wide(Operation::store_slot, from, id);
    return true;
  }
  if (node.kind == NodeKind::index || node.kind == NodeKind::field) {
    const auto container = any(*node.children[0], source);
    if (node.kind == NodeKind::field)
      b_.emit(Operation::set_field, container, b_.text_constant(node.text),
              from);
    else
      b_.emit(Operation::set_index, container, any(*node.children[1], source),
              from);
    return true;
  }
  if (node.kind != NodeKind::name)
    return false;
  const auto meaning = b_.find(node.text);
  const bool is_constant =
      meaning.local ? meaning.local->is_constant
                    : meaning.kind == Meaning::Kind::variable &&
                          meaning.index < b_.program.variables.size() &&
                          b_.program.variables[meaning.index].is_constant;
  if (is_constant)
    error(node, source, "'" + node.text + "' is a constant");
  else if (meaning.kind == Meaning::Kind::local)
    b_.emit(meaning.local->is_parameter ? Operation::store_parameter
                                        : Operation::move,
            meaning.index, from);
  else if (meaning.kind == Meaning::Kind::variable)
    b_.emit(Operation::store_variable, from, meaning.index);
  else if (meaning.kind == Meaning::Kind::nothing)
    unknown_target(node, source);
  else
    error(node, source, "'" + node.text + "' is read-only");
  return true;
}

} // namespace parlour::script
