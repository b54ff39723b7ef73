#include "adapters/tts/engine_tts.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "runtime/plugin/open_messages.hpp"
#include "runtime/plugin/option_reader.hpp"

namespace parlour::adapters::tts {

namespace {

constexpr std::size_t max_voices = 256;

} // namespace

std::vector<OptionDescription> voice_options(const std::string& voice) {
  using Type = OptionType;
  return {
      {"voice", voice, "who speaks"},
      {"rate", "175", "words a minute, 80 to 450", false, Type::integer},
      {"pitch", "50", "0 to 99; 50 is the voice's own", false, Type::integer},
      {"volume", "100", "in percent, 0 to 200", false, Type::integer},
      {"ahead", "2s",
       "how long before it can be heard audio is delivered, 100ms to 60s",
       false, Type::duration},
      {"one-by-one", "false",
       "waits for each text's sound: where time is virtual", false,
       Type::boolean}};
}

EngineTTS::EngineTTS(SharedEngine& engine,
                     std::vector<OptionDescription> options)
    : shared_(engine), descriptions_(std::move(options)), calls_(calls()) {}

EngineTTS::~EngineTTS() = default;

SpeechCalls EngineTTS::calls() {
  using tts::Utterance;
  return {
      [this](const Utterance& one, Value frame) {
        answer(one.order, "Audio", {std::move(frame), one.id});
      },
      [this](const Utterance& one, const SpokenWord& word) {
        answer(one.order, "Mark", {one.id, word.word, word.position});
      },
      [this](const Utterance& one) { answer(one.order, "Finished", {one.id}); },
      [this](const Utterance& one, const std::string& reason) {
        as_answer_to(one.order, [&] { refuse(reason); });
      }};
}

// -- options ------------------------------------------------------------------

Expected<void> EngineTTS::read(const Options& options) {
  OptionReader read(options, descriptions_);
  // An option that the plug-in does not have keeps its default.
  auto number = [&](const char* name, int least, int most, int otherwise) {
    return read.has(name) ? static_cast<int>(read.integer(name, least, most))
                          : otherwise;
  };
  const VoiceSettings usual;
  settings_ = {read.text("voice"), number("rate", 80, 450, usual.rate),
               number("pitch", 0, 99, usual.pitch),
               number("volume", 0, 200, usual.volume)};
  pace_ = {read.duration("ahead", Milliseconds(100), Milliseconds(60'000)),
           read.truth("one-by-one")};
  return read.outcome();
}

Expected<void> EngineTTS::on_start(const Options& options) {
  if (auto fits = read(options); !fits)
    return fits;
  auto engine = shared_.use();
  if (!engine)
    return tl::make_unexpected(engine.error());
  engine_ = std::move(*engine);
  if (auto there = check_voice(settings_.voice); !there) {
    engine_.reset();
    return there;
  }
  return {};
}

void EngineTTS::stop() {
  queues_.clear();
  voices_.clear();
  engine_.reset();
}

// -- voices -------------------------------------------------------------------

Expected<void> EngineTTS::check_voice(const std::string& name) {
  Expected<void> outcome;
  engine_->run([&](Synthesizer& synthesizer) {
    outcome = synthesizer.check_voice(name);
  });
  return outcome;
}

const std::string& EngineTTS::voice_of(const SessionId& session) const {
  const auto found = std::ranges::find(
      voices_, session, &std::pair<SessionId, std::string>::first);
  return found == voices_.end() ? settings_.voice : found->second;
}

void EngineTTS::on_set_voice(const std::string& name) {
  if (const auto there = check_voice(name); !there)
    return refuse(there.error().message);
  const auto session = current().session;
  std::erase_if(voices_, [&](const auto& one) { return one.first == session; });
  if (voices_.size() == max_voices)
    voices_.pop_front();
  voices_.emplace_back(session, name);
}

// -- speaking -----------------------------------------------------------------

std::size_t EngineTTS::waiting() const {
  return std::accumulate(queues_.begin(), queues_.end(), std::size_t{0},
                         [](std::size_t sum, const auto& one) {
                           return sum + one.second->size();
                         });
}

void EngineTTS::forget_idle() {
  std::erase_if(queues_,
                [](const auto& one) { return one.second->size() == 0; });
}

void EngineTTS::on_speak(const std::string& text, Utterance utterance,
                         std::optional<bool>) {
  if (const auto length = count_characters(text); length > longest_text)
    return refuse(fmt::format("the text has {} characters, and at most {} are "
                              "spoken at once; say it in parts",
                              length, longest_text));
  forget_idle();
  if (waiting() >= max_waiting)
    return refuse(fmt::format("{} texts wait to be spoken already; wait for "
                              "Finished, or send Stop",
                              max_waiting));
  auto order = without_its_way(current());
  order.params.clear();
  auto settings = settings_;
  settings.voice = voice_of(order.session);
  auto& queue = queues_[order.session];
  if (!queue)
    queue = std::make_shared<UtteranceQueue>(host(), *engine_, pace_, calls_);
  queue->add({std::move(order), utterance, text, std::move(settings)});
}

void EngineTTS::on_stop(std::optional<Utterance> utterance) {
  if (const auto found = queues_.find(current().session);
      found != queues_.end())
    found->second->stop(utterance);
}

} // namespace parlour::adapters::tts
