#include "adapters/files/file_list.hpp"
#include "tests/adapters/files/files_fixture.hpp"

namespace parlour::adapters {
namespace {

using FileListTest = FilesTest;

TEST_F(FileListTest, LooksOneLevelForEachPart) {
  for (auto name : {"data/a", "data/b/a", "data/b/c/a"})
    outside.write(name, "");
  EXPECT_EQ(to_string(*list_files(data(), {"*"}, 100)), "[a]");
  EXPECT_EQ(to_string(*list_files(data(), {"b", "*"}, 100)), "[b/a]");
  EXPECT_EQ(to_string(*list_files(data(), {"*", "?", "*"}, 100)), "[b/c/a]");
}

TEST_F(FileListTest, OfAMissingFolderIsEmpty) {
  EXPECT_EQ(to_string(*list_files(data() / "none", {"*"}, 100)), "[]");
}

} // namespace
} // namespace parlour::adapters
