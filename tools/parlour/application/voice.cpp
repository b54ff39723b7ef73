#include "tools/parlour/application/voice.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "tools/parlour/application/plugins/shipped_plugin.hpp"

namespace parlour::tools {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view microphone_role = "Microphone";
constexpr std::string_view speaker_role = "Speaker";
constexpr std::string_view recogniser_role = "ASR";
constexpr std::string_view metrics_role = "Metrics";
constexpr std::string_view enhancement_role = "Enhancement";
constexpr std::string_view endpointer_role = "Endpointer";
constexpr std::string_view key_role = "PushToTalk";
constexpr std::string_view spotter_role = "KeywordSpotter";
// How long a seat that is woken by a word stays awake in silence.
constexpr const char* sleeps_after = "10s";

// One link of the chain: who may fill the role, the best first.
struct Link {
  std::string_view role;
  std::vector<std::string> plugins;
  // Each seat has its own; otherwise one serves all.
  bool per_seat = true;
  bool required = true;
};

const std::vector<Link>& chain() {
  static const std::vector<Link> links = {
      {microphone_role, {"AlsaMicrophone"}},
      {enhancement_role, {"WebRtcEnhancement"}, true, false},
      {"VAD", {"AdaptiveVAD"}},
      {spotter_role, {"SphinxKeywords"}, false},
      {endpointer_role, {"SpeechEndpointer"}},
      {recogniser_role, {"MoonshineASR", "SphinxASR"}, false},
      {"TTS", {"EspeakTTS", "FliteTTS"}, false},
      {speaker_role, {"AlsaSpeaker"}},
      {metrics_role, {"TurnMetrics"}, false, false},
      // Only if the command line says so.
      {key_role, {}, true, false}};
  return links;
}

bool is_file_of_sound(const std::string& name) {
  const auto extension = fs::path(name).extension();
  return extension == ".wav" || extension == ".flac";
}

ComponentSettings component(const std::string& plugin, bool per_seat) {
  ComponentSettings made{plugin, plugin, {}, {}};
  if (per_seat)
    made.policy.scope.kind = Scope::Kind::seat;
  return made;
}

// A device of the command line: a file (use_files) or a device of ALSA.
ComponentSettings device(std::string_view role, const std::string& name) {
  const bool is_file = is_file_of_sound(name);
  auto made =
      component(fmt::format("{}{}", is_file ? "File" : "Alsa", role), true);
  if (!is_file)
    made.options["device"] = name;
  return made;
}

ComponentSettings key(const VoiceWishes& wishes) {
  auto made = component("KeyPushToTalk", true);
  if (wishes.push_to_talk != terminal_key)
    made.options["device"] = wishes.push_to_talk;
  if (!wishes.talk_key.empty())
    made.options["key"] = wishes.talk_key;
  return made;
}

// What the command line wants for a role.
std::optional<ComponentSettings> wanted(std::string_view role,
                                        const VoiceWishes& wishes) {
  const bool by_key = !wishes.push_to_talk.empty();
  if (role == microphone_role && !wishes.microphone.empty())
    return device(role, wishes.microphone);
  if (role == speaker_role && !wishes.speaker.empty())
    return device(role, wishes.speaker);
  if (role == endpointer_role && by_key)
    return component("KeyEndpointer", true);
  if (role == recogniser_role && !wishes.recogniser.empty())
    return component(wishes.recogniser, false);
  if (role == key_role && by_key)
    return key(wishes);
  return std::nullopt;
}

// The components that fill each role, by their names.
using Filled = std::map<std::string, std::vector<std::string>, std::less<>>;

// The endpointers that can sleep.
std::vector<std::string> sleepers_of(const Composition& composition) {
  std::vector<std::string> names;
  for (const auto& component : composition.components) {
    const auto& description = component.factory.description;
    const bool can_sleep =
        std::ranges::any_of(description.options, [](const auto& option) {
          return option.name == "sleeps-after";
        });
    if (can_sleep && std::ranges::count(description.roles, endpointer_role) > 0)
      names.push_back(component.name);
  }
  return names;
}

Filled filled_roles(const Composition& composition) {
  Filled filled;
  for (const auto& component : composition.components)
    for (const auto& role : component.factory.description.roles)
      filled[role].push_back(component.name);
  return filled;
}

Expected<std::optional<ComponentSettings>> choose(const Link& link,
                                                  const Catalogue& plugins) {
  for (const auto& plugin : link.plugins)
    if (plugins.has(plugin) && is_installed(plugin))
      return component(plugin, link.per_seat);
  if (!link.required)
    return std::nullopt;
  return fail(ErrorKind::settings,
              fmt::format("--voice: this build has no plug-in for the role {} "
                          "(docs/speech.md says what it needs); the "
                          "application talks by text without --voice",
                          link.role));
}

// What is done to the settings: components that leave, and those that come
// before the others, which are preferred.
// Copied into the adjustment of the settings, which is applied each time that
// the application is compiled.
struct Changes {
  std::vector<std::string> out;
  std::vector<ComponentSettings> in;
  // Components of the settings that get other words to wake by, and those that
  // are to fall asleep if the settings do not say when.
  std::vector<std::string> spotters;
  std::vector<std::string> sleepers;
  std::string wake;

