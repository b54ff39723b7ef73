#include "actors/support/actor_trace.hpp"
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {
namespace {

class ActorTraceTest : public NodeFixture {
protected:
  ActorTraceTest() {
    watch = [this](const Inspection& seen) {
      if (seen.kind == InspectionKind::actor)
        taken.push_back(seen.subject + ": " + seen.detail);
    };
  }

  ~ActorTraceTest() override {
    node.reset(); // which still shows what it does
  }

  std::vector<std::string> taken;
};

TEST_F(ActorTraceTest, ShowsWhatActorsOfAKindTake) {
  options.trace_actors = {"session"};
  start(echo);
  say({"hello"});
  const auto id = node->session_at(seat);
  EXPECT_THAT(taken, testing::IsSupersetOf(
                         {"session " + id + ": begin_session",
                          "session " + id +
                              ": deliver ASR.RecognitionResult(hello, 1)"}));
  for (const auto& one : taken)
    EXPECT_THAT(one, testing::StartsWith("session "));
}

TEST_F(ActorTraceTest, ShowsWhatAComponentTakesByItsName) {
  options.trace_actors = {"Ear"};
  options.components = {answering("Ear", "KeywordSpotter", "Keyword"),
                        answering("Phone", "Telephone", "Rings")};
  start(R"(<handler name="Pipeline"><messages><component>
    <ASR><RecognitionResult>
      <post module="KeywordSpotter" command="Process" param="_LPARAM1"/>
      <post module="Telephone" command="Call" param="_LPARAM1"/>
    </RecognitionResult></ASR></component></messages></handler>)");
  say({"hello"});
  EXPECT_THAT(taken, testing::Contains(testing::AllOf(
                         testing::StartsWith("component_host Ear: message "),
                         HasSubstr("Script.Process(hello)"))));
  EXPECT_THAT(taken, testing::Each(HasSubstr("Ear")));
}

// One that is called in the session's own turn is no actor.
TEST_F(ActorTraceTest, ShowsWhatAnInlineComponentTakes) {
  options.trace_actors = {"City"};
  options.components = {
      inline_component("City", "Taxi", [](const Message& message) {
        return std::vector<Answer>{{"Booked", message.params}};
      })};
  start(R"(<handler name="Pipeline"><messages><component>
    <ASR><RecognitionResult>
      <post module="Taxi" command="Book" param="_LPARAM1"/>
    </RecognitionResult></ASR></component></messages></handler>)");
  say({"home"});
  EXPECT_THAT(taken, testing::Contains(testing::AllOf(
                         testing::StartsWith("inline City: message "),
                         HasSubstr("Script.Book(home)"))));
}

TEST_F(ActorTraceTest, MasksWhatIsPrivate) {
  options.trace_actors = {"session", "message_centre", "Ear"};
  options.components = {answering("Ear", "KeywordSpotter", "Keyword")};
  start(R"(<var name="pin" private="true"/>
    <handler name="Pipeline"><messages><component><ASR><RecognitionResult>
      <set name="pin" expr="_LPARAM1"/>
      <post module="KeywordSpotter" command="Process" param="pin"/>
    </RecognitionResult></ASR></component></messages></handler>)");
  say({"4711"});
  EXPECT_THAT(taken, testing::Contains(HasSubstr("deliver")));
  EXPECT_THAT(taken, testing::Each(testing::Not(HasSubstr("4711"))));
}

TEST_F(ActorTraceTest, ShowsNothingUnasked) {
  start(echo);
  say({"hello"});
  EXPECT_THAT(taken, IsEmpty());
}

} // namespace
} // namespace parlour::actors
