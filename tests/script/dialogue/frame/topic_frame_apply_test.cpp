// Applying a whole request to a frame: all changes but filling
// (filling_event_test), and what the result reports.
#include "tests/script/dialogue/dialogue_fixture.hpp"

namespace parlour::dialogue {

namespace {

using Kind = FrameChange::Kind;

class Apply : public testing::Test {
protected:
  FrameResult change(std::vector<FrameChange> changes) {
    auto result = app.change(frame, std::move(changes));
    frame = *result.frame;
    return result;
  }
  FrameResult change(Kind kind, SlotId slot = script::no_id, Value value = {}) {
    return change({make(kind, slot, std::move(value))});
  }
  FrameResult status(TopicStatus status) {
    auto to = make(Kind::status);
    to.status = status;
    return change({to});
  }
  static std::string outcome(const FrameResult& result) {
    return result.reports.size() == 1
               ? std::string(name_of(result.reports[0].outcome))
               : std::to_string(result.reports.size()) + " reports";
  }

  Receptionist app;
  TopicFrame frame = app.frame(app.taxi);
  static constexpr SlotId place = 0, time = 1;
};

TEST_F(Apply, DoneWhenAllFunctionalSlotsAreAccepted) {
  EXPECT_FALSE(change({fill(place, "Marina")}).frame->done);
  EXPECT_FALSE(change({fill(time, "10:00", 0.5)}).frame->done);
  auto result = change(Kind::confirmed, time);
  EXPECT_EQ(outcome(result), "accepted");
  EXPECT_TRUE(result.frame->done);
  EXPECT_EQ(result.missing, script::no_id);
  EXPECT_FALSE(change(Kind::clear, place).frame->done);
}

TEST_F(Apply, ATopicWithoutFunctionalSlotsIsDoneOnceItIsActive) {
  auto hello = app.topic("Hello");
  frame = app.frame(hello);
  EXPECT_FALSE(frame.done);
  EXPECT_FALSE(change({}).frame->done);
  EXPECT_TRUE(status(TopicStatus::active).frame->done);
}

TEST_F(Apply, DefaultsCountAsAcceptedWhenTheTopicIsActive) {
  for (auto& slot : app.program.topics[app.taxi].slots)
    slot.initial = app.text("10:00");
  frame = app.frame(app.taxi);
  EXPECT_FALSE(change({}).frame->done);
  EXPECT_TRUE(status(TopicStatus::active).frame->done);
}

TEST_F(Apply, AYesAcceptsAndANoTakesBack) {
  change({fill(place, "Marina", 0.5)});
  EXPECT_EQ(outcome(change(Kind::disconfirmed, place)), "cleared");
  EXPECT_EQ(frame.slots[place].status, SlotStatus::empty);
  change({fill(place, "Marina")});
  change({fill(place, "Changi", 0.5)});
  EXPECT_EQ(frame.slots[place].value, Value("Changi"));
  auto result = change(Kind::disconfirmed, place);
  EXPECT_EQ(outcome(result), "cleared");
  EXPECT_EQ(frame.slots[place].value, Value("Marina"));
  EXPECT_EQ(frame.slots[place].status, SlotStatus::filled);
  change({fill(place, "Changi", 0.5)});
  EXPECT_EQ(outcome(change(Kind::confirmed, place)), "corrected");
  EXPECT_EQ(frame.slots[place].value, Value("Changi"));
}

TEST_F(Apply, AYesToNothingIsNothing) {
  change({fill(place, "Marina")});
  EXPECT_EQ(outcome(change(Kind::confirmed, place)), "0 reports");
  EXPECT_EQ(outcome(change(Kind::disconfirmed, place)), "0 reports");
  EXPECT_EQ(frame.slots[place].value, Value("Marina"));
}

TEST_F(Apply, AYesWithMoreIsOneEvent) {
  change({fill(place, "Marina", 0.5)});
  auto result = change({make(Kind::confirmed, place), fill(time, "10:00")});
  ASSERT_EQ(result.reports.size(), 2u);
  EXPECT_TRUE(result.frame->done);
}

TEST_F(Apply, AScriptSetsAsItLikes) {
  EXPECT_EQ(outcome(change(Kind::set, time, "half past never")), "accepted");
  EXPECT_EQ(frame.slots[time].value, Value("half past never"));
  EXPECT_EQ(frame.slots[time].status, SlotStatus::filled);
  EXPECT_EQ(outcome(change(Kind::set, time, "soon")), "corrected");
  EXPECT_EQ(outcome(change(Kind::set, time, {})), "cleared");
  EXPECT_EQ(frame.slots[time].status, SlotStatus::empty);
}

TEST_F(Apply, CountsQuestionsAndFailures) {
  change({make(Kind::asked, time), make(Kind::asked, time),
          make(Kind::no_input, time), make(Kind::no_match, time)});
  EXPECT_EQ(frame.slots[time].asked, 2u);
  EXPECT_EQ(frame.slots[time].no_input, 1u);
  EXPECT_EQ(frame.slots[time].no_match, 1u);
  change({fill(time, "10:00")});
  EXPECT_EQ(frame.slots[time].asked, 2u); // the wordings go on rotating
  EXPECT_EQ(frame.slots[time].no_input, 0u);
  EXPECT_EQ(frame.slots[time].no_match, 0u);
}

TEST_F(Apply, ResetBeginsAnew) {
  app.program.topics[app.taxi].slots[place].initial = app.text("Airport");
  frame = app.frame(app.taxi);
  status(TopicStatus::active);
  change({fill(place, "Marina"), fill(time, "10:00")});
  ASSERT_TRUE(frame.done);
  change(Kind::reset);
  EXPECT_EQ(frame.status, TopicStatus::untouched);
  EXPECT_FALSE(frame.done);
  EXPECT_EQ(frame.slots[place].value, Value("Airport"));
  EXPECT_EQ(frame.slots[time].status, SlotStatus::empty);
}

TEST_F(Apply, EchoedTakesTheMarksAway) {
  change({fill(place, "Marina", 0.8), fill(time, "10:00", 0.8)});
  change(Kind::echoed, place);
  EXPECT_FALSE(frame.slots[place].implicit);
  EXPECT_TRUE(frame.slots[time].implicit);
  change(Kind::echoed);
  EXPECT_FALSE(frame.slots[time].implicit);
}

TEST_F(Apply, AnAnswerIsKeptWithTheFrame) {
  auto answered = make(Kind::answered, script::no_id, ResultSet{{"a"}, {1}});
  answered.asked = Map{{"Category", "bank"}};
  answered.relaxed = {"Location"};
  change({answered});
  EXPECT_EQ(frame.rows, answered.value);
  EXPECT_EQ(frame.asked, answered.asked);
  EXPECT_EQ(frame.relaxed, answered.relaxed);
}

class ApplyToEnquiry : public Apply {
protected:
  ApplyToEnquiry() {
    frame = app.frame(app.facility);
    change({fill(category, "coffee shop"), fill(location, 2)});
  }
  static FrameChange inherit(std::vector<SlotId> keep) {
    auto change = make(Kind::inherit);
    change.keep = std::move(keep);
    return change;
  }
  static constexpr SlotId category = 0, location = 1;
};

TEST_F(ApplyToEnquiry, InheritKeepsWhatItNames) {
  auto result = change({inherit({category}), fill(category, "food court")});
  EXPECT_EQ(frame.slots[category].value, Value("food court"));
  EXPECT_EQ(frame.slots[location].status, SlotStatus::empty);
  ASSERT_EQ(result.reports.size(), 2u);
  EXPECT_EQ(result.reports[0].outcome, SlotOutcome::corrected);
  EXPECT_EQ(result.reports[1].outcome, SlotOutcome::cleared);
  EXPECT_TRUE(result.query_slot_filled);
}

TEST_F(ApplyToEnquiry, AFullRequestBeginsEmpty) {
  auto result = change({inherit({}), fill(location, 3)});
  EXPECT_EQ(frame.slots[category].status, SlotStatus::empty);
  EXPECT_EQ(frame.slots[location].value, Value(3));
  EXPECT_TRUE(result.query_slot_filled);
  EXPECT_EQ(result.reports[1].before, Value(2));
}

TEST_F(ApplyToEnquiry, TheSameQuestionAgainIsAQuestion) {
  EXPECT_TRUE(change({fill(category, "coffee shop")}).query_slot_filled);
}

TEST_F(ApplyToEnquiry, AnEventThatFillsNoQuerySlotAsksNothing) {
  app.slot(app.facility, "Politeness", "", false);
  frame = app.frame(app.facility);
  EXPECT_FALSE(change({fill(2, "please")}).query_slot_filled);
  EXPECT_FALSE(change({fill(location, "upstairs")}).query_slot_filled);
  EXPECT_FALSE(change({fill(location, 3, 0.5)}).query_slot_filled);
  EXPECT_TRUE(change(Kind::confirmed, location).query_slot_filled);
}

TEST_F(Apply, TheGivenFrameStaysAsItWas) {
  const auto before = frame;
  app.change(before, {fill(place, "Marina")});
  EXPECT_EQ(before.slots[place].status, SlotStatus::empty);
}

TEST_F(Apply, SlotsThatDoNotExistAreNothing) {
  for (auto kind : {Kind::set, Kind::clear, Kind::confirmed, Kind::asked})
    EXPECT_TRUE(change(kind, 99, "x").reports.empty());
}

} // namespace

} // namespace parlour::dialogue
