#include "script/dialogue/frame/filling_event.hpp"
#include "tests/script/dialogue/dialogue_fixture.hpp"

namespace parlour::dialogue {

namespace {

using Kind = FrameChange::Kind;

// A meeting room from Start to End, with a constraint between the two.
class Filling : public testing::Test {
protected:
  Filling() {
    topic = app.topic("Booking");
    app.slot(topic, "Name");
    app.slot(topic, "Start", "time");
    app.slot(topic, "End", "time");
    app.slot(topic, "Host", "query", false);
    frame = app.frame(topic);
  }

  void constrain(FakeBody condition, std::string message = "") {
    script::Constraint constraint;
    constraint.condition = app.code(std::move(condition));
    if (!message.empty())
      constraint.message = app.text(message);
    app.program.topics[topic].constraints.push_back(constraint);
  }

  FrameResult change(std::vector<FrameChange> changes) {
    auto result = app.change(frame, std::move(changes));
    frame = *result.frame;
    return result;
  }
  const SlotState& slot(SlotId id) const {
    return frame.slots[id];
  }
  static List ordered(const FrameResult& result) {
    List outcomes;
    for (const auto& report : result.reports)
      outcomes.emplace_back(name_of(report.outcome));
    return outcomes;
  }

  Application app;
  TopicId topic = 0;
  TopicFrame frame;
  static constexpr SlotId name = 0, start = 1, end = 2, host = 3;
};

Expected<Value> end_after_start(const SlotReader& read) {
  auto from = read("Start"), to = read("End");
  return Value(!from.is_unknown() && !to.is_unknown() &&
               from.text() < to.text());
}

FrameChange words(SlotId slot, std::string text) {
  auto change = fill(slot, {});
  change.text = std::move(text);
  change.unmatched = true;
  return change;
}

TEST_F(Filling, ADifferenceMovesTheTimeThatIsThere) {
  change({fill(start, "15:00")});
  EXPECT_EQ(ordered(change({fill(start, "-00:30")})), (List{"corrected"}));
  EXPECT_EQ(slot(start).value, Value("14:30"));
  EXPECT_EQ(ordered(change({fill(end, "+01:00")})), (List{"refused"}));
}

TEST_F(Filling, AValueIsAccepted) {
  auto result = change({fill(name, "David")});
  ASSERT_EQ(ordered(result), (List{"accepted"}));
  EXPECT_EQ(slot(name).value, Value("David"));
  EXPECT_EQ(slot(name).status, SlotStatus::filled);
  EXPECT_FALSE(slot(name).implicit);
  EXPECT_EQ(result.missing, start);
}

TEST_F(Filling, ReportsComeInSlotOrder) {
  auto result = change({fill(end, "11:00"), fill(name, "David")});
  ASSERT_EQ(result.reports.size(), 2u);
  EXPECT_EQ(result.reports[0].slot, name);
  EXPECT_EQ(result.reports[1].slot, end);
}

TEST_F(Filling, ARefusedValueLeavesTheOldOne) {
  change({fill(start, "10:00")});
  auto result = change({fill(start, "whenever")});
  ASSERT_EQ(ordered(result), (List{"refused"}));
  EXPECT_EQ(result.reports[0].offered, Value("whenever"));
  EXPECT_EQ(result.reports[0].before, Value("10:00"));
  EXPECT_EQ(result.reports[0].reason, "");
  EXPECT_EQ(slot(start).value, Value("10:00"));
  EXPECT_EQ(slot(start).status, SlotStatus::filled);
}

TEST_F(Filling, WordsThatMatchNothingAreRefused) {
  auto result = change({words(host, "Mister Nobody")});
  ASSERT_EQ(ordered(result), (List{"refused"}));
  EXPECT_EQ(result.reports[0].offered, Value("Mister Nobody"));
  EXPECT_EQ(slot(host).status, SlotStatus::empty);
}

TEST_F(Filling, AnotherValueCorrectsTheSameChangesNothing) {
  change({fill(start, "10:00")});
  auto result = change({fill(start, "11am")});
  EXPECT_EQ(ordered(result), (List{"corrected"}));
  EXPECT_EQ(result.reports[0].before, Value("10:00"));
  EXPECT_EQ(ordered(change({fill(start, "11:00")})), (List{"unchanged"}));
  EXPECT_EQ(slot(start).value, Value("11:00"));
}

TEST_F(Filling, ACorrectionStandsAgainstWhatItMends) {
  auto result =
      change({make(Kind::correct, start, "16:00"), fill(start, "15:00")});
  EXPECT_EQ(ordered(result), (List{"accepted"}));
  EXPECT_EQ(slot(start).value, Value("16:00"));
}

TEST_F(Filling, ASlipIsMendedInTheSameBreath) {
  change({fill(start, "15:00"), make(Kind::correct, start, "16:00")});
  EXPECT_EQ(slot(start).value, Value("16:00"));
}

TEST_F(Filling, ADenialEmptiesTheSlotThatHoldsIt) {
  change({fill(start, "15:00")});
  EXPECT_TRUE(change({make(Kind::deny, start, "14:00")}).reports.empty());
  EXPECT_EQ(slot(start).value, Value("15:00"));
  auto result = change({make(Kind::deny, start, "3pm")});
  EXPECT_EQ(ordered(result), (List{"cleared"}));
  EXPECT_EQ(slot(start).status, SlotStatus::empty);
}

TEST_F(Filling, ADenialWithAnotherValueReplaces) {
  change({fill(start, "15:00")});
  auto result =
      change({make(Kind::deny, start, "15:00"), fill(start, "16:00")});
  ASSERT_EQ(result.reports.size(), 1u);
  EXPECT_EQ(result.reports[0].before, Value("15:00"));
  EXPECT_EQ(slot(start).value, Value("16:00"));
}

TEST_F(Filling, ADenialTakesBackWhatWasSaidBefore) {
  change({fill(start, "15:00"), make(Kind::deny, start, "15:00")});
  EXPECT_EQ(slot(start).status, SlotStatus::empty);
}

TEST_F(Filling, AConstraintIsNotJudgedBeforeItsSlotsAreThere) {
  constrain(end_after_start, "The end must be after the start.");
  EXPECT_EQ(ordered(change({fill(start, "10:00")})), (List{"accepted"}));
  EXPECT_EQ(ordered(change({fill(end, "11:00")})), (List{"accepted"}));
}

TEST_F(Filling, AFailingConstraintRefusesWhatItReads) {
  constrain(end_after_start, "The end must be after the start.");
  change({fill(start, "10:00")});
  auto result = change({fill(name, "David"), fill(end, "09:00")});
  ASSERT_EQ(ordered(result), (List{"accepted", "refused"}));
  EXPECT_EQ(result.reports[1].reason, "The end must be after the start.");
  EXPECT_EQ(result.reports[1].offered, Value("09:00"));
  EXPECT_EQ(slot(end).status, SlotStatus::empty);
  EXPECT_EQ(slot(start).value, Value("10:00"));
}

TEST_F(Filling, AFailingConstraintRefusesBothOfOneEvent) {
  constrain(end_after_start);
  auto result = change({fill(start, "10:00"), fill(end, "09:00")});
  EXPECT_EQ(ordered(result), (List{"refused", "refused"}));
  EXPECT_EQ(slot(start).status, SlotStatus::empty);
}

TEST_F(Filling, AConstraintBringsTheOldValueBack) {
  constrain(end_after_start);
  change({fill(start, "10:00"), fill(end, "11:00")});
  EXPECT_EQ(ordered(change({fill(end, "09:00")})), (List{"refused"}));
  EXPECT_EQ(slot(end).value, Value("11:00"));
}

TEST_F(Filling, AConstraintThatReadsNoSlotRefusesAll) {
  constrain([](const SlotReader&) { return Value(false); }, "Closed.");
  auto result = change({fill(name, "David"), fill(start, "10:00")});
  EXPECT_EQ(ordered(result), (List{"refused", "refused"}));
  EXPECT_EQ(result.reports[0].reason, "Closed.");
}

TEST_F(Filling, EachConstraintIsEvaluatedOnce) {
  int times = 0;
  constrain([&](const SlotReader& read) {
    ++times;
    return Value(!read("Name").is_unknown());
  });
  change({fill(name, "David"), fill(start, "10:00"), fill(end, "11:00")});
  EXPECT_EQ(times, 1);
}

TEST_F(Filling, AnErrorOfAConstraintFailsAndIsReported) {
  constrain([](const SlotReader& read) -> Expected<Value> {
    read("Name");
    return fail(ErrorKind::type, "'-' takes numbers");
  });
  auto result = change({fill(name, "David"), fill(start, "10:00")});
  EXPECT_EQ(ordered(result), (List{"refused", "accepted"}));
  ASSERT_EQ(result.errors.size(), 1u);
  EXPECT_EQ(result.errors[0].message, "'-' takes numbers");
}

TEST_F(Filling, TooUncertainCountsAsNotSaid) {
  constrain(end_after_start);
  auto result = change({fill(start, "10:00"), fill(end, "09:00", 0.3)});
  EXPECT_EQ(ordered(result), (List{"accepted", "rejected"}));
  EXPECT_EQ(slot(end).status, SlotStatus::empty);
  EXPECT_EQ(slot(start).value, Value("10:00"));
}

TEST_F(Filling, AnUncertainValueMustBeConfirmed) {
  auto result = change({fill(name, "David", 0.5)});
  EXPECT_EQ(ordered(result), (List{"unconfirmed"}));
  EXPECT_EQ(slot(name).status, SlotStatus::unconfirmed);
  EXPECT_EQ(slot(name).value, Value("David"));
  EXPECT_EQ(result.missing, name);
}

TEST_F(Filling, ToSayItAgainIsToSayYes) {
  change({fill(name, "David", 0.5)});
  EXPECT_EQ(ordered(change({fill(name, "David", 0.5)})), (List{"accepted"}));
  EXPECT_EQ(slot(name).status, SlotStatus::filled);
}

TEST_F(Filling, ToSayWhatOnlySoundsLikeItIsToSayNothing) {
  auto heard = fill(name, "David", 0.6);
  heard.heard = true;
  change({heard});
  EXPECT_EQ(ordered(change({heard})), (List{"unconfirmed"}));
  EXPECT_EQ(slot(name).status, SlotStatus::unconfirmed);
  EXPECT_EQ(ordered(change({fill(name, "David", 0.6)})), (List{"accepted"}));
}

TEST_F(Filling, AFairlySureValueIsMarked) {
  change({fill(name, "David", 0.8), fill(start, "10:00", Value())});
  EXPECT_TRUE(slot(name).implicit);
  EXPECT_TRUE(slot(start).implicit);
  EXPECT_EQ(slot(name).status, SlotStatus::filled);
}

TEST_F(Filling, ExplicitAlwaysAsksNeverNever) {
  app.program.topics[topic].slots[name].confirm =
      script::ConfirmPolicy::explicitly;
  app.program.topics[topic].slots[start].confirm = script::ConfirmPolicy::never;
  auto result = change({fill(name, "David", 1.0), fill(start, "10:00", 0.1)});
  EXPECT_EQ(ordered(result), (List{"unconfirmed", "accepted"}));
  EXPECT_FALSE(slot(start).implicit);
}

TEST_F(Filling, CandidatesMakeItAmbiguous) {
  auto both = fill(host, {});
  both.candidates = {"Tan Ah Kow", "Tan Bee Hoon"};
  EXPECT_EQ(ordered(change({both})), (List{"ambiguous"}));
  EXPECT_EQ(slot(host).status, SlotStatus::ambiguous);
  EXPECT_EQ(slot(host).candidates, both.candidates);
  EXPECT_TRUE(slot(host).value.is_unknown());
  EXPECT_EQ(ordered(change({words(host, "bee hoon")})), (List{"accepted"}));
  EXPECT_EQ(slot(host).value, Value("Tan Bee Hoon"));
  EXPECT_TRUE(slot(host).candidates.empty());
}

TEST_F(Filling, TheOtherOfTwoIsMeantWhenOneIsDenied) {
  auto both = fill(host, {});
  both.candidates = {"Tan Ah Kow", "Tan Bee Hoon"};
  change({both});
  change({make(Kind::deny, host, "Tan Ah Kow")});
  EXPECT_EQ(slot(host).value, Value("Tan Bee Hoon"));
}

TEST_F(Filling, APartOfANameDeniesTheOneThatHasIt) {
  auto both = fill(host, {});
  both.candidates = {"Tan Ah Kow", "Tan Bee Hoon"};
  change({both});
  change({make(Kind::deny, host, "Tan")}); // both have it: which is not told
  EXPECT_EQ(slot(host).candidates.size(), 2u);
  change({make(Kind::deny, host, "Ah Kow")});
  EXPECT_EQ(slot(host).value, Value("Tan Bee Hoon"));
}

TEST_F(Filling, AnAnswerOverADefaultIsNoCorrection) {
  app.program.topics[topic].slots[start].initial = app.text("09:00");
  frame = app.frame(topic);
  auto result = change({fill(start, "10:00")});
  EXPECT_EQ(ordered(result), (List{"accepted"}));
  EXPECT_FALSE(slot(start).by_default);
}

TEST_F(Filling, SlotsThatDoNotExistAreNothing) {
  EXPECT_TRUE(
      change({fill(99, "x"), fill(script::no_id, "x")}).reports.empty());
}

} // namespace

} // namespace parlour::dialogue
