#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/plugin_template/plugin_skeleton.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

std::string error_of(const std::string& name, const std::string& role) {
  return plugin_skeleton(name, role).error().message;
}

TEST(PluginSkeleton, has_all_that_builds_and_tests_it) {
  const auto files = plugin_skeleton("EchoTTS", "TTS");
  ASSERT_TRUE(files);
  std::vector<std::string> names;
  for (const auto& file : *files)
    names.push_back(file.name);
  EXPECT_THAT(names, testing::ElementsAre("CMakeLists.txt", "echo_tts.cpp",
                                          "echo_tts_test.cpp", "README.md"));
  EXPECT_THAT(files->at(0).text,
              HasSubstr("parlour_plugin(EchoTTS SOURCES echo_tts.cpp)"));
  EXPECT_THAT(files->at(3).text, HasSubstr("<Plugin>EchoTTS</Plugin>"));
}

TEST(PluginSkeleton, knows_roles_by_their_aliases) {
  EXPECT_THAT(plugin_skeleton("Ear", "Record")->at(1).text,
              HasSubstr("MicrophonePlugin"));
}

TEST(PluginSkeleton, has_lines_that_can_be_read) {
  for (const auto& role : component_roles()) {
    const auto files = plugin_skeleton("New" + role, role);
    for (const auto& file : files.value()) {
      std::istringstream lines(file.text);
      for (std::string line; std::getline(lines, line);)
        EXPECT_TRUE(line.size() <= 80 || !file.name.ends_with(".cpp")) << line;
    }
  }
}

TEST(PluginSkeleton, wants_a_name_and_a_role) {
  for (const auto* name : {"", "echo", "Echo TTS", "../Echo", "7Echo"})
    EXPECT_THAT(error_of(name, "TTS"), HasSubstr("is no name for a plug-in"));
  EXPECT_EQ(error_of("Echo", "TTSS"),
            "there is no role 'TTSS', did you mean 'TTS'?");
  EXPECT_THAT(error_of("Echo", "Balloon"),
              HasSubstr("; roles are Microphone, PushToTalk"));
  EXPECT_THAT(error_of("Echo", "System"), HasSubstr("there is no role"));
}

} // namespace
} // namespace parlour::tools
