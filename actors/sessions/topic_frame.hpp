// Computes the filling events of one topic in one session. Each request brings
// the topic's frame, which the session owns, and is answered with the next one;
// the actor keeps neither. The rules are a pure function (engine rule 5.12).
#pragma once

#include "actors/support/actor_trace.hpp"
#include "script/dialogue/frame/topic_frame.hpp"

namespace parlour::actors {

// Spawned by the session's port when the topic is first touched; ends with it.
struct topic_frame_state {
  static inline const char* name = "topic_frame";
};

topic_frame_actor::behavior_type
topic_frame(topic_frame_actor::stateful_pointer<topic_frame_state> self,
            std::shared_ptr<const script::Program> program,
            script::TopicId topic, ActorTrace trace);

} // namespace parlour::actors
