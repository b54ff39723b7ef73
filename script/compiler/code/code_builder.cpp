#include "script/compiler/code/code_builder.hpp"

#include <algorithm>
#include <charconv>

#include "runtime/base/utf8.hpp"
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

std::optional<std::uint32_t> message_parameter(std::string_view name) {
  constexpr std::string_view prefix = "_LPARAM";
  if (!name.starts_with(prefix))
    return {};
  name.remove_prefix(prefix.size());
  if (name.ends_with('_')) // as the paper prints it in one place
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

void CodeBuilder::exits_to(Label label, std::uint32_t target) {
  auto& instruction = code.instructions[label];
  const auto distance = target - static_cast<std::uint32_t>(label);
  const auto operation = static_cast<Operation>(instruction.operation);
  if (operation < Operation::jump_if_equal ||
      operation > Operation::jump_if_greater_equal_constant) {
    instruction.set_wide(distance);
    return;
  }
  too_large_ |= distance > 0x7fff; // these have 16 bits for it
  instruction.c = static_cast<std::uint16_t>(distance);
}

void CodeBuilder::back(Operation operation, std::size_t a,
                       std::uint32_t target) {
  emit_wide(operation, a, here() - target);
}

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

void CodeBuilder::open_scope() {
  scopes_.emplace_back(locals_.size(), next_);
}

void CodeBuilder::close_scope() {
  locals_.resize(scopes_.back().first);
  next_ = scopes_.back().second;
  scopes_.pop_back();
}

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

Register CodeBuilder::declare(std::string_view name, bool is_constant,
                              bool is_parameter) {
  check_name(name);
  locals_.push_back({std::string(name), allocate(), is_parameter, is_constant});
  return locals_.back().reg;
}

Register CodeBuilder::adopt(std::string_view name, bool is_constant) {
  locals_.push_back({std::string(name), allocate(), false, is_constant});
  return locals_.back().reg;
}

void CodeBuilder::alias(std::string_view name, Register target) {
  locals_.push_back({std::string(name), target, false, true});
}

void CodeBuilder::declare_parameter(std::string_view name, Register target) {
  check_name(name);
  locals_.push_back({std::string(name), target, true, false});
}

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

const FunctionName* CodeBuilder::function(std::string_view name) const {
  if (context.functions)
    if (auto own = context.functions->find(name);
        own != context.functions->end())
      return &own->second;
  const auto there = names.functions.find(name);
  return there == names.functions.end() ? nullptr : &there->second;
}

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
