// A correct plug-in (role TTS) that fires each text as an event. It is built
// twice, with different prefixes, to test reloading a changed file.
#include "runtime/plugin/adaptors.hpp"
#include "runtime/plugin/export.hpp"

#ifndef ECHO_PREFIX
#define ECHO_PREFIX ""
#endif

namespace {

const std::vector<parlour::OptionDescription> options = {
    {"prefix", ECHO_PREFIX, "what stands before each text", false},
    {"pace", "0ms", "how long a text takes", false,
     parlour::OptionType::duration}};

class EchoTTS : public parlour::TTSPlugin {
public:
  EchoTTS() {
    on("Whisper", &EchoTTS::on_whisper);
  }

protected:
  parlour::Expected<void> on_start(const parlour::Options& given) override {
    prefix_ = parlour::option_value(given, options, "prefix");
    const auto pace =
        parlour::parse_duration(parlour::option_value(given, options, "pace"));
    if (!pace)
      return tl::make_unexpected(pace.error());
    pace_ = *pace;
    return {};
  }

  void on_speak(const std::string& text, Utterance utterance,
                std::optional<bool>) override {
    fire_event("Echo", {prefix_ + text});
    host().after(pace_, [this, utterance, asked = current()] {
      as_answer_to(asked, [&] { fire_finished(utterance); });
    });
  }
  void on_stop(std::optional<Utterance>) override {}

private:
  void on_whisper(const std::string& text) {
    fire_event("Echo", {"(" + text + ")"});
  }

  std::string prefix_;
  parlour::Milliseconds pace_{0};
};

} // namespace

PARLOUR_PLUGIN(EchoTTS, {.name = "EchoTTS",
                         .roles = {"TTS"},
                         .sentence = "says what it is to say as an event",
                         .options = options,
                         .commands = {{"Whisper", "text"}},
                         .events = {{"Echo", "text"}}})
