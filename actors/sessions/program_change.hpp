// ProgramChange: the scripts that the sessions of a node go over to (engine
// rule 7.13), made once for all of them.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>

#include "actors/protocol/reload.hpp"
#include "actors/sessions/session_parts.hpp"
#include "script/dialogue/saved/renames.hpp"

namespace parlour::actors {

// Sessions use it on their own threads.
class ProgramChange {
public:
  // `mode` is not new_only.
  ProgramChange(std::shared_ptr<const SessionParts> parts, ReloadMode mode)
      : parts_(std::move(parts)), mode_(mode) {}

  // What a session is made with from then on.
  const std::shared_ptr<const SessionParts>& parts() const {
    return parts_;
  }
  ReloadMode mode() const {
    return mode_;
  }
  // From the program that a session has: not the same for all, where an earlier
  // change has not reached some. Made for the first session that asks.
  std::shared_ptr<const dialogue::Renames>
  renames_from(const std::shared_ptr<const script::Program>& program) const;

private:
  const std::shared_ptr<const SessionParts> parts_;
  const ReloadMode mode_;
  mutable std::mutex mutex_;
  // Each keeps its program alive.
  mutable std::map<const script::Program*,
                   std::shared_ptr<const dialogue::Renames>>
      renames_;
};

// What the sessions say when they are told of a change. Whoever asked is told
// when the last of them has, by `done`.
struct ReloadTally {
  std::function<void(program_reloaded)> done;
  std::size_t left = 0; // sessions that have not answered
  ReloadedSessions told = {};

  // One that has ended is counted nowhere, as one that does not answer.
  void take(const program_changed& what) {
    if (what.has_ended)
      return;
    ++(what.later ? told.later : told.gone_over);
    for (const auto& one : what.lost)
      ++told.lost[one];
  }
  void one_less() {
    if (--left == 0)
      done({std::move(told)});
  }
};

} // namespace parlour::actors
