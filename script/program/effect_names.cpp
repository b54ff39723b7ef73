#include "script/program/effect_names.hpp"

namespace parlour::script {

namespace {

enum class Leads : std::uint8_t { on, elsewhere };

// A row of the table.
struct EffectRow {
  const char* element;
  bool waits;
  Deed deed;
  Leads leads;
};

const EffectRow& row_of(EffectKind kind) {
  static constexpr EffectRow rows[] = {
#define EFFECT(name, element, part, waits, deed, leads, operands, sentence)    \
  {element, waits, Deed::deed, Leads::leads},
#include "script/program/effects.def"
#undef EFFECT
  };
  return rows[static_cast<std::size_t>(kind)];
}

} // namespace

std::string element_of(EffectKind kind) {
  return row_of(kind).element;
}

bool waits(EffectKind kind) {
  return row_of(kind).waits;
}

Deed deed_of(EffectKind kind) {
  return row_of(kind).deed;
}

bool leads_elsewhere(EffectKind kind) {
  return row_of(kind).leads == Leads::elsewhere;
}

} // namespace parlour::script
