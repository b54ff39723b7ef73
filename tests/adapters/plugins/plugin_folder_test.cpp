#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/plugins/plugin_folder.hpp"
#include "tests/support/sample_plugins.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {
namespace {

using test::sample_plugins;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class PluginFolderTest : public testing::Test {
protected:
  void put(const std::string& sample) {
    std::filesystem::copy_file(
        sample_plugins() / sample, folder_.path() / "EchoTTS.so",
        std::filesystem::copy_options::overwrite_existing);
  }
  std::string prefix() {
    return plugins_.find("EchoTTS")->description.options.at(0).fallback;
  }

  test::TemporaryFolder folder_;
  PluginFolder plugins_{folder_.path()};
};

TEST_F(PluginFolderTest, NamesItsFiles) {
  EXPECT_THAT(plugins_.names(), IsEmpty());
  folder_.write("B.so", "");
  folder_.write("A.so", "");
  folder_.write("notes.txt", "");
  folder_.write(".hidden.so", "");
  std::filesystem::create_directories(folder_.path() / "Folder.so");
  EXPECT_THAT(plugins_.names(), ElementsAre("A", "B"));
  EXPECT_TRUE(plugins_.has("A"));
  EXPECT_FALSE(plugins_.has("C"));
}

TEST_F(PluginFolderTest, IsEmptyWhereItIsMissing) {
  EXPECT_THAT(PluginFolder("/nowhere/at/all").names(), IsEmpty());
}

TEST_F(PluginFolderTest, FindsAFileAsItIsNow) {
  put("EchoTTS.so");
  EXPECT_EQ(prefix(), "");
  put("changed/EchoTTS.so");
  EXPECT_EQ(prefix(), "changed: ");
}

TEST_F(PluginFolderTest, LooksAgainAtAFileThatWasWrong) {
  folder_.write("EchoTTS.so", "half of it");
  EXPECT_FALSE(plugins_.find("EchoTTS"));
  put("EchoTTS.so");
  EXPECT_TRUE(plugins_.find("EchoTTS"));
}

TEST_F(PluginFolderTest, IsNeverLeft) {
  folder_.write("inner/Evil.so", "");
  for (const auto* name : {"inner/Evil", "../Evil", "/Evil", "", ".", ".."}) {
    EXPECT_FALSE(plugins_.has(name)) << name;
    const auto found = plugins_.find(name);
    ASSERT_FALSE(found) << name;
    EXPECT_THAT(found.error().message, HasSubstr("is no name of a plug-in"));
  }
}

} // namespace
} // namespace parlour::adapters
