#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/plugins/plugin_file.hpp"
#include "adapters/plugins/shared_object.hpp"
#include "tests/support/sample_plugins.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {
namespace {

class SharedObjectTest : public testing::Test {
protected:
  // The first bytes of a plug-in.
  std::filesystem::path cut(std::uintmax_t size) {
    const auto whole = test::sample_plugins() / "EchoTTS.so";
    const auto file = folder_.path() / "EchoTTS.so";
    std::filesystem::copy_file(
        whole, file, std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(file, size);
    return file;
  }

  test::TemporaryFolder folder_;
};

TEST_F(SharedObjectTest, AWholeOneIsNot) {
  EXPECT_FALSE(is_cut_off(test::sample_plugins() / "EchoTTS.so"));
}

TEST_F(SharedObjectTest, WhereverItEnds) {
  for (const auto size : {100, 1'000, 3'000, 9'000}) {
    const auto file = cut(static_cast<std::uintmax_t>(size));
    EXPECT_TRUE(is_cut_off(file)) << size;
    const auto opened = open_plugin_file(file);
    ASSERT_FALSE(opened) << size;
    EXPECT_THAT(opened.error().message, testing::HasSubstr("is cut off"));
  }
}

TEST_F(SharedObjectTest, WhatIsNoLibraryIsForTheLoaderToSay) {
  folder_.write("text.so", "hello");
  folder_.write("empty.so", "");
  for (const auto* name : {"text.so", "empty.so", "none.so"})
    EXPECT_FALSE(is_cut_off(folder_.path() / name)) << name;
}

} // namespace
} // namespace parlour::adapters
