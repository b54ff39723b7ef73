#include "script/program/jump_table.hpp"

#include "script/values/objects.hpp"

namespace parlour::script {

namespace {

// Multiplying by the golden ratio spreads consecutive integers.
std::uint32_t hash_of_constant(const Box& value) {
  constexpr std::uint32_t golden = 0x9e3779b9;
  return value.is_string()
             ? hash_of(*value.string())
             : (static_cast<std::uint32_t>(value.as_small()) * golden) >> 16;
}

bool same(const Box& a, const Box& b) {
  return a.same_bits(b) ||
         (a.is_string() && equal_strings(*a.string(), *b.string()));
}

} // namespace

// The place of the value, or the free place where it would be added.
std::size_t JumpTable::slot_of(const Box& value) const {
  const auto mask = entries_.size() - 1;
  auto slot = hash_of_constant(value) & mask;
  while (!entries_[slot].constant.is_unknown() &&
         !same(value, entries_[slot].constant))
    slot = (slot + 1) & mask;
  return slot;
}

void JumpTable::grow() {
  auto old = std::move(entries_);
  entries_ = std::vector<Entry>(old.size() * 2);
  for (auto& entry : old)
    if (!entry.constant.is_unknown())
      entries_[slot_of(entry.constant)] = entry;
}

void JumpTable::add(const Box& constant, std::uint32_t target) {
  of_strings_ = constant.is_string();
  if (used_ * 2 >= entries_.size())
    grow();
  auto& entry = entries_[slot_of(constant)];
  if (!entry.constant.is_unknown())
    return;
  entry = {constant, target};
  ++used_;
}

const std::uint32_t* JumpTable::find(const Box& value) const {
  if (of_strings_ ? !value.is_string() : !value.is_small())
    return nullptr;
  const auto& entry = entries_[slot_of(value)];
  return entry.constant.is_unknown() ? &otherwise_ : &entry.target;
}

} // namespace parlour::script
