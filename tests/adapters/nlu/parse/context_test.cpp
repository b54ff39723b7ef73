#include <gtest/gtest.h>

#include "adapters/nlu/parse/context.hpp"
#include "tests/adapters/nlu/sample.hpp"

namespace parlour::adapters::nlu::test {
namespace {

class ContextTest : public testing::Test {
protected:
  Context read(Map map) const {
    return read_context(Value(std::move(map)), schema);
  }

  std::vector<Error> errors;
  Schema schema{sample_model(), sample_column, errors};
};

TEST_F(ContextTest, TellsWhatWasHeard) {
  EXPECT_FALSE(read({}).heard);
  EXPECT_TRUE(read({{"heard", List{}}}).heard);
  EXPECT_TRUE(read({{"heard", List{"too"}}}).heard);
}

TEST_F(ContextTest, IsReadByNames) {
  const auto context =
      read({{"asked", Map{{"topic", "Appointment"}, {"slot", "Time"}}},
            {"current", "Appointment"},
            {"resting", "Facility"},
            {"unfinished", List{"Taxi", "Appointment"}},
            {"completed", "Taxi"},
            {"grammar", "desk"},
            {"now", sample_now()}});
  EXPECT_EQ(context.asked_topic, 0U);
  EXPECT_EQ(context.asked_slot, "Time");
  EXPECT_EQ(context.asked_entity_id, static_cast<EntityId>(Form::time));
  EXPECT_EQ(context.current, 0U);
  EXPECT_EQ(context.resting, 1U);
  EXPECT_EQ(context.unfinished, (std::vector<TopicNumber>{2, 0}));
  EXPECT_EQ(context.completed, 2U);
  EXPECT_EQ(context.grammar, "desk");
  EXPECT_EQ(context.now, sample_now());
}

// What was asked before an aside counts half, and only where nothing is asked.
TEST_F(ContextTest, KeepsTheQuestionThatWaits) {
  const Map waiting{{"topic", "Appointment"}, {"slot", "Visitor"}};
  const auto after = read({{"waiting", waiting}});
  EXPECT_EQ(after.asked_topic, no_topic);
  EXPECT_EQ(after.waiting_slot, "Visitor");
  EXPECT_EQ(after.waiting_bonus(0, true), asked_bonus / 2);
  EXPECT_EQ(after.waiting_bonus(0, false), 0);
  EXPECT_EQ(after.waiting_bonus(2, true), 0);
  const auto asked = read({{"asked", Map{{"topic", "Taxi"}, {"slot", "Time"}}},
                           {"waiting", waiting}});
  EXPECT_EQ(asked.waiting_topic, no_topic);
  EXPECT_EQ(asked.asked_slot, "Time");
}

TEST_F(ContextTest, KeepsTheWordsOfWhatIsAsked) {
  using Words = std::vector<std::string>;
  const auto words = [&](const char* question) {
    return read({{"confirms", question}}).confirms;
  };
  EXPECT_EQ(words("Shall I block it? I cannot take it back."),
            (Words{"shall", "i", "block", "it"}));
  EXPECT_EQ(words("A blue one. Right? Or not?"),
            (Words{"a", "blue", "one", "right", "or", "not"}));
  EXPECT_EQ(words("Shall I call Dr. Ho at 10.30?"),
            (Words{"shall", "i", "call", "dr", "ho", "at", "10.30"}));
}

TEST_F(ContextTest, NamesSlotsThatMayBeWrong) {
  const auto context =
      read({{"changes",
             Map{{"topic", "Taxi"}, {"slots", Map{{"Time", "the hour"}}}}}});
  EXPECT_EQ(context.changes_topic, 2U);
  ASSERT_EQ(context.changes.size(), 1U);
  EXPECT_EQ(context.changes[0].slot, "Time");
  EXPECT_EQ(context.changes[0].words,
            (std::vector<std::string>{"the", "hour"}));
  EXPECT_TRUE(read({{"changes", Map{{"slots", 1}}}}).changes.empty());
}

TEST_F(ContextTest, LeavesOutWhatIsNotThere) {
  const Map strange[] = {
      {},
      {{"asked", Map{{"topic", "Appointment"}, {"slot", "Colour"}}},
       {"current", "Weather"},
       {"unfinished", List{"Weather", 7}},
       {"now", "soon"}},
      {{"asked", "Time"}, {"resting", 3}, {"unfinished", "Taxi"}},
  };
  for (const auto& map : strange) {
    const auto context = read(map);
    EXPECT_EQ(context.asked_topic, no_topic);
    EXPECT_EQ(context.asked_slot, "");
    EXPECT_EQ(context.asked_entity_id, asked_entity);
    EXPECT_EQ(context.current, no_topic);
    EXPECT_EQ(context.resting, no_topic);
    EXPECT_TRUE(context.unfinished.empty());
    EXPECT_FALSE(context.now);
  }
  EXPECT_EQ(read_context({}, schema).current, no_topic);
}

TEST_F(ContextTest, GivesABonusForBeingExpected) {
  const auto context = read({{"current", "Appointment"},
                             {"resting", "Facility"},
                             {"unfinished", List{"Taxi"}}});
  EXPECT_EQ(context.bonus(0), 0.2);
  EXPECT_EQ(context.bonus(1), 0.1);
  EXPECT_EQ(context.bonus(2), 0.1);
  EXPECT_EQ(context.bonus(no_topic), 0);
  EXPECT_EQ(read({}).bonus(0), 0);
}

} // namespace
} // namespace parlour::adapters::nlu::test
