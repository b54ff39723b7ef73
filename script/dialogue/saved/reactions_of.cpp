#include "script/dialogue/saved/reactions_of.hpp"

namespace parlour::dialogue {

std::vector<const script::Reaction*>
reactions_of(const script::Program& program) {
  std::vector<const script::Reaction*> all;
  const auto add = [&](const std::vector<script::Reaction>& reactions) {
    for (const auto& reaction : reactions)
      all.push_back(&reaction);
  };
  for (const auto& handler : program.handlers)
    add(handler.reactions);
  for (const auto& state : program.states)
    for (const auto* reactions :
         {&state.messages, &state.online, &state.offline})
      add(*reactions);
  return all;
}

} // namespace parlour::dialogue
