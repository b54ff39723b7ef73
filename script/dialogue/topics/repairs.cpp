#include "script/dialogue/topics/repairs.hpp"

#include <tuple>

namespace parlour::dialogue {

namespace {

using script::no_code;
using script::no_id;
using script::Repair;

// A count of none is for what is not counted: it holds while nothing is asked,
// and never for the third miss.
bool reached(const Repair& repair, const RepairWanted& wanted) {
  return repair.count == 0 ? wanted.count == 0 : repair.count <= wanted.count;
}

bool fits(const Repair& repair, const RepairWanted& wanted) {
  return repair.act == wanted.act && reached(repair, wanted) &&
         (repair.topic == no_id || repair.topic == wanted.topic) &&
         (repair.slot == no_id || repair.slot == wanted.slot);
}

// Tuples compare from left to right, which is the order of engine rule 5.10:
// the slot's, the topic's, the application's, one with a condition, the highest
// count.
auto rank(const Repair& repair) {
  return std::tuple(repair.slot != no_id, repair.topic != no_id,
                    !repair.of_platform, repair.condition != no_code,
                    repair.count);
}

} // namespace

const Repair*
choose_repair(const script::Program& program, const RepairWanted& wanted,
              const std::function<bool(script::CodeId condition)>& holds) {
  const Repair* best = nullptr;
  for (const auto& repair : program.repairs)
    if (fits(repair, wanted) && (!best || rank(repair) > rank(*best)) &&
        (repair.condition == no_code || holds(repair.condition)))
      best = &repair;
  return best;
}

} // namespace parlour::dialogue
