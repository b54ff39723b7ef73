#include "script/dialogue/frame/frame_view.hpp"

namespace parlour::dialogue {

Value read_slot(const TopicFrame& frame, SlotId slot) {
  switch (slot) {
  case script::slot_rows:
    return frame.rows;
  case script::slot_asked:
    return frame.asked;
  case script::slot_relaxed:
    return List(frame.relaxed.begin(), frame.relaxed.end());
  case script::slot_last:
    return frame.last;
  default:
    return slot < frame.slots.size() ? frame.slots[slot].value : Value();
  }
}

} // namespace parlour::dialogue
