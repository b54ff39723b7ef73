#include <array>

#include "script/dialogue/topics/classifier.hpp"
#include "tests/script/dialogue/dialogue_fixture.hpp"

namespace parlour::dialogue {

namespace {

class Classifier : public testing::Test {
protected:
  static Act act(std::vector<std::string> slots, std::string topic = "") {
    Act act;
    act.topic = std::move(topic);
    for (auto& name : slots) {
      SlotValue value;
      value.slot = std::move(name);
      value.value = "x";
      act.slots.push_back(std::move(value));
    }
    return act;
  }
  TopicId of(const Act& act) const {
    return classify(app.program, act, context);
  }

  Receptionist app;
  ClassifierContext context;
};

TEST_F(Classifier, TheNamedTopicStands) {
  context.current = app.appointment;
  EXPECT_EQ(of(act({"Time"}, "Taxi")), app.taxi);
}

TEST_F(Classifier, AReadingOfUnknownValuesDoesNotStandBesideAnother) {
  auto known = act({"Time"}, "Taxi");
  known.confidence = 0.7;
  auto vain = act({"Host"}, "Appointment");
  vain.confidence = 0.75;
  vain.slots[0].unmatched = true;
  auto said = known;
  said.alternatives = {vain};
  prefer_known(said);
  EXPECT_EQ(said.topic, "Taxi");
  EXPECT_TRUE(said.alternatives.empty());
  said = vain;
  said.text = "at three";
  said.alternatives = {known, vain};
  prefer_known(said);
  EXPECT_EQ(said.topic, "Taxi");
  EXPECT_EQ(said.text, "at three");
  EXPECT_TRUE(said.alternatives.empty());
  // Nothing else is near.
  known.confidence = 0.6;
  said = vain;
  said.alternatives = {known};
  prefer_known(said);
  EXPECT_EQ(said.topic, "Appointment");
  EXPECT_EQ(said.alternatives.size(), 1U);
}

TEST_F(Classifier, AnUnknownOrUnregisteredNameIsNoName) {
  context.current = app.appointment;
  EXPECT_EQ(of(act({"Time"}, "Weather")), app.appointment);
  context.unregistered = {app.taxi};
  EXPECT_EQ(of(act({"Time"}, "Taxi")), app.appointment);
  EXPECT_EQ(of(act({"Destination"}, "Taxi")), script::no_id);
}

TEST_F(Classifier, PreferenceDecidesBetweenTopicsWithTheSlot) {
  EXPECT_EQ(of(act({"Time"})), app.appointment); // file order
  context.completed = app.taxi;
  EXPECT_EQ(of(act({"Time"})), app.taxi);
  const std::array suspended{app.appointment};
  context.unfinished = suspended;
  EXPECT_EQ(of(act({"Time"})), app.appointment);
  const std::array unfinished{app.taxi};
  context.unfinished = unfinished;
  EXPECT_EQ(of(act({"Time"})), app.taxi);
  context.current = app.appointment;
  EXPECT_EQ(of(act({"Time"})), app.appointment);
  context.asked = app.taxi;
  EXPECT_EQ(of(act({"Time"})), app.taxi);
}

TEST_F(Classifier, WhatIsSaidInPassingIsAboutWhatRests) {
  auto passing = act({"Time"}, "Appointment");
  passing.elliptical = true;
  passing.confidence = 1;
  passing.alternatives = {act({"Location"}, "Facility")};
  passing.alternatives[0].confidence = 0.95;
  auto nothing_rests = passing;
  prefer_resting(app.program, nothing_rests, context);
  EXPECT_EQ(nothing_rests.topic, "Appointment");
  context.resting = app.facility;
  auto full = passing;
  full.elliptical = false;
  prefer_resting(app.program, full, context);
  EXPECT_EQ(full.topic, "Appointment");
  auto far = passing;
  far.alternatives[0].confidence = 0.8;
  prefer_resting(app.program, far, context);
  EXPECT_EQ(far.topic, "Appointment");
  auto asked = passing;
  context.asked = app.appointment;
  prefer_resting(app.program, asked, context);
  EXPECT_EQ(asked.topic, "Appointment");
  context.asked = script::no_id;
  prefer_resting(app.program, passing, context);
  EXPECT_EQ(passing.topic, "Facility");
  EXPECT_TRUE(clarify(app.program, passing, context).empty());
}

TEST_F(Classifier, MoreOfTheSlotsWin) {
  context.asked = app.taxi;
  EXPECT_EQ(of(act({"Time", "Host"})), app.appointment);
}

TEST_F(Classifier, ARestingEnquiryTakesItsSlots) {
  context.current = app.appointment;
  context.resting = app.facility;
  EXPECT_EQ(of(act({"Category"})), app.facility);
}

TEST_F(Classifier, NothingFits) {
  EXPECT_EQ(of(act({"Colour"})), script::no_id);
  EXPECT_EQ(of(act({})), script::no_id);
}

TEST_F(Classifier, WithoutSlotsTheAskedOrAnEllipsis) {
  context.current = app.appointment;
  context.resting = app.facility;
  EXPECT_EQ(of(act({})), script::no_id);
  auto elliptical = act({});
  elliptical.elliptical = true;
  EXPECT_EQ(of(elliptical), app.facility);
  context.asked = app.taxi;
  EXPECT_EQ(of(act({})), app.taxi);
}

TEST_F(Classifier, ClarifiesOnlyBetweenNearAlternatives) {
  auto best = act({}, "Taxi");
  best.confidence = 0.7;
  EXPECT_TRUE(clarify(app.program, best, context).empty());
  auto near = act({}, "Appointment");
  near.confidence = 0.6;
  auto far = act({}, "Facility");
  far.confidence = 0.5;
  best.alternatives = {near, far, best};
  EXPECT_EQ(clarify(app.program, best, context),
            (std::vector{app.taxi, app.appointment}));
  best.alternatives = {far};
  EXPECT_TRUE(clarify(app.program, best, context).empty());
  best.confidence = {};
  best.alternatives = {near};
  EXPECT_TRUE(clarify(app.program, best, context).empty());
}

} // namespace

} // namespace parlour::dialogue
