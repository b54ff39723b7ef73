// Asks the running nodes of this user how they are.
#pragma once

#include <filesystem>
#include <vector>

#include "tools/parlour/status/status_report.hpp"

namespace parlour::tools {

// Of each whose socket is in the folder, in the order of their processes. A
// socket that nobody listens at is removed: its process was killed. One that
// does not answer in time, or not so that it is understood, is an error in its
// place.
std::vector<Expected<StatusReport>>
ask_status(const std::filesystem::path& folder);

} // namespace parlour::tools
