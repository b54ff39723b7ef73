// `parlour say`: speaks a text without an application, to a speaker or a file.
#include <algorithm>
#include <ostream>

#include <fmt/format.h>

#include "adapters/audio/alsa/device_trial.hpp"
#include "adapters/audio/sound_file.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/cli/plugins/given_plugin.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/console/line_reader.hpp"
#include "tools/parlour/speech/synthesis.hpp"

namespace parlour::tools {

namespace {

using adapters::Sample;
using Samples = std::vector<Sample>;

Expected<PluginFactory> find_voice(const Places& places,
                                   const std::string& component) {
  auto factory = given_plugin(places, component);
  if (!factory)
    return factory;
  const auto& roles = factory->description.roles;
  if (std::ranges::find(roles, "TTS") == roles.end())
    return fail(ErrorKind::settings,
                component + " is no voice; parlour devices lists those that "
                            "this build has");
  return factory;
}

Expected<Options> options_of(const SayOptions& say,
                             const PluginDescription& plugin) {
  auto given = say.options;
  if (!say.voice.empty())
    given.push_back("voice=" + say.voice);
  return given_options(given, plugin);
}

Expected<void> write(const std::filesystem::path& path,
                     const Samples& samples) {
  auto writer = adapters::SoundFileWriter::create(path, {});
  if (!writer)
    return tl::make_unexpected(writer.error());
  return writer->write(samples);
}

int failed(const Console& console, const Error& error, int status) {
  say_error(console, to_string(error));
  return status;
}

int hand_over(const Places& places, const SayOptions& options,
              const Samples& samples, const Console& console) {
  if (options.file.empty()) {
    const auto played = adapters::play_sound(options.speaker, samples);
    return played ? exit_code::success
                  : failed(console, played.error(), exit_code::wrong);
  }
  const auto written = write(places.working / options.file, samples);
  if (!written)
    return failed(console, written.error(), exit_code::wrong);
  console.out << fmt::format("{}: {:.2f} s\n", options.file,
                             static_cast<double>(samples.size()) /
                                 adapters::speech_rate);
  return status_of_printing(console, exit_code::success);
}

} // namespace

int say_command(const Places& places, const SayOptions& options,
                const Console& console) {
  if (is_blank(options.text)) {
    say_error(console, "there is nothing to say");
    return exit_code::usage;
  }
  const auto factory = find_voice(places, options.component);
  if (!factory)
    return failed(console, factory.error(), exit_code::usage);
  const auto chosen = options_of(options, factory->description);
  if (!chosen)
    return failed(console, chosen.error(), exit_code::usage);
  const auto samples = synthesize(*factory, *chosen, options.text);
  if (!samples)
    return failed(console, samples.error(), exit_code::wrong);
  return hand_over(places, options, *samples, console);
}

} // namespace parlour::tools
