#include "script/program/effect_names.hpp"

namespace parlour::script {

std::string element_of(EffectKind kind) {
  switch (kind) {
  case EffectKind::fire_frames:
  case EffectKind::fire_event:
    return "fire";
  case EffectKind::register_handler:
  case EffectKind::register_topic:
    return "register";
  case EffectKind::unregister_handler:
  case EffectKind::unregister_topic:
    return "unregister";
  case EffectKind::reset_topic:
    return "reset";
  case EffectKind::cancel_topic:
    return "cancel";
  case EffectKind::open_socket:
    return "socket";
  case EffectKind::begin:
  case EffectKind::commit:
  case EffectKind::rollback:
    return "transaction";
  default:
    break;
  }
  constexpr const char* names[] = {
#define EFFECT(name, waits, operands, sentence) #name,
#include "script/program/effects.def"
#undef EFFECT
  };
  std::string name = names[static_cast<std::size_t>(kind)];
  std::erase(name, '_'); // read_file, <readfile>
  return name;
}

bool waits(EffectKind kind) {
  constexpr bool all[] = {
#define EFFECT(name, waits, operands, sentence) waits,
#include "script/program/effects.def"
#undef EFFECT
  };
  return all[static_cast<std::size_t>(kind)];
}

bool leads_elsewhere(EffectKind kind) {
  using enum EffectKind;
  return kind == transit || kind == push || kind == pop || kind == restart;
}

} // namespace parlour::script
