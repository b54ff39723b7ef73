// The list of built-in plug-ins, and the search for plug-ins by name. No other
// file names every built-in plug-in.
#include "tools/parlour/application/plugins/catalogue.hpp"

#include <algorithm>

#include "adapters/asr/moonshine_asr.hpp"
#include "adapters/asr/sphinx/sphinx_asr.hpp"
#include "adapters/asr/sphinx/sphinx_keywords.hpp"
#include "adapters/audio/alsa/alsa_microphone.hpp"
#include "adapters/audio/alsa/alsa_speaker.hpp"
#include "adapters/audio/file_microphone.hpp"
#include "adapters/audio/file_speaker.hpp"
#include "adapters/database/mariadb/mariadb_database.hpp"
#include "adapters/database/sqlite/sqlite_database.hpp"
#include "adapters/endpointer/key_endpointer.hpp"
#include "adapters/endpointer/speech_endpointer.hpp"
#include "adapters/enhancement/enhancement.hpp"
#include "adapters/http/http_service.hpp"
#include "adapters/metrics/turn_metrics.hpp"
#include "adapters/mqtt/mqtt_devices.hpp"
#include "adapters/nlg/phrase_nlg.hpp"
#include "adapters/nlu/keywords/keyword_nlu.hpp"
#include "adapters/nlu/understand/grammar_nlu.hpp"
#include "adapters/push_to_talk/key_push_to_talk.hpp"
#include "adapters/standins/log_devices.hpp"
#include "adapters/standins/log_reports.hpp"
#include "adapters/standins/log_robot.hpp"
#include "adapters/standins/log_sms.hpp"
#include "adapters/standins/log_taxi.hpp"
#include "adapters/standins/log_telephone.hpp"
#include "adapters/tts/espeak_tts.hpp"
#include "adapters/tts/flite_tts.hpp"
#include "adapters/tts/text_file_tts.hpp"
#include "adapters/vad/adaptive_vad.hpp"
#include "adapters/vad/silero_vad.hpp"
#include "adapters/vad/webrtc_vad.hpp"
#include "adapters/wyoming/wyoming_asr.hpp"
#include "adapters/wyoming/wyoming_tts.hpp"
#include "adapters/wyoming/wyoming_wake.hpp"
#include "script/source/findings.hpp"
#include "tools/parlour/console/places.hpp"

namespace parlour::tools {

namespace {

const PluginFactory* find_in(const std::vector<PluginFactory>& plugins,
                             std::string_view name) {
  const auto found = std::ranges::find_if(plugins, [&](const auto& plugin) {
    return plugin.description.name == name;
  });
  return found == plugins.end() ? nullptr : &*found;
}

} // namespace

std::vector<std::filesystem::path> moonshine_programs() {
  std::vector<std::filesystem::path> programs;
  for (const auto& share : process_places().shares)
    for (const auto* const agents : {"agents", "../tools/agents"})
      programs.push_back(share / agents / "moonshine/moonshine.mjs");
  return programs;
}

// The order is that of `parlour plugin list`. It does not matter for an
// application: its settings choose plug-ins by name.
const std::vector<PluginFactory>& built_in_plugins() {
  static const std::vector<PluginFactory> plugins = {
      adapters::grammar_nlu_factory(),
      adapters::phrase_nlg_factory(),
      adapters::sqlite_database_factory(),
      adapters::mysql_database_factory(),
      adapters::log_telephone_factory(),
      adapters::log_taxi_factory(),
      adapters::log_sms_factory(),
      adapters::log_weather_factory(),
      adapters::log_traffic_factory(),
      adapters::log_robot_factory(),
      adapters::log_devices_factory(),
      adapters::keyword_nlu_factory(),
      adapters::speech_endpointer_factory(),
      adapters::turn_metrics_factory(),
      adapters::key_endpointer_factory(),
      adapters::key_push_to_talk_factory(),
      adapters::text_file_tts_factory(),
      adapters::espeak_tts_factory(),
      adapters::alsa_microphone_factory(),
      adapters::alsa_speaker_factory(),
      adapters::flite_tts_factory(),
      adapters::wyoming_asr_factory(),
      adapters::wyoming_tts_factory(),
      adapters::wyoming_wake_factory(),
      adapters::file_microphone_factory(),
      adapters::file_speaker_factory(),
      adapters::sphinx_asr_factory(),
      adapters::sphinx_keywords_factory(),
      adapters::adaptive_vad_factory(),
      adapters::webrtc_vad_factory(),
      adapters::silero_vad_factory(moonshine_programs()),
      adapters::webrtc_enhancement_factory(),
      adapters::moonshine_asr_factory(moonshine_programs()),
      adapters::http::http_service_factory(),
      adapters::mqtt_devices_factory(),
  };
  return plugins;
}

const PluginFactory* find_plugin(std::string_view name) {
  return find_in(built_in_plugins(), name);
}

Catalogue::Catalogue(const std::vector<std::filesystem::path>& folders,
                     const std::vector<PluginFactory>& built_in)
    : built_in_(built_in), folders_(folders.begin(), folders.end()) {}

// The program's own plug-ins win over files of the same name.
Expected<PluginFactory> Catalogue::find(const std::string& name) {
  if (const auto* own = built_in(name))
    return *own;
  for (auto& folder : folders_)
    if (folder.has(name))
      return folder.find(name);
  return tl::make_unexpected(nowhere(name));
}

// Files that cannot be loaded are left out; find() reports why.
std::vector<PluginDescription> Catalogue::all() {
  std::vector<PluginDescription> all;
  for (const auto& name : names())
    if (const auto found = find(name))
      all.push_back(found->description);
  return all;
}

bool Catalogue::has(const std::string& name) const {
  return built_in(name) || folder_of(name);
}

std::vector<std::string> Catalogue::names() const {
  std::vector<std::string> names;
  for (const auto& plugin : built_in_)
    // Those of the program keep their order; files are sorted behind them.
    names.push_back(plugin.description.name);
  const auto own = names.size();
  for (const auto& folder : folders_)
    for (auto& name : folder.names())
      if (std::ranges::find(names, name) == names.end())
        names.push_back(std::move(name));
  std::sort(names.begin() + static_cast<std::ptrdiff_t>(own), names.end());
  return names;
}

std::filesystem::path Catalogue::file_of(const std::string& name) const {
  const auto* folder = built_in(name) ? nullptr : folder_of(name);
  return folder ? folder->file_of(name) : std::filesystem::path();
}

const PluginFactory* Catalogue::built_in(const std::string& name) const {
  return find_in(built_in_, name);
}

const adapters::PluginFolder*
Catalogue::folder_of(const std::string& name) const {
  for (const auto& folder : folders_)
    if (folder.has(name))
      return &folder;
  return nullptr;
}

// With a suggestion, the folders would only distract.
Error Catalogue::nowhere(const std::string& name) const {
  auto text = "there is no plug-in '" + name + "'";
  const auto hint = script::did_you_mean(name, names());
  text += hint;
  if (hint.empty())
    for (const auto& folder : folders_)
      text += (&folder == &folders_.front() ? ", and no " + name + ".so in "
                                            : ", ") +
              folder.path().string();
  return {ErrorKind::settings, std::move(text), {}};
}

} // namespace parlour::tools
