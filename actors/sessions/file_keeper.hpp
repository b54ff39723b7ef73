// The keeper of the data folder's files: carries out what sessions' scripts
// want of them, one after the other. Blocks while the disk does, hence on a
// thread of its own. One for all and not one for each: their number would be
// that of the waiting scripts, each with a thread.
#pragma once

#include "actors/support/actor_trace.hpp"

namespace parlour::actors {

// Nothing of an order is kept: it is carried out before the next is taken.
struct file_keeper_state {
  static inline const char* name = "file_keeper";
  std::string last_error;
};

// `files` may be empty: this run has none.
file_keeper_actor::behavior_type
file_keeper(file_keeper_actor::stateful_pointer<file_keeper_state> self,
            FileAccess files, ActorTrace trace);

} // namespace parlour::actors
