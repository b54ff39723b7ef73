// Everything that a stored state refers to by number goes into the hash: if an
// index meant something else, a restored session would go wrong silently.

#include "script/vm/program_identity.hpp"

#include <bit>

#include "runtime/base/text/word_hash.hpp"
#include "script/expression/builtins.hpp"
#include "script/program/host.hpp"
#include "script/program/instruction.hpp"
#include "script/values/objects.hpp"

namespace parlour::script {

namespace {

// The names behind the numbers in instructions, in their order.
constexpr const char* vocabulary[] = {
#define INSTRUCTION(name, sentence) #name,
#include "script/program/instructions.def"
#undef INSTRUCTION
#define EFFECT(name, element, part, waits, deed, leads, operands, sentence)    \
#name " " operands,
#include "script/program/effects.def"
#undef EFFECT
#define X(name, text) text,
    PARLOUR_SYSTEM_VARIABLES(X)
#undef X
};

// A type of this namespace, so that the functions below find each other.
struct Hash : WordHash {};

template <class T>
void add_names_of(Hash& hash, const std::vector<T>& all) {
  hash.add(std::uint64_t{all.size()});
  for (const auto& one : all)
    hash.add(one.name);
}

// An instruction has eight bytes, which are hashed as one number.
void add(Hash& hash, const Instruction& instruction) {
  hash.add(std::uint64_t{instruction.operation} |
           std::uint64_t{instruction.flag} << 8 |
           std::uint64_t{instruction.a} << 16 |
           std::uint64_t{instruction.b} << 32 |
           std::uint64_t{instruction.c} << 48);
}

void add(Hash& hash, const Box& constant) {
  if (constant.is_string())
    return hash.add(constant.text());
  if (constant.is_integer())
    return hash.add(static_cast<std::uint64_t>(constant.as_integer()));
  if (constant.is_number())
    return hash.add(std::bit_cast<std::uint64_t>(constant.as_number()));
  hash.add(constant.is_missing()   ? "missing"
           : constant.is_unknown() ? "unknown"
           : constant.is_true()    ? "true"
                                   : "false");
}

// Positions count because error messages of a restored session show them.
void add(Hash& hash, const Position& position) {
  hash.add(std::uint64_t{position.file} << 32 | position.line);
  hash.add(position.column);
}

void add(Hash& hash, const CatchRange& range) {
  hash.add(std::uint64_t{range.from} << 32 | range.to);
  hash.add(std::uint64_t{range.target} << 32 |
           std::uint64_t{range.error_register} << 1 | range.always);
}

void add(Hash& hash, const EffectShape& shape) {
  hash.add(std::uint64_t{shape.kind} << 32 | shape.body);
  hash.add(std::uint64_t{shape.target} << 32 |
           std::uint64_t{shape.operands} << 16 | shape.captured);
}

template <class T>
void add(Hash& hash, const std::vector<T>& all) {
  hash.add(all.size());
  for (const auto& one : all)
    add(hash, one);
}

void add(Hash& hash, const JumpTable::Entry& entry) {
  add(hash, entry.constant);
  hash.add(entry.target);
}

void add(Hash& hash, const JumpTable& table) {
  add(hash, table.entries());
  hash.add(table.otherwise());
}

// Everything that influences how a frame of this code continues.
void add(Hash& hash, const Code& code) {
  hash.add(code.name);
  hash.add(std::uint64_t{code.parameter_count} |
           std::uint64_t{code.required_count} << 16 |
           std::uint64_t{code.register_count} << 32 |
           std::uint64_t{code.cost} << 48);
  hash.add(code.body);
  add(hash, code.instructions);
  add(hash, code.positions);
  add(hash, code.constants);
  add(hash, code.catches);
  add(hash, code.effects);
  add(hash, code.tables);
}

// Names are referred to by their indices, so their order matters.
void add_names(Hash& hash, const Program& program) {
  add_names_of(hash, program.variables);
  add_names_of(hash, program.handlers);
  add_names_of(hash, program.states);
  add_names_of(hash, program.topics);
  for (const auto& topic : program.topics)
    add_names_of(hash, topic.slots);
  for (const auto& [name, code] : program.functions) {
    hash.add(name);
    hash.add(code);
  }
}

} // namespace

std::uint64_t identity_of(const Program& program) {
  // Two threads may compute it at once; they store the same number.
  auto& kept = program.pool->identity;
  if (const auto known = kept.load(std::memory_order_relaxed))
    return known;
  Hash hash;
  for (const auto* word : vocabulary)
    hash.add(word);
  for (const auto& name : builtin_names())
    hash.add(name);
  add(hash, program.code);
  add_names(hash, program);
  const auto identity = hash.value() | 1; // 0 means not computed yet
  kept.store(identity, std::memory_order_relaxed);
  return identity;
}

} // namespace parlour::script