  // Where there are configured seats, the run talks at the first of them
  // (actors::Node::open_seat), and so the devices are there.
  void apply(Settings& settings) const {
    auto added = in;
    for (auto& component : added)
      keep_options(settings, component);
    std::erase_if(settings.components, [&](const auto& component) {
      return std::ranges::count(out, component.name) != 0;
    });
    for (auto& component : settings.components) {
      if (std::ranges::count(spotters, component.name) != 0)
        component.options["keywords"] = wake;
      if (std::ranges::count(sleepers, component.name) != 0)
        component.options.try_emplace("sleeps-after", sleeps_after);
    }
    if (!settings.seats.empty())
      for (auto& component : added)
        if (component.policy.scope.kind == Scope::Kind::seat)
          component.policy.seat = settings.seats.front().name;
    settings.components.insert(settings.components.begin(), added.begin(),
                               added.end());
  }

  // What the settings say of the same plug-in stands, such as how fast a file
  // is heard, but for what the command line says.
  static void keep_options(const Settings& settings, ComponentSettings& added) {
    for (const auto& component : settings.components)
      if (component.plugin == added.plugin)
        added.options.insert(component.options.begin(),
                             component.options.end());
  }
};

// Whether the seat has the link, and what a component for it is told.
bool is_wanted(const Link& link, bool sleeps) {
  return sleeps || link.role != spotter_role;
}

void instruct(ComponentSettings& component, std::string_view role,
              const VoiceWishes& wishes, bool sleeps) {
  if (role == spotter_role)
    component.options["keywords"] = wishes.wake;
  if (role == endpointer_role && sleeps)
    component.options["sleeps-after"] = sleeps_after;
}

// The sound file of the command line that the plug-in hears or writes; empty:
// there is none.
fs::path file_for(const PluginDescription& plugin, const VoiceWishes& wishes) {
  const std::pair<std::string_view, std::string> wished[] = {
      {microphone_role, wishes.microphone}, {speaker_role, wishes.speaker}};
  for (const auto& [role, name] : wished)
    if (is_file_of_sound(name) && std::ranges::count(plugin.roles, role) > 0)
      return name;
  return {};
}

std::string library_of(bool sleeps, bool is_enhanced) {
  return std::string("voice") + (sleeps ? "-wake" : "") +
         (is_enhanced ? "-enhanced" : "");
}

} // namespace

// Role by role: what the command line wants replaces what is there; a role that
// is open gets the best plug-in; a role that the settings fill stays as it is.
Expected<VoiceSources> add_voice(const fs::path& folder,
                                 const fs::path& platform, Catalogue& plugins,
                                 const VoiceWishes& wishes) {
  const auto composition = compose(settings_alone(folder, platform), plugins);
  auto filled = filled_roles(composition);
  Changes changes;
  const bool sleeps = wishes.push_to_talk.empty() &&
                      (!wishes.wake.empty() || filled.contains(spotter_role));
  if (!wishes.wake.empty()) {
    changes.spotters = filled[std::string(spotter_role)];
    changes.sleepers = sleepers_of(composition);
  }
  changes.wake = wishes.wake;
  for (const auto& link : chain()) {
    if (!is_wanted(link, sleeps))
      continue;
    auto& by = filled[std::string(link.role)];
    if (auto wish = wanted(link.role, wishes)) {
      changes.out.insert(changes.out.end(), by.begin(), by.end());
      changes.in.push_back(std::move(*wish));
    } else if (by.empty()) {
      auto chosen = choose(link, plugins);
      if (!chosen)
        return tl::make_unexpected(chosen.error());
      if (*chosen) {
        instruct(**chosen, link.role, wishes, sleeps);
        by.push_back((*chosen)->name);
        changes.in.push_back(std::move(**chosen));
      }
    }
  }
  const bool is_enhanced = !filled[std::string(enhancement_role)].empty();
  VoiceSources sources{
      [changes](Settings& settings) { changes.apply(settings); },
      {library_of(sleeps, is_enhanced)}};
  if (!filled[std::string(metrics_role)].empty())
    sources.libraries.emplace_back("turn-times");
  if (!wishes.push_to_talk.empty())
    sources.libraries.emplace_back("push-to-talk");
  return sources;
}

// The files of the command line may lie anywhere, those of settings only in the
// application's folder.
void use_files(Composition& composition, const VoiceWishes& wishes,
               const fs::path& folder) {
  for (auto& component : composition.components) {
    const auto& plugin = component.factory.description;
    const auto file = file_for(plugin, wishes);
    const auto open = shipped_plugin(plugin.name).for_file;
    if (open && !file.empty())
      component.factory = open(folder / file);
  }
}

} // namespace parlour::tools
