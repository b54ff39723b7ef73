#include "actors/sessions/file_keeper.hpp"

#include <utility>

#include <caf/typed_event_based_actor.hpp>

#include "actors/support/actor_trace.hpp"
#include "actors/support/exception_text.hpp"
#include "actors/support/tell_status.hpp"

namespace parlour::actors {

namespace {

// Which files a script may touch, the adapter decides (engine rule 7.4).
Expected<Value> carry_out(const FileAccess& files, const FileRequest& request) {
  if (!files)
    return fail(ErrorKind::refused, "this run has no data folder");
  Expected<Value> outcome;
  if (auto reason = catch_to_string([&] { outcome = files(request); }))
    return fail(ErrorKind::file, *reason);
  return outcome;
}

} // namespace

file_keeper_actor::behavior_type
file_keeper(file_keeper_actor::stateful_pointer<file_keeper_state> self,
            FileAccess files, ActorTrace trace) {
  return traced<file_keeper_actor::behavior_type>(
      std::move(trace),
      [=, files = std::move(files)](const file_order& what) {
        auto outcome = carry_out(files, what.request);
        if (!outcome)
          self->state.last_error = outcome.error().message;
        self->send(what.session,
                   file_outcome{what.id, std::move(outcome), what.work});
      },
      [=](const get_status& what) {
        return tell_status(self, what, {{}, "waits", self->state.last_error});
      });
}

} // namespace parlour::actors
