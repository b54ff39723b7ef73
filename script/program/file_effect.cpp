#include "script/program/file_effect.hpp"

namespace parlour::script {

namespace {

std::optional<FileAction> action_of(EffectKind kind) {
  switch (kind) {
  case EffectKind::read_file:
    return FileAction::read;
  case EffectKind::write_file:
    return FileAction::write;
  case EffectKind::append_file:
    return FileAction::append;
  case EffectKind::delete_file:
    return FileAction::remove;
  case EffectKind::list_files:
    return FileAction::list;
  default:
    return {};
  }
}

} // namespace

std::optional<FileRequest> file_request(const Effect& effect,
                                        std::size_t max_bytes) {
  const auto action = action_of(effect.kind);
  if (!action)
    return {};
  return FileRequest{*action, effect.text(0), effect.text(1), max_bytes};
}

} // namespace parlour::script
