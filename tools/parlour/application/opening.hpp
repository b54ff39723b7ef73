// How every command that needs an application gets it, or says what is wrong.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "tools/parlour/application/application.hpp"
#include "tools/parlour/console/console.hpp"

namespace parlour::tools {

// Found and without errors; else the exit status, findings and errors being
// printed to `err`.
std::variant<Application, int> open_application(const Places& places,
                                                const std::string& app,
                                                const Console& console,
                                                Scrutiny = Scrutiny::compile);

} // namespace parlour::tools
