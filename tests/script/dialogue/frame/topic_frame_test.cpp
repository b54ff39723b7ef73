#include "script/dialogue/frame/topic_frame.hpp"
#include "tests/script/dialogue/dialogue_fixture.hpp"

namespace parlour::dialogue {

namespace {

TEST(TopicFrame, BeginsWithTheInitialValues) {
  Application app;
  auto topic = app.topic("Call");
  app.slot(topic, "Line").initial = app.text(1);
  app.slot(topic, "Number").initial = app.text({}); // expr="unknown"
  app.slot(topic, "Next").initial = app.code([](const SlotReader& read) {
    return Value(read("Line").integer_or(0) + 1);
  });
  app.slot(topic, "Bad").initial =
      app.code([](const SlotReader&) { return fail(ErrorKind::type, "no"); });
  auto frame = app.frame(topic);
  EXPECT_EQ(frame.status, TopicStatus::untouched);
  EXPECT_FALSE(frame.done);
  EXPECT_EQ(frame.slots[0].value, Value(1));
  EXPECT_EQ(frame.slots[0].status, SlotStatus::filled);
  EXPECT_TRUE(frame.slots[0].by_default);
  EXPECT_EQ(frame.slots[1].status, SlotStatus::empty);
  EXPECT_EQ(frame.slots[2].value, Value(2));
  EXPECT_EQ(frame.slots[3].status, SlotStatus::empty);
  ASSERT_EQ(frame.errors.size(), 1u);
  EXPECT_EQ(frame.errors[0].message, "no");
}

TEST(TopicFrame, MissesTheFirstFunctionalSlotThatIsNotAccepted) {
  Receptionist app;
  auto frame = app.frame(app.appointment);
  const auto& topic = app.program.topics[app.appointment];
  EXPECT_EQ(missing_slot(topic, frame), app.id(app.appointment, "Visitor"));
  frame.slots[0].status = SlotStatus::filled;
  EXPECT_EQ(missing_slot(topic, frame), app.id(app.appointment, "Host"));
  frame.slots[2].status = SlotStatus::unconfirmed;
  EXPECT_EQ(missing_slot(topic, frame), app.id(app.appointment, "Host"));
  frame.slots[2].status = frame.slots[3].status = SlotStatus::filled;
  EXPECT_EQ(missing_slot(topic, frame), script::no_id);
}

TEST(TopicFrame, NamesItsStatusesAndOutcomes) {
  EXPECT_EQ(name_of(TopicStatus::resting), "resting");
  EXPECT_EQ(name_of(SlotOutcome::unchanged), "unchanged");
}

} // namespace

} // namespace parlour::dialogue
