#include "actors/sessions/file_keeper.hpp"

#include <utility>

#include <caf/typed_event_based_actor.hpp>

#include "actors/support/thrown.hpp"

namespace parlour::actors {

namespace {

Expected<Value> carry_out(const FileAccess& files, const FileRequest& request) {
  if (!files)
    return fail(ErrorKind::refused, "this run has no data folder");
  Expected<Value> outcome;
  if (auto reason = thrown_by([&] { outcome = files(request); }))
    return fail(ErrorKind::file, *reason);
  return outcome;
}

} // namespace

file_keeper_actor::behavior_type
file_keeper(file_keeper_actor::stateful_pointer<file_keeper_state> self,
            FileAccess files) {
  return {
      [=, files = std::move(files)](const file_order& what) {
        self->send(
            what.session,
            file_outcome{what.id, carry_out(files, what.request), what.work});
      },
  };
}

} // namespace parlour::actors
