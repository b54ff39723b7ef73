// seat_errors: whether the devices of a voice seat can be used now. A seat's
// components start when somebody talks there, and what fails then is tried
// again for ever, as a kiosk needs it. Somebody who starts a run is told
// instead.
#pragma once

#include <filesystem>
#include <vector>

#include "runtime/base/error.hpp"
#include "tools/parlour/application/application.hpp"

namespace parlour::tools {

// Starts each component that hears or speaks at a seat once, alone, and stops
// it. The errors name the component; empty if all could start.
std::vector<Error> seat_errors(const Composition& composition,
                               const std::filesystem::path& application,
                               const std::filesystem::path& data);

// The component by which a key of the terminal begins and ends turns: it leaves
// nothing to type there. Null: there is none.
const ChosenComponent* key_of_terminal(const Composition& composition);

} // namespace parlour::tools
