#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"
#include "tools/parlour/application/data_folder.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

TEST(DataFolder, is_made_with_those_above_it) {
  test::TemporaryFolder folder;
  const auto data = DataFolder::open(folder.path() / "a/b");
  ASSERT_TRUE(data);
  EXPECT_TRUE(folder.has("a/b/.lock"));
  EXPECT_TRUE(data->path().is_absolute());
}

TEST(DataFolder, is_held_by_one_at_a_time) {
  test::TemporaryFolder folder;
  auto first = DataFolder::open(folder.path());
  ASSERT_TRUE(first);
  const auto second = DataFolder::open(folder.path());
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().kind, ErrorKind::file);
  EXPECT_THAT(second.error().message, HasSubstr("in use by another parlour"));
  EXPECT_THAT(second.error().message, HasSubstr("(process "));
}

TEST(DataFolder, is_free_when_its_holder_has_gone) {
  test::TemporaryFolder folder;
  {
    auto first = DataFolder::open(folder.path());
    ASSERT_TRUE(first);
    const auto moved = std::move(*first);
  }
  EXPECT_TRUE(DataFolder::open(folder.path()));
}

TEST(DataFolder, says_why_it_cannot_be_made) {
  test::TemporaryFolder folder;
  folder.write("file", "text");
  const auto data = DataFolder::open(folder.path() / "file/data");
  ASSERT_FALSE(data);
  EXPECT_THAT(data.error().message, HasSubstr("cannot be made"));
}

TEST(DataFolder, that_is_temporary_goes_with_its_holder) {
  std::filesystem::path path;
  {
    const auto data = DataFolder::temporary();
    ASSERT_TRUE(data);
    path = data->path();
    EXPECT_TRUE(std::filesystem::is_directory(path));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

} // namespace
} // namespace parlour::tools
