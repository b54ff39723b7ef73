// Sessions at rest (engine rule 7.14): the messages that lead there.
#pragma once

#include "runtime/base/clock.hpp"

namespace parlour::actors {

// To a session. Where nothing has come for so long, and nothing goes on: be
// written down, to take less memory, until something comes.
struct rest_if_idle {
  Milliseconds idle;
};
// Tell some more sessions to rest if they are idle; the session manager sends
// this to itself.
struct look_for_idle {};

} // namespace parlour::actors
