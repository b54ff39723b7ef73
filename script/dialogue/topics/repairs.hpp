// Repairs: which <repair> of the program is meant (engine rule 5). Pure.
#pragma once

#include <functional>
#include <string_view>

#include "script/program/program.hpp"

namespace parlour::dialogue {

// What has happened, as far as it chooses a <repair>. no_id: it happened at no
// topic, or no slot.
struct RepairWanted {
  std::string_view act; // of the user; no_match, no_input
  script::TopicId topic = script::no_id;
  script::SlotId slot = script::no_id;
  std::uint32_t count = 0; // of no_match, no_input
};

// The most specific one: of the slot, then of the topic, then the application's
// before the platform's, then one with a condition, then the highest count that
// was reached, then the first in file order. Null where there is none.
const script::Repair*
choose_repair(const script::Program& program, const RepairWanted& wanted,
              const std::function<bool(script::CodeId condition)>& holds);

} // namespace parlour::dialogue
