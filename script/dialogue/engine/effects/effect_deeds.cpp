#include "script/dialogue/engine/effects/effect_deeds.hpp"

#include "runtime/text/sql_check.hpp"
#include "script/program/effect_names.hpp"

namespace parlour::dialogue {

bool is_deed(const script::Effect& effect) {
  switch (script::deed_of(effect.kind)) {
  case script::Deed::no:
    return false;
  case script::Deed::by_statement:
    return !only_looks(effect.text(0));
  case script::Deed::yes:
    break;
  }
  return true;
}

} // namespace parlour::dialogue
