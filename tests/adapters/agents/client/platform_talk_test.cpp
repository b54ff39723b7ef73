#include <gmock/gmock.h>

#include "adapters/agents/client/platform_talk.hpp"

namespace parlour::adapters::agents {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// Keeps what is written.
class KeptConnection : public PeerConnection {
public:
  void start() override {}
  void write(const AgentMessage& message) override {
    written.push_back(message);
  }
  void pack() override {
    is_packed = true;
  }
  void close() override {}

  std::vector<AgentMessage> written;
  bool is_packed = false;
};

class PlatformTalkTest : public testing::Test, PlatformTalk::Owner {
protected:
  void welcomed() override {
    told.emplace_back("welcomed");
  }
  void received(AgentMessage&& message) override {
    told.push_back("received " + message.command);
  }
  void note(const std::string& text) override {
    told.push_back("note: " + text);
  }
  void lose(const std::string& reason) override {
    link.disconnect();
    told.push_back("lose: " + reason);
  }
  void end(const Error& reason) override {
    told.push_back("end: " + reason.message);
  }

  static Hello hello() {
    Hello hello;
    hello.name = "Robot";
    return hello;
  }
  std::vector<std::string> take(Read<AgentMessage> message) {
    told.clear();
    talk.take(connection, std::move(message), 0);
    return told;
  }
  std::vector<std::string> welcome(std::uint64_t version = newest_version,
                                   bool packed = false) {
    Introduction platform{"bb", "", 0, 100, packed};
    return take(welcome_message(platform, version));
  }
  static AgentMessage error(const std::string& kind) {
    AgentMessage message;
    message.kind = MessageKind::error;
    message.command = kind;
    message.parameters = {"because"};
    return message;
  }
  static AgentMessage command(const std::string& name, std::uint64_t number) {
    AgentMessage message;
    message.kind = MessageKind::text;
    message.command = name;
    message.number = number;
    return message;
  }

  SharedLink link{"aa"};
  KeptConnection connection;
  std::vector<std::string> told;
  PlatformTalk talk{hello(), link, *this};
};

TEST_F(PlatformTalkTest, IntroducesTheAgent) {
  talk.say_hello(connection, true);
  ASSERT_EQ(connection.written.size(), 1u);
  const auto said = hello_of(connection.written[0]);
  ASSERT_TRUE(said);
  EXPECT_EQ(said->name, "Robot");
  EXPECT_EQ(said->introduction.incarnation, "aa");
  EXPECT_TRUE(said->introduction.packed);
}

TEST_F(PlatformTalkTest, HandsMessagesOnOnceItIsWelcome) {
  EXPECT_THAT(take(command("Goto", 1)), IsEmpty());
  EXPECT_THAT(welcome(), ElementsAre("welcomed"));
  EXPECT_TRUE(link.is_connected());
  EXPECT_FALSE(connection.is_packed);
  EXPECT_THAT(take(command("Goto", 1)), ElementsAre("received Goto"));
  EXPECT_THAT(take(command("Goto", 1)), IsEmpty()); // it came before
}

TEST_F(PlatformTalkTest, PacksWhereThePlatformReadsThat) {
  EXPECT_THAT(welcome(newest_version, true), ElementsAre("welcomed"));
  EXPECT_TRUE(connection.is_packed);
}

TEST_F(PlatformTalkTest, EndsWhereThePlatformSpeaksNoVersionOfIt) {
  EXPECT_THAT(welcome(newest_version + 1),
              ElementsAre(HasSubstr("end: version: ")));
  ASSERT_EQ(connection.written.size(), 1u);
  EXPECT_EQ(connection.written[0].command, "version");
  EXPECT_EQ(connection.written[0].component, "Robot");
}

TEST_F(PlatformTalkTest, KnowsWhichErrorsEndIt) {
  EXPECT_THAT(take(error("identity")), ElementsAre("end: identity: because"));
  EXPECT_THAT(take(error("unknown")),
              ElementsAre("note: the platform says unknown: because",
                          HasSubstr("lose: ")));
  EXPECT_THAT(take(error("later")),
              ElementsAre("note: the platform says later: because"));
  auto answer = error("unknown");
  answer.correlation = 7;
  EXPECT_THAT(take(answer), ElementsAre("received unknown"));
}

TEST_F(PlatformTalkTest, LosesAPlatformThatSaysGoodbye) {
  AgentMessage bye;
  bye.kind = MessageKind::bye;
  EXPECT_THAT(take(bye), ElementsAre("lose: the platform has said goodbye"));
}

TEST_F(PlatformTalkTest, LosesAPlatformThatMakesMistakeAfterMistake) {
  welcome();
  const WireError mistake{WireErrorKind::malformed, "no number"};
  for (int i = 1; i < AgentExchange::max_malformed; ++i) {
    take(tl::make_unexpected(mistake));
    EXPECT_TRUE(link.is_connected());
    EXPECT_EQ(connection.written.size(), static_cast<std::size_t>(i));
  }
  take(tl::make_unexpected(mistake));
  EXPECT_THAT(told.back(), HasSubstr("lose: "));
}

} // namespace
} // namespace parlour::adapters::agents
