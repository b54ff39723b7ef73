#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/plugin_template/plugin_source.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string source(const std::string& role) {
  return plugin_source("Mine", *find_role(role));
}

TEST(PluginSource, names_in_snakes) {
  const std::pair<const char*, const char*> cases[] = {
      {"EchoTTS", "echo_tts"},
      {"DoNLU", "do_nlu"},
      {"start_mic", "start_mic"},
      {"TTSEcho", "tts_echo"},
      {"Speak", "speak"},
      {"SetVoice", "set_voice"},
      {"A", "a"},
      {"LogSMS2", "log_sms2"}};
  for (const auto& [name, snake] : cases)
    EXPECT_EQ(snake_case(name), snake);
}

TEST(PluginSource, derives_from_the_tailored_adaptor) {
  const auto text = source("TTS");
  EXPECT_THAT(text, HasSubstr("class Mine : public parlour::TTSPlugin {"));
  EXPECT_THAT(text, HasSubstr("void on_speak(const std::string& /*text*/, "
                              "Utterance utterance,\n"
                              "                std::optional<bool> "
                              "/*interruptible*/) override {\n"
                              "    fire_finished(utterance);\n"));
  EXPECT_THAT(text, HasSubstr("PARLOUR_PLUGIN(Mine, {.name = \"Mine\","));
}

TEST(PluginSource, or_handles_each_command_itself) {
  const auto text = source("Robot");
  EXPECT_THAT(text, HasSubstr("class Mine : public parlour::RolePlugin {"));
  EXPECT_THAT(text, HasSubstr("on(\"Goto\", &Mine::on_goto);"));
  EXPECT_THAT(text, HasSubstr("fire_event(\"Grasped\", {\"\"});"));
  EXPECT_THAT(text, Not(HasSubstr("override")));
}

TEST(PluginSource, answers_by_the_event_that_is_called_alike) {
  const auto text = source("Microphone");
  EXPECT_THAT(text, HasSubstr("on_stop_mic() override {\n"
                              "    fire_stopped();"));
}

TEST(PluginSource, names_a_result_as_the_adaptor_does) {
  EXPECT_THAT(source("ASR"), HasSubstr("    fire_result(\"\", 0.5);\n"));
}

TEST(PluginSource, understands_and_words_without_messages) {
  EXPECT_THAT(source("NLU"), HasSubstr("understand("));
  EXPECT_THAT(source("NLG"), HasSubstr("generate("));
}

} // namespace
} // namespace parlour::tools
