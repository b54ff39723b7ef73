#include "actors/sessions/unaddressed.hpp"
#include "tests/actors/node_fixture.hpp"
#include "tests/support/manual_clock.hpp"

namespace parlour::actors {
namespace {

class UnaddressedTest : public testing::Test {
protected:
  UnaddressedTest() {
    RoutingTable::Parts parts;
    parts.program = compile("<routes><open source='Bell' command='Strikes' "
                            "seat='desk'/></routes>");
    parts.clock = &clock;
    parts.counters = std::make_shared<Counters>();
    table = std::make_unique<RoutingTable>(std::move(parts));
  }
  static Message event(std::string source, std::string command,
                       Correlation correlation = 0) {
    Message message;
    message.source = std::move(source);
    message.command = std::move(command);
    message.correlation = correlation;
    return message;
  }
  // "Strikes, Rings | Falls": left, and taken out.
  std::string parted(std::vector<Message> messages, const std::string& seat) {
    const auto others = take_others(messages, *table, seat);
    return names(messages) + "| " + names(others);
  }

  test::ManualClock clock;
  std::unique_ptr<RoutingTable> table;

private:
  static std::string names(const std::vector<Message>& messages) {
    std::string all;
    for (const auto& message : messages)
      all += message.command + " ";
    return all;
  }
};

TEST_F(UnaddressedTest, KnowsWhoHasSubscribed) {
  const auto rings = event("Bell", "Rings");
  EXPECT_TRUE(is_subscribed({{"Bell", "*"}}, *table, rings));
  EXPECT_TRUE(is_subscribed({{"*", "Falls"}, {"*", "Rings"}}, *table, rings));
  EXPECT_FALSE(is_subscribed({{"Bell", "Falls"}}, *table, rings));
  EXPECT_FALSE(is_subscribed({{"Door", "Rings"}}, *table, rings));
  EXPECT_FALSE(is_subscribed({}, *table, rings));
}

TEST_F(UnaddressedTest, KnowsWhatOpensAConversationAtASeat) {
  EXPECT_TRUE(opens_at("desk", *table, event("Bell", "Strikes")));
  EXPECT_TRUE(opens_at("desk", *table, event("ASR", "RecognitionResult", 7)));
  EXPECT_FALSE(opens_at("hall", *table, event("Bell", "Strikes")));
  EXPECT_FALSE(opens_at("desk", *table, event("Bell", "Rings")));
  EXPECT_FALSE(opens_at("desk", *table, event("Bell", "Strikes", 7)))
      << "it answers somebody";
}

TEST_F(UnaddressedTest, OfASessionThatIsOverTurnsAloneAreTheNextOnes) {
  EXPECT_EQ(parted({event("Bell", "Strikes"), event("ASR", "RecognitionResult"),
                    event("Bell", "Rings"), event("ASR", "RecognitionResult")},
                   ""),
            "RecognitionResult RecognitionResult | Strikes Rings ");
}

TEST_F(UnaddressedTest, AtASeatAllIsTheNextOnesFromWhatOpensIt) {
  EXPECT_EQ(parted({event("Bell", "Rings"), event("Bell", "Strikes"),
                    event("Bell", "Falls")},
                   "desk"),
            "Strikes Falls | Rings ");
  EXPECT_EQ(parted({event("Bell", "Rings")}, "desk"), "| Rings ");
  EXPECT_EQ(parted({event("System", "AgentOnline")}, "desk"), "| ")
      << "nobody has to take it";
}

} // namespace
} // namespace parlour::actors
