#include <fcntl.h>

#include "adapters/files/folder.hpp"
#include "tests/adapters/files/files_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;
using testing::UnorderedElementsAre;

class FolderTest : public FilesTest {
protected:
  Folder top = *Folder::open(data(), Missing::refuse);
};

TEST_F(FolderTest, OpensWhatIsInIt) {
  EXPECT_FALSE(top.folder("a", Missing::refuse));
  const auto below = top.folder("a", Missing::make);
  ASSERT_TRUE(below);
  EXPECT_TRUE(top.folder("a", Missing::make));
  EXPECT_FALSE(below->file("f", O_RDONLY));
  EXPECT_TRUE(below->file("f", O_WRONLY | O_CREAT));
  EXPECT_TRUE(outside.has("data/a/f"));
}

TEST_F(FolderTest, FollowsNoLink) {
  link("..", "l");
  EXPECT_THAT(top.folder("l", Missing::refuse).error().message,
              HasSubstr("link"));
  EXPECT_THAT(top.folder("l", Missing::make).error().message,
              HasSubstr("link"));
  EXPECT_THAT(top.file("l", O_RDONLY).error().message, HasSubstr("link"));
}

TEST_F(FolderTest, KnowsWhatThereIs) {
  outside.write("data/f", "x");
  outside.write("data/d/f", "x");
  link("f", "l");
  EXPECT_EQ(top.what("f"), Folder::What::file);
  EXPECT_EQ(top.what("d"), Folder::What::folder);
  EXPECT_EQ(top.what("l"), Folder::What::other);
  EXPECT_EQ(top.what("x"), Folder::What::nothing);
  EXPECT_THAT(*top.names(10), UnorderedElementsAre(".", "..", "f", "d", "l"));
  EXPECT_THAT(*top.names(10), UnorderedElementsAre(".", "..", "f", "d", "l"));
  EXPECT_FALSE(top.names(4));
}

} // namespace
} // namespace parlour::adapters
