#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"
#include "tools/parlour/status/running_nodes.hpp"
#include "tools/parlour/status/status_server.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

class RunningNodesTest : public testing::Test {
protected:
  RunningNodesTest() {
    places.environment = [this](const char* name) {
      return std::string(name) == "XDG_RUNTIME_DIR"
                 ? std::optional(folder.path().string())
                 : std::nullopt;
    };
  }

  test::TemporaryFolder folder;
  Places places;
};

TEST_F(RunningNodesTest, FindsTheOneThatIsMeant) {
  const auto server =
      StatusServer::open(folder.path() / "parlour", [](const auto& question) {
        return question == questions::who
                   ? to_json(RunningNode{"desk", "/apps/desk", getpid()})
                   : "you asked: " + question;
      });
  ASSERT_TRUE(server) << to_string(server.error());
  for (const auto* app : {"", "desk"}) {
    const auto node = the_node(places, app);
    ASSERT_TRUE(node) << to_string(node.error());
    EXPECT_EQ(node->folder, "/apps/desk");
    EXPECT_EQ(*answer_to(node->socket, "what?"), "you asked: what?");
  }
  const auto other = the_node(places, "butler");
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error().message,
              HasSubstr("'butler' does not run; running: desk"));
}

TEST_F(RunningNodesTest, SaysThatNothingRuns) {
  const auto none = the_node(places, "");
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("no application runs"));
  EXPECT_FALSE(ask(folder.path() / "nowhere.sock", "who"));
}

TEST_F(RunningNodesTest, WhoIsNotUnderstoodDoesNotCount) {
  const auto server = StatusServer::open(folder.path() / "parlour",
                                         [](const auto&) { return "hello"; });
  ASSERT_TRUE(server);
  EXPECT_FALSE(the_node(places, ""));
  EXPECT_FALSE(node_from_json("{}"));
}

} // namespace
} // namespace parlour::tools
