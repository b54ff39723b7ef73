// How scripts read a frame: `this.X`, and `this.rows`, `this.asked`,
// `this.relaxed` of an enquiry (engine rule 5).
#pragma once

#include "script/dialogue/frame/topic_frame.hpp"

namespace parlour::dialogue {

// `slot` may be one of the program's numbers for rows, asked, relaxed and last.
// Unknown where the slot has no value, or the topic no such slot.
Value read_slot(const TopicFrame& frame, SlotId slot);

} // namespace parlour::dialogue
