// CodeBuilder: emitting instructions, registers and scopes, and looking up
// names. Limits of the instruction format (65,535 registers, constants and
// effects; 16 bits for some distances) are noted in too_large_ while code is
// emitted and reported once by finish().

#include "script/compiler/code/expressions/code_builder.hpp"

#include <algorithm>
#include <charconv>

#include "runtime/base/text/utf8.hpp"
#include "script/xml/attribute_check.hpp"

namespace parlour::script {

namespace {

constexpr std::size_t largest = 0xffff;
constexpr std::size_t dearest_call = 32;

} // namespace

Source source_of(const Attribute& attribute) {
  const bool is_condition = attribute.name == "cond" || attribute.name == "if";
  return {attribute.value,
          attribute.value_position,
          false,
          {},
          0,
          is_condition ? Wanted::condition : Wanted::value};
}

// Moves over the text's lines and characters; entities before the offset were
// replaced and count as one character, so this is only nearly exact.
Position Source::at(std::size_t offset) const {
  auto position = start;
  for (char byte : text.substr(0, offset)) {
    if (byte == '\n') {
      ++position.line;
      position.column = 1;
    } else if (!continues_code_point(byte)) {
      ++position.column;
    }
  }
  return position;
}

// _LPARAM1 is parameter 0; a trailing underscore is accepted.
std::optional<std::uint32_t> message_parameter(std::string_view name) {
  constexpr std::string_view prefix = "_LPARAM";
  if (!name.starts_with(prefix))
    return {};
  name.remove_prefix(prefix.size());
  if (name.ends_with('_')) // `_LPARAM1_` means the same
    name.remove_suffix(1);
  std::uint32_t number = 0;
  const auto* last = name.data() + name.size();
  auto [end, error] = std::from_chars(name.data(), last, number);
  if (error != std::errc{} || end != last || number == 0 || number > largest)
    return {};
  return number - 1;
}

std::optional<SystemVariable> system_variable(std::string_view name) {
#define X(variable, text)                                                      \
  if (name == (text))                                                          \
    return SystemVariable::variable;
  PARLOUR_SYSTEM_VARIABLES(X)
#undef X
  return {};
}

CodeBuilder::CodeBuilder(Program& shared_program, const Names& all_names,
                         Findings& all_findings, BodyContext body_context)
    : program(shared_program), names(all_names), findings(all_findings),
      context(std::move(body_context)) {
  code.name = std::move(context.name);
  code.instructions.reserve(16);
  code.positions.reserve(16);
}

// Operands are cut to 16 bits; whatever could exceed them sets too_large_.
Label CodeBuilder::emit(Operation operation, std::size_t a, std::size_t b,
                        std::size_t c, std::uint8_t flag) {
  code.instructions.push_back({static_cast<std::uint8_t>(operation), flag,
                               static_cast<std::uint16_t>(a),
                               static_cast<std::uint16_t>(b),
                               static_cast<std::uint16_t>(c)});
  code.positions.push_back(position_);
  return code.instructions.size() - 1;
}

Label CodeBuilder::emit_wide(Operation operation, std::size_t a,
                             std::uint32_t wide, std::uint8_t flag) {
  const auto label = emit(operation, a);
  code.instructions[label].flag = flag;
  code.instructions[label].set_wide(wide);
  return label;
}

void CodeBuilder::land(Label label) {
  exits_to(label, here());
}

void CodeBuilder::land(const std::vector<Label>& labels) {
  for (auto label : labels)
    land(label);
}

// Only the compare-and-jump instructions, which are in a row in
// instructions.def, have their distance in `c`.
void CodeBuilder::exits_to(Label label, std::uint32_t target) {
  auto& instruction = code.instructions[label];
  const auto distance = target - static_cast<std::uint32_t>(label);
  const auto operation = static_cast<Operation>(instruction.operation);
  // All other jumps have 32 bits for their distance.
  if (operation < Operation::jump_if_equal ||
      operation > Operation::jump_if_greater_equal_constant) {
    instruction.set_wide(distance);
    return;
  }
  too_large_ |= distance > 0x7fff; // they have 16 bits for it
  instruction.c = static_cast<std::uint16_t>(distance);
}

// Backward distances are stored as positive numbers; the instruction subtracts.
void CodeBuilder::back(Operation operation, std::size_t a,
                       std::uint32_t target) {
  emit_wide(operation, a, here() - target);
}

// Searching the first constants suffices to share the frequent ones and keeps
// compiling linear.
std::uint16_t CodeBuilder::constant(Box box) {
  for (std::size_t i = 0; i < code.constants.size() && i < 256; ++i)
    if (code.constants[i].same_bits(box))
      return static_cast<std::uint16_t>(i);
  too_large_ |= code.constants.size() >= largest;
  code.constants.push_back(std::move(box));
  return static_cast<std::uint16_t>(code.constants.size() - 1);
}

std::uint16_t CodeBuilder::text_constant(std::string_view text) {
  return constant(program.pool->string(text));
}

void CodeBuilder::load(Register target, Box constant_value) {
  emit(Operation::load_constant, target, constant(std::move(constant_value)));
}

void CodeBuilder::load_text(Register target, std::string_view text) {
  emit(Operation::load_constant, target, text_constant(text));
}

std::uint16_t CodeBuilder::shape(EffectShape effect) {
  code.effects.push_back(effect);
  too_large_ |= code.effects.size() > largest;
  return static_cast<std::uint16_t>(code.effects.size() - 1);
}

Instruction* CodeBuilder::only(std::uint32_t from, Operation operation) {
  if (here() != from + 1)
    return nullptr;
  auto& last = code.instructions.back();
  return static_cast<Operation>(last.operation) == operation ? &last : nullptr;
}

Instruction CodeBuilder::take_back() {
  const auto last = code.instructions.back();
  code.instructions.pop_back();
  code.positions.pop_back();
  return last;
}

bool CodeBuilder::is_last_temporary(Register reg) const {
  return reg + 1 == next_ &&
         std::none_of(locals_.begin(), locals_.end(),
                      [&](const Local& local) { return local.reg == reg; });
}

// Too many registers are reported once, at the end; until then register 0
// stands in.
Register CodeBuilder::allocate(std::size_t count) {
  const auto first = next_;
  if (next_ + count >= largest) {
    too_large_ = true;
    return 0;
  }
  next_ = static_cast<Register>(next_ + count);
  code.register_count = std::max(code.register_count, next_);
  return first;
}

// A scope remembers how many locals and registers were in use, so closing it is
// a matter of going back to these numbers.
void CodeBuilder::open_scope() {
  scopes_.emplace_back(locals_.size(), next_);
}

void CodeBuilder::close_scope() {
  locals_.resize(scopes_.back().first);
  next_ = scopes_.back().second;
  scopes_.pop_back();
}

// Only the innermost block: a variable of an outer one may be hidden.
Local* CodeBuilder::in_block(std::string_view name) {
  const auto from = scopes_.empty() ? 0 : scopes_.back().first;
  for (std::size_t i = from; i < locals_.size(); ++i)
    if (locals_[i].name == name)
      return &locals_[i];
  return nullptr;
}

void CodeBuilder::check_name(std::string_view name) {
  if (const auto fault = variable_fault(name); !fault.empty())
    findings.error(position_, fault);
}

Register CodeBuilder::declare(std::string_view name, bool is_constant) {
  check_name(name);
  locals_.push_back({std::string(name), allocate(), false, is_constant});
  return locals_.back().reg;
}

Register CodeBuilder::adopt(std::string_view name, bool is_constant) {
  locals_.push_back({std::string(name), allocate(), false, is_constant});
  return locals_.back().reg;
}

// Constant, so that a <set> of _ERROR is refused.
void CodeBuilder::alias(std::string_view name, Register target) {
  locals_.push_back({std::string(name), target, false, true});
}

void CodeBuilder::declare_parameter(std::string_view name, Register target) {
  check_name(name);
  locals_.push_back({std::string(name), target, true, false});
}

// From the inside out: an inner variable hides an outer one of its name
// (language rule 5.1).
Meaning CodeBuilder::find(std::string_view name) const {
  using Kind = Meaning::Kind;
  for (auto local = locals_.rbegin(); local != locals_.rend(); ++local)
    if (local->name == name)
      return {Kind::local, &*local, local->reg};
  if (auto there = names.variables.find(name); there != names.variables.end())
    return {Kind::variable, nullptr, there->second};
  if (auto variable = system_variable(name))
    return {Kind::system, nullptr, static_cast<std::uint32_t>(*variable)};
  if (auto number = message_parameter(name))
    return {Kind::parameter, nullptr, *number};
  return {};
}

// Functions of the state or topic hide those of the session.
const FunctionName* CodeBuilder::function(std::string_view name) const {
  if (context.functions)
    if (auto own = context.functions->find(name);
        own != context.functions->end())
      return &own->second;
  const auto there = names.functions.find(name);
  return there == names.functions.end() ? nullptr : &there->second;
}

// Candidates for "did you mean", without names of the compiler itself, which
// begin with a blank. _LPARAM1 stands for all of its kind.
std::vector<std::string> CodeBuilder::visible_names() const {
  std::vector<std::string> all;
  for (const auto& local : locals_)
    if (!local.name.starts_with(' '))
      all.push_back(local.name);
  for (const auto& [name, index] : names.variables)
    all.push_back(name);
#define X(variable, text) all.emplace_back(text);
  PARLOUR_SYSTEM_VARIABLES(X)
#undef X
  all.emplace_back("_LPARAM1");
  return all;
}

std::vector<std::string> CodeBuilder::function_names() const {
  std::vector<std::string> all;
  if (context.functions)
    for (const auto& [name, function] : *context.functions)
      all.push_back(name);
  for (const auto& [name, function] : names.functions)
    all.push_back(name);
  return all;
}

// The cost of a call is its length: what runs once without loops and calls
// takes at most that many instructions.
Code CodeBuilder::finish() {
  emit(Operation::give_unknown);
  code.cost = static_cast<std::uint16_t>(
      std::min(code.instructions.size(), dearest_call));
  if (too_large_)
    findings.error(position_,
                   "this body is too long; divide it into functions");
  return std::move(code);
}

} // namespace parlour::script
