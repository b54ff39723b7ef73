// How scripts read a frame: `this.X`, and `this.rows`, `this.asked`,
// `this.relaxed` of an enquiry (engine rule 5).
#pragma once

#include "script/dialogue/frame/topic_frame.hpp"

namespace parlour::dialogue {

Value read_slot(const TopicFrame& frame, SlotId slot);

} // namespace parlour::dialogue
