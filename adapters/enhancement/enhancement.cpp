#include "adapters/enhancement/enhancement.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "adapters/enhancement/echo_canceller.hpp"
#include "runtime/plugin/option_reader.hpp"
#include "runtime/plugin/role_plugin.hpp"

namespace parlour::adapters {

namespace {

// A stream takes about 1 MiB.
constexpr std::size_t most_streams = 32;

const std::vector<OptionDescription>& option_descriptions() {
  static const std::vector<OptionDescription> descriptions{
      {"noise-suppression", "false",
       "takes steady noise out; worse among voices", false,
       OptionType::boolean},
      {"gain-control", "false", "makes quiet voices louder", false,
       OptionType::boolean},
      {"delay", "0ms",
       "the least time from playing a sound to hearing it, up to 500ms", false,
       OptionType::duration}};
  return descriptions;
}

class WebRtcEnhancement : public RolePlugin {
public:
  WebRtcEnhancement() : RolePlugin("Enhancement") {
    on("Process", &WebRtcEnhancement::on_process);
    on("SetEcho", &WebRtcEnhancement::on_set_echo);
  }

protected:
  Expected<void> on_start(const Options& options) override {
    OptionReader read(options, option_descriptions());
    const auto delay =
        read.duration("delay", Milliseconds(0), Milliseconds(500));
    settings_ = {read.truth("noise-suppression"), read.truth("gain-control"),
                 static_cast<int>(delay.count())};
    if (auto outcome = read.outcome(); !outcome)
      return outcome;
    return EchoCanceller::make(settings_).map([](const auto&) {});
  }

private:
  struct Stream {
    EchoCanceller canceller;
    std::int64_t position = 0; // of what comes next, in ms
    std::uint64_t used = 0;
  };

  void on_process(const Binary& audio, std::optional<std::int64_t> position) {
    const Value value(audio);
    const auto samples = speech_samples(value);
    auto* const own = samples ? stream() : nullptr;
    // Audio that cannot be enhanced is passed on: better heard than lost.
    if (!own)
      return fire_event("Enhanced", {value, position.value_or(0)});
    const auto at = position.value_or(own->position);
    own->position = at + duration(samples->size());
    fire_event("Enhanced", {pcm_value(own->canceller.heard(*samples)), at});
  }

  void on_set_echo(const Binary& audio) {
    const Value value(audio);
    const auto samples = speech_samples(value);
    if (auto* const own = samples ? stream() : nullptr)
      own->canceller.played(*samples);
  }

  // That of the message's session; null if none can be made.
  Stream* stream() {
    auto found = streams_.find(current().session);
    if (found == streams_.end()) {
      auto made = EchoCanceller::make(settings_);
      if (!made)
        return nullptr;
      if (streams_.size() >= most_streams)
        streams_.erase(std::ranges::min_element(
            streams_, {}, [](const auto& each) { return each.second.used; }));
      found =
          streams_.emplace(current().session, Stream{std::move(*made)}).first;
    }
    found->second.used = ++uses_;
    return &found->second;
  }

  EchoCanceller::Settings settings_;
  std::map<SessionId, Stream> streams_;
  std::uint64_t uses_ = 0;
};

} // namespace

PluginFactory webrtc_enhancement_factory() {
  PluginDescription description;
  description.name = "WebRtcEnhancement";
  description.roles = {"Enhancement"};
  description.sentence = "takes the loudspeaker's echo out of what is heard";
  description.options = option_descriptions();
  return {std::move(description),
          [] { return std::make_unique<WebRtcEnhancement>(); }};
}

} // namespace parlour::adapters
