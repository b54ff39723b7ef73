#include "actors/sessions/program_change.hpp"

namespace parlour::actors {

std::shared_ptr<const dialogue::Renames> ProgramChange::renames_from(
    const std::shared_ptr<const script::Program>& program) const {
  const std::lock_guard lock(mutex_);
  auto& renames = renames_[program.get()];
  if (!renames)
    renames =
        std::make_shared<const dialogue::Renames>(program, parts_->program);
  return renames;
}

} // namespace parlour::actors
