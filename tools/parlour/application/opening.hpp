// open_application: how each command gets the application that it names.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "tools/parlour/application/application.hpp"
#include "tools/parlour/application/voice.hpp"
#include "tools/parlour/console/console.hpp"

namespace parlour::tools {

// Finds and loads the application. If it does not exist or has errors, prints
// them to `console.err` and returns the exit status instead:
//
//   auto opened = open_application(places, app, console);
//   if (const auto* status = std::get_if<int>(&opened))
//     return *status;
//   const auto& application = std::get<Application>(opened);
std::variant<Application, int> open_application(const Places& places,
                                                const std::string& app,
                                                const Console& console,
                                                Scrutiny = Scrutiny::compile);
// The same for an application that also gets a voice.
std::variant<Application, int> open_application(const Places& places,
                                                const std::string& app,
                                                const Console& console,
                                                const VoiceWishes& voice);

} // namespace parlour::tools
