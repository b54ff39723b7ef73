#include <cstdio>

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"
#include "tools/parlour/console/completion.hpp"

namespace parlour::tools {
namespace {

// What bash offers for the last of `words`.
std::string offered(const std::string& words) {
  CLI::App app("program", "parlour");
  app.add_subcommand("test")->add_flag("--trace,-t");
  app.add_subcommand("run")->add_flag("--text");
  auto* plugin = app.add_subcommand("plugin");
  plugin->add_subcommand("list")->add_option("--plugins");
  plugin->add_subcommand("new")->add_option("--role");
  app.add_subcommand("hidden")->group("");
  test::TemporaryFolder folder;
  folder.write("script", completion_script(app, {{"--role", {"TTS", "Taxi"}}}));
  folder.write("config/apps/desk/settings.xml", "");
  const auto command = "cd " + folder.path().string() +
                       " && bash -c 'source ./script; COMP_WORDS=(parlour " +
                       words +
                       "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _parlour; "
                       "echo \"${COMPREPLY[@]}\"'";
  auto* pipe = popen(command.c_str(), "r");
  char buffer[4096];
  const auto size = fread(buffer, 1, sizeof buffer, pipe);
  pclose(pipe);
  return std::string(buffer, size);
}

TEST(Completion, offers_commands) {
  EXPECT_EQ(offered("t"), "test\n");
  EXPECT_EQ(offered("\"\""), "test run plugin --help\n");
}

TEST(Completion, offers_the_options_of_a_command) {
  EXPECT_EQ(offered("test --t"), "--trace\n");
  EXPECT_EQ(offered("run --"), "--help --text\n");
}

TEST(Completion, offers_the_commands_of_a_group) {
  EXPECT_EQ(offered("plugin \"\""), "list new --help\n");
  EXPECT_EQ(offered("plugin n"), "new\n");
  EXPECT_EQ(offered("plugin new --"), "--help --role\n");
  EXPECT_EQ(offered("plugin list --p"), "--plugins\n");
  EXPECT_EQ(offered("plugin list s"), "script\n");
}

TEST(Completion, offers_what_an_option_takes) {
  EXPECT_EQ(offered("plugin new Echo --role \"\""), "TTS Taxi\n");
  EXPECT_EQ(offered("plugin new Echo --role Ta"), "Taxi\n");
}

TEST(Completion, offers_files_and_applications) {
  EXPECT_EQ(offered("run d"), "desk\n");
  EXPECT_EQ(offered("run s"), "script\n");
}

} // namespace
} // namespace parlour::tools
