// What `parlour run` does before its node starts.
#pragma once

#include <filesystem>
#include <string>
#include <variant>

#include "tools/parlour/application/application.hpp"
#include "tools/parlour/cli/commands.hpp"

namespace parlour::tools {

// The application of that name, or in that folder; with a voice, where the run
// has one. Else it printed what is wrong, and returns the exit status.
std::variant<Application, int> open_for_run(const Places& places,
                                            const RunOptions& options,
                                            const std::string& app,
                                            const Console& console);

// --fresh: renames the databases of the SQLite components, so that they are
// made anew from schema and seed. A server's database is never dropped.
Expected<void> put_databases_aside(const Application& application,
                                   const std::filesystem::path& data);

// What hears and speaks must be there when a run begins; later it may go and
// come back. False: the errors were printed.
bool can_talk(const Application& application, const RunOptions& options,
              const std::filesystem::path& data, const Console& console);

} // namespace parlour::tools
