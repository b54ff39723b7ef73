#include "adapters/wyoming/wyoming_tts.hpp"

#include "adapters/wyoming/remote_synthesizer.hpp"

namespace parlour::adapters {

namespace {

const std::vector<OptionDescription>& descriptions() {
  static const auto all = [] {
    auto options = wyoming::client_options("10200");
    options.push_back({"voice", "", "who speaks; else as the server likes"});
    options.push_back({"language", "", "such as en; else the voice's"});
    for (const auto& option : tts::voice_options(""))
      if (option.name == "ahead")
        options.push_back(option);
    return options;
  }();
  return all;
}

} // namespace

WyomingTTS::WyomingTTS()
    : EngineTTS(engine_, descriptions()), engine_([this] {
        return wyoming::make_remote_synthesizer(*client_, language_);
      }) {}

WyomingTTS::~WyomingTTS() = default;

Expected<void> WyomingTTS::on_start(const Options& options) {
  auto client = wyoming::Client::start(host(), options, descriptions(), "tts");
  if (!client)
    return tl::make_unexpected(client.error());
  client_ = std::move(*client);
  language_ = option_value(options, descriptions(), "language");
  return EngineTTS::on_start(options);
}

// The synthesizer uses the client.
void WyomingTTS::stop() {
  EngineTTS::stop();
  client_.reset();
}

PluginFactory wyoming_tts_factory() {
  PluginDescription description;
  description.name = "WyomingTTS";
  description.roles = {"TTS"};
  description.sentence = "has texts spoken by a server of the Wyoming "
                         "protocol: piper";
  description.options = descriptions();
  return {description, [] { return std::make_unique<WyomingTTS>(); }};
}

} // namespace parlour::adapters
