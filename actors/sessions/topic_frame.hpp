// A topic's frame in one session: the only writer of its slots. One request
// for each event, answered with the new immutable frame; the rules are a pure
// function (engine rule 5, "The frame's actor").
#pragma once

#include "actors/protocol/interfaces.hpp"
#include "script/dialogue/frame/frame.hpp"

namespace parlour::actors {

struct topic_frame_state {
  static inline const char* name = "topic_frame";
  dialogue::FramePointer frame; // null before the first request
};

topic_frame_actor::behavior_type
topic_frame(topic_frame_actor::stateful_pointer<topic_frame_state> self,
            std::shared_ptr<const script::Program> program,
            script::TopicId topic);

} // namespace parlour::actors
