#include <gmock/gmock.h>

#include "adapters/agents/delivery/hello.hpp"

namespace parlour::adapters::agents {
namespace {

using testing::ElementsAre;

AgentMessage said(std::vector<std::string> parameters) {
  AgentMessage message;
  message.kind = MessageKind::hello;
  message.component = "Robot";
  message.command = "Hello";
  message.parameters = std::move(parameters);
  return message;
}

TEST(Hello, GoesThereAndBack) {
  Hello hello;
  hello.name = "Robot";
  hello.introduction = {"0f3a", "99aa", 12, 7, true};
  hello.roles = {"Robot", "Sensor"};
  hello.json = true;
  hello.token = "secret=1";
  EXPECT_EQ(hello_of(hello_message(hello)).value(), hello);
}

TEST(Hello, NeedsNothingButAName) {
  const auto hello = hello_of(said({}));
  ASSERT_TRUE(hello);
  EXPECT_EQ(hello->name, "Robot");
  EXPECT_EQ(hello->version, 1U);
  EXPECT_EQ(hello->introduction, Introduction());
}

TEST(Hello, IgnoresKeysOfLaterVersions) {
  EXPECT_THAT(hello_of(said({"colour=red", "roles= A  B "}))->roles,
              ElementsAre("A", "B"));
}

TEST(Hello, AnswersWrongValues) {
  for (const auto* wrong : {"version=new", "window=", "seen=99:x", "seen=99",
                            "incarnation=robot", "oldest=-1"})
    EXPECT_FALSE(hello_of(said({wrong}))) << wrong;
}

TEST(Hello, AgreesOnAVersion) {
  EXPECT_EQ(common_version(*hello_of(said({}))), 1U);
  EXPECT_EQ(common_version(*hello_of(said({"version=7", "oldest=1"}))), 1U);
  const auto newer = common_version(*hello_of(said({"version=7"})));
  ASSERT_FALSE(newer);
  EXPECT_EQ(newer.error().kind, WireErrorKind::version);
  EXPECT_FALSE(common_version(*hello_of(said({"version=0"}))));
}

// Each row: what the agent speaks, what the platform speaks, what both do.
TEST(Hello, OlderAndNewerPeersAgreeOnAVersion) {
  struct Row {
    Versions agent, platform;
    std::uint64_t common; // 0: none
  };
  for (const auto& [agent, platform, common] :
       {Row{{1, 1}, {1, 1}, 1}, Row{{1, 3}, {1, 2}, 2}, Row{{1, 2}, {1, 3}, 2},
        Row{{2, 2}, {1, 3}, 2}, Row{{1, 1}, {2, 3}, 0}, Row{{3, 4}, {1, 2}, 0},
        Row{{2, 5}, {4, 9}, 5}}) {
    Hello hello;
    hello.oldest = agent.oldest;
    hello.version = agent.newest;
    const auto agreed = common_version(hello, platform);
    ASSERT_EQ(agreed.has_value(), common != 0);
    if (!agreed) {
      EXPECT_EQ(agreed.error().kind, WireErrorKind::version);
      continue;
    }
    EXPECT_EQ(*agreed, common);
    EXPECT_TRUE(check_version({*agreed, {}}, hello));
  }
}

TEST(Welcome, OfAVersionThatWasNotOfferedIsRefused) {
  const auto offered = *hello_of(said({"version=4", "oldest=3"}));
  EXPECT_FALSE(check_version({2, {}}, offered));
  EXPECT_TRUE(check_version({3, {}}, offered));
  EXPECT_TRUE(check_version({4, {}}, offered));
  const auto later = check_version({5, {}}, offered);
  ASSERT_FALSE(later);
  EXPECT_EQ(later.error().kind, WireErrorKind::version);
  EXPECT_THAT(later.error().sentence, testing::HasSubstr("version 5"));
}

TEST(Welcome, WithoutAVersionIsOfTheFirst) {
  EXPECT_EQ(welcome_of(said({"incarnation=99"}))->version, 1U);
}

TEST(Welcome, GoesThereAndBack) {
  const Introduction introduction{"0f3a", "99aa", 12, 7};
  const auto welcome = welcome_of(welcome_message(introduction, 1));
  ASSERT_TRUE(welcome);
  EXPECT_EQ(welcome->introduction, introduction);
  EXPECT_EQ(welcome->version, 1U);
}

TEST(Incarnation, IsNewEachTime) {
  EXPECT_EQ(new_incarnation().size(), 16U);
  EXPECT_NE(new_incarnation(), new_incarnation());
}

} // namespace
} // namespace parlour::adapters::agents
