#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/plugins/plugin_file.hpp"
#include "runtime/plugin/test_host.hpp"
#include "tests/support/sample_plugins.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {
namespace {

using test::sample_plugins;
using testing::HasSubstr;

std::string error_of(const std::filesystem::path& file) {
  const auto opened = open_plugin_file(file);
  return opened ? "" : opened.error().message;
}

TEST(PluginFile, OpensAPluginThatTalks) {
  const auto factory = open_plugin_file(sample_plugins() / "EchoTTS.so");
  ASSERT_TRUE(factory) << factory.error().message;
  EXPECT_EQ(factory->description.name, "EchoTTS");
  EXPECT_EQ(factory->description.options.size(), 2u);
  TestHost host;
  const auto plugin = factory->create();
  ASSERT_TRUE(plugin->start(host, {{"prefix", "echo "}}));
  Message message;
  message.command = "Speak";
  message.params = {"hello", 1};
  plugin->receive(message);
  host.advance(Milliseconds(0));
  const auto events = host.take_events();
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(to_string(events[0]), ".Echo(echo hello)");
  EXPECT_EQ(to_string(events[1]), ".Finished(1)");
}

TEST(PluginFile, SharesTypesWithItsProgram) {
  const auto factory = open_plugin_file(sample_plugins() / "EchoTTS.so");
  ASSERT_TRUE(factory);
  const auto plugin = factory->create();
  EXPECT_NE(dynamic_cast<IPlugin*>(plugin.get()), nullptr);
  EXPECT_EQ(dynamic_cast<InlinePlugin*>(plugin.get()), nullptr);
}

// The file is replaced while what came from it runs.
TEST(PluginFile, OpensAChangedFileBesideTheOld) {
  test::TemporaryFolder folder;
  const auto file = folder.path() / "EchoTTS.so";
  std::filesystem::copy_file(sample_plugins() / "EchoTTS.so", file);
  const auto before = open_plugin_file(file);
  ASSERT_TRUE(before);
  const auto old = before->create();
  std::filesystem::copy_file(sample_plugins() / "changed/EchoTTS.so", file,
                             std::filesystem::copy_options::overwrite_existing);
  const auto after = open_plugin_file(file);
  ASSERT_TRUE(after);
  EXPECT_EQ(before->description.options[0].fallback, "");
  EXPECT_EQ(after->description.options[0].fallback, "changed: ");
  TestHost host;
  EXPECT_TRUE(old->start(host, {}));
  EXPECT_TRUE(after->create()->start(host, {}));
}

TEST(PluginFile, SaysWhyItCannotBeUsed) {
  EXPECT_THAT(error_of(sample_plugins() / "Nothing.so"),
              HasSubstr("there is no such file"));
  EXPECT_THAT(error_of(sample_plugins() / "Stranger.so"),
              HasSubstr("it is no plug-in of Parlour"));
  EXPECT_THAT(error_of(sample_plugins() / "OldInterface.so"),
              HasSubstr("it was built for interface 0 of plug-ins"));
  EXPECT_THAT(error_of(sample_plugins() / "OtherLayout.so"),
              HasSubstr("lay types out otherwise"));
  EXPECT_THAT(error_of(sample_plugins() / "Shy.so"),
              HasSubstr("it fails to describe itself: not today"));
}

TEST(PluginFile, SaysWhyThereIsNoFolderForItsCopy) {
  test::TemporaryFolder folder;
  folder.write("Text.so", "no library");
  const auto former = std::getenv("TMPDIR");
  const std::string kept = former ? former : "";
  setenv("TMPDIR", (folder.path() / "Text.so").c_str(), 1);
  errno = 0; // of the reason, it says nothing
  EXPECT_THAT(error_of(folder.path() / "Text.so"),
              HasSubstr("(TMPDIR says where): Not a directory"));
  former ? setenv("TMPDIR", kept.c_str(), 1) : unsetenv("TMPDIR");
}

TEST(PluginFile, NamesTheFileInsteadOfItsCopy) {
  test::TemporaryFolder folder;
  folder.write("Text.so", "no library");
  const auto said = error_of(folder.path() / "Text.so");
  EXPECT_THAT(said, HasSubstr((folder.path() / "Text.so").string() +
                              " cannot be used: Text.so: "));
  EXPECT_THAT(said, testing::Not(HasSubstr("XXXX")));
}

TEST(PluginFile, IsCalledAsItsPlugin) {
  test::TemporaryFolder folder;
  std::filesystem::copy_file(sample_plugins() / "EchoTTS.so",
                             folder.path() / "Other.so");
  EXPECT_THAT(error_of(folder.path() / "Other.so"),
              HasSubstr("it holds the plug-in 'EchoTTS'; call the file "
                        "EchoTTS.so"));
}

} // namespace
} // namespace parlour::adapters
