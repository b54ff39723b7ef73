// Table I of the paper, row by row, with frames, topic order, queries and
// output queue alone.
#include "script/dialogue/agenda/output_queue.hpp"
#include "script/dialogue/knowledge/knowledge_query.hpp"
#include "script/dialogue/topics/classifier.hpp"
#include "script/dialogue/topics/questions.hpp"
#include "script/dialogue/topics/topic_order.hpp"
#include "tests/script/dialogue/dialogue_fixture.hpp"

namespace parlour::dialogue {

namespace {

using namespace std::chrono_literals;
using Kind = FrameChange::Kind;

class TableOne : public testing::Test {
protected:
  FrameResult change(FramePointer& frame, std::vector<FrameChange> changes) {
    auto result = app.change(*frame, std::move(changes));
    frame = result.frame;
    return result;
  }
  void status(FramePointer& frame, TopicStatus status) {
    auto to = make(Kind::status);
    to.status = status;
    change(frame, {to});
  }
  FramePointer begin(TopicId topic) {
    return std::make_shared<const TopicFrame>(app.frame(topic));
  }
  void push(OutputAct act, std::string text) {
    Output output;
    output.act = act;
    output.text = std::move(text);
    queue.push(std::move(output));
  }
  // How an enquiry ends: the answer is kept, the topic rests.
  void answer(Statement statement, Timestamp now) {
    auto answered = make(Kind::answered, script::no_id, ResultSet{});
    answered.asked = statement.asked;
    answered.relaxed = statement.relaxed;
    change(facility, {answered});
    status(facility, TopicStatus::resting);
    order.answered(app.facility, now);
  }
  std::vector<SlotId> all_but_relaxed() const {
    std::vector<SlotId> keep;
    const auto& slots = app.program.topics[app.facility].slots;
    for (SlotId slot = 0; slot < slots.size(); ++slot)
      if (std::count(facility->relaxed.begin(), facility->relaxed.end(),
                     slots[slot].name) == 0)
        keep.push_back(slot);
    return keep;
  }

  void greeting();
  void visitor_introduces_himself();
  void question_is_withdrawn();
  void visitor_asks_for_coffee();
  void visitor_asks_for_food();
  void silence();
  void visitor_gives_the_time();

