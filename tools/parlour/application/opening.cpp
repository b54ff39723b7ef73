// See opening.hpp.
#include "tools/parlour/application/opening.hpp"

#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/console/finding_text.hpp"

namespace parlour::tools {

namespace {

// `prepare` says what is compiled besides the application's own files.
template <class Prepare>
std::variant<Application, int>
open(const Places& places, const std::string& app, const Console& console,
     Scrutiny scrutiny, const Prepare& prepare) {
  const auto folder = find_application(places, app);
  if (!folder) {
    say_error(console, folder.error().message);
    return exit_code::usage;
  }
  const auto platform = find_platform(places, *folder);
  const auto plugins =
      std::make_shared<Catalogue>(plugin_folders(places, *folder));
  const Expected<VoiceSources> added = prepare(*folder, platform, *plugins);
  if (!added) {
    say_error(console, to_string(added.error()));
    return exit_code::wrong;
  }
  auto application =
      load_application(*folder, platform, scrutiny, plugins, added->sources());
  if (!application.has_errors() && application.program)
    return application;
  print_lines(console.err, application.findings, places);
  say_error(console,
            app + " is not started: " + to_string(count(application.findings)));
  return exit_code::wrong;
}

} // namespace

std::variant<Application, int> open_application(const Places& places,
                                                const std::string& app,
                                                const Console& console,
                                                Scrutiny scrutiny) {
  return open(places, app, console, scrutiny,
              [](auto&...) { return VoiceSources(); });
}

std::variant<Application, int> open_application(const Places& places,
                                                const std::string& app,
                                                const Console& console,
                                                const VoiceWishes& voice) {
  auto opened =
      open(places, app, console, Scrutiny::compile,
           [&](const auto& folder, const auto& platform, auto& plugins) {
             return add_voice(folder, platform, plugins, voice);
           });
  if (auto* const application = std::get_if<Application>(&opened))
    use_files(application->composition, voice, places.working);
  return opened;
}

} // namespace parlour::tools
