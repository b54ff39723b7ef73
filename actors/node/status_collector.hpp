// Asks actors how they are (get_status), and the actors that these name in
// turn. Who does not answer in time is told as such, with the call that it is
// in where that is known: nobody waits for it.
#pragma once

#include <functional>
#include <vector>

#include <caf/actor_system.hpp>

#include "actors/protocol/interfaces.hpp"

namespace parlour::actors {

// In the order of asking: those given, then theirs. `let_run` is called after
// each round of questions: in virtual time it runs the actors. `patience` is
// real time, for all of it together. From any thread that is no actor's.
enum class Children : bool { left_out, asked };
std::vector<ActorStatus> collect_status(caf::actor_system& system,
                                        const std::vector<ActorHandle>& roots,
                                        const std::function<void()>& let_run,
                                        Milliseconds patience,
                                        Children children = Children::asked);

} // namespace parlour::actors
