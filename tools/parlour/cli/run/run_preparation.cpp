#include "tools/parlour/cli/run/run_preparation.hpp"

#include <fmt/format.h>

#include "adapters/database/sqlite/sqlite_origin.hpp"
#include "tools/parlour/application/opening.hpp"
#include "tools/parlour/application/plugins/shipped_plugin.hpp"
#include "tools/parlour/application/seat_check.hpp"

namespace parlour::tools {

std::variant<Application, int> open_for_run(const Places& places,
                                            const RunOptions& options,
                                            const std::string& app,
                                            const Console& console) {
  if (!options.voice)
    return open_application(places, app, console);
  return open_application(places, app, console,
                          {options.microphone, options.speaker,
                           options.push_to_talk, options.talk_key,
                           options.wake});
}

Expected<void> put_databases_aside(const Application& application,
                                   const std::filesystem::path& data) {
  for (const auto& component : application.composition.components) {
    const auto kept =
        shipped_plugin(component.factory.description.name).kept_file;
    const auto file =
        kept ? kept(component.options, application.folder, data.string())
             : std::filesystem::path();
    if (file.empty())
      continue; // what is wrong is reported when the component starts
    if (auto done = adapters::put_aside(file); !done)
      return done;
  }
  return {};
}

bool can_talk(const Application& application, const RunOptions& options,
              const std::filesystem::path& data, const Console& console) {
  const auto errors =
      seat_errors(application.composition, application.folder, data);
  for (const auto& error : errors)
    say_error(console, error.message);
  if (!errors.empty())
    say_error(console,
              fmt::format("{} is not started: it cannot talk by voice. "
                          "parlour devices lists what there is; sound files "
                          "can take the place of devices: --microphone "
                          "FILE.wav --speaker FILE.wav (docs/speech.md)",
                          options.app));
  return errors.empty();
}

} // namespace parlour::tools