  Receptionist app;
  TopicOrder order{app.program};
  OutputQueue queue;
  FramePointer appointment = begin(app.appointment);
  FramePointer facility = begin(app.facility);
  SlotId time = app.id(app.appointment, "Time");
  SlotId category = app.id(app.facility, "Category");
  SlotId location = app.id(app.facility, "Location");
};

// R1
void TableOne::greeting() {
  push(OutputAct::answer, "R1");
  EXPECT_EQ(queue.release(false).released.size(), 1u);
}

// U1: three slots of one sentence; the time is missing.
void TableOne::visitor_introduces_himself() {
  order.activate(app.appointment);
  status(appointment, TopicStatus::active);
  auto result = change(
      appointment, {fill(app.id(app.appointment, "Visitor"), "David"),
                    fill(app.id(app.appointment, "Organisation"), "Comptec"),
                    fill(app.id(app.appointment, "Host"), "Dr. Jeffery Ho")});
  EXPECT_EQ(result.reports.size(), 3u);
  EXPECT_EQ(result.missing, time);
  EXPECT_FALSE(appointment->done);
}

// Its question is withdrawn, as U2 waits; it does not count as asked.
void TableOne::question_is_withdrawn() {
  push(OutputAct::question, "What's the time of your appointment?");
  EXPECT_EQ(queue.release(true).withdrawn.size(), 1u);
  EXPECT_TRUE(queue.empty());
  EXPECT_EQ(appointment->slots[time].asked, 0u);
}

// U2: the enquiry takes over; no row on the second floor, then without it.
void TableOne::visitor_asks_for_coffee() {
  EXPECT_EQ(order.activate(app.facility), app.appointment);
  status(appointment, TopicStatus::suspended);
  auto result =
      change(facility, {make(Kind::inherit), fill(category, "coffee shop"),
                        fill(location, 2)});
  EXPECT_TRUE(result.query_slot_filled);
  KnowledgeQuery first(app.program.topics[app.facility], facility);
  EXPECT_EQ(first.first()->values, (List{"coffee shop", 2}));
  auto relaxed = first.next();
  ASSERT_TRUE(relaxed);
  EXPECT_EQ(relaxed->values, (List{"coffee shop"}));
  EXPECT_EQ(relaxed->relaxed, std::vector<std::string>{"Location"});
  answer(*relaxed, 1000);
  push(OutputAct::answer, "R2");
  EXPECT_EQ(queue.release(false).released.size(), 1u);
}

// U3, elliptical: the category replaces, the relaxed floor is dropped.
void TableOne::visitor_asks_for_food() {
  Act act;
  act.elliptical = true;
  act.slots.resize(1);
  act.slots[0].slot = "Category";
  ClassifierContext context;
  context.resting = *order.resting(2000, 2min);
  context.unfinished = order.suspended();
  EXPECT_EQ(classify(app.program, act, context), app.facility);
  order.activate(app.facility);
  auto inherit = make(Kind::inherit);
  inherit.keep = all_but_relaxed();
  change(facility, {inherit, fill(category, "food court")});
  KnowledgeQuery second(app.program.topics[app.facility], facility);
  auto statement = second.first();
  EXPECT_EQ(statement->values, (List{"food court"}));
  EXPECT_EQ(statement->asked, Value(Map{{"Category", "food court"}}));
  answer(*statement, 3000);
  EXPECT_TRUE(facility->relaxed.empty());
}

// Silence: back to the appointment, with its literal question.
void TableOne::silence() {
  const auto& topic = app.program.topics[app.appointment];
  auto next = order.next();
  ASSERT_TRUE(next);
  EXPECT_EQ(next->topic, app.appointment);
  EXPECT_TRUE(next->resumes);
  EXPECT_FALSE(order.activate(app.appointment));
  status(appointment, TopicStatus::active);
  EXPECT_EQ(question_wording(topic.slots[time], appointment->slots[time]),
            topic.slots[time].question);
  push(OutputAct::resume, "What's the time of your appointment?");
  EXPECT_EQ(queue.release(false).released.size(), 1u);
  change(appointment, {make(Kind::asked, time)});
  EXPECT_EQ(appointment->slots[time].asked, 1u);
}

// U4 completes the frame.
void TableOne::visitor_gives_the_time() {
  auto result = change(appointment, {fill(time, "10:30am")});
  EXPECT_TRUE(appointment->done);
  EXPECT_EQ(result.missing, script::no_id);
  EXPECT_EQ(appointment->slots[time].value, Value("10:30"));
  EXPECT_EQ(appointment->slots[0].value, Value("David"));
  order.completed(app.appointment);
  EXPECT_FALSE(order.next());
}

TEST_F(TableOne, RowByRow) {
  greeting();
  visitor_introduces_himself();
  question_is_withdrawn();
  visitor_asks_for_coffee();
  visitor_asks_for_food();
  silence();
  visitor_gives_the_time();
}

TEST_F(TableOne, AFloorThatWasNotRelaxedIsInherited) {
  change(facility, {make(Kind::inherit), fill(category, "coffee shop"),
                    fill(location, 1)});
  KnowledgeQuery query(app.program.topics[app.facility], facility);
  answer(*query.first(), 0);
  auto inherit = make(Kind::inherit);
  inherit.keep = all_but_relaxed();
  change(facility, {inherit, fill(category, "bank")});
  KnowledgeQuery again(app.program.topics[app.facility], facility);
  EXPECT_EQ(again.first()->values, (List{"bank", 1}));
}

} // namespace

} // namespace parlour::dialogue
