// What scripts want of the world: messages, requests, timers, databases,
// questions (language rules 11 and 12, engine rule 2).
#include <gtest/gtest.h>

#include "script/dialogue/engine/effect_handler.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

// A bell whose event "Rings" runs the statements.
struct Bell : World {
  explicit Bell(const std::string& statements, const std::string& more = "",
                const WorldOptions& options = {})
      : World("<handler name='H'><messages><component><Bell><Rings>" +
                  statements +
                  "</Rings></Bell></component></messages></handler>" + more,
              options) {
    components["Bell"] = {};
    components["Exchange"] = {"Telephone"};
    said();
  }
  void ring(std::vector<Value> params = {}) {
    event("Bell", "Rings", std::move(params));
  }
};

constexpr const char* call = R"xml(
  <try><request module="Telephone" command="Call" param="123" return="r"
    timeout="3s"/><speak param="{r.command} {r.params}"/>
  <catch name="e"><speak param="{e.kind}: {e.message}"/></catch></try>)xml";

TEST(EffectHandler, ARequestTakesItsReply) {
  Bell world(call);
  world.ring();
  EXPECT_EQ(world.posted(), Texts{"Telephone.Call(123)"});
  EXPECT_TRUE(world.conversation->waits_for_answer());
  const auto number = world.messages.back().correlation;
  world.event("Exchange", "Ringing", {}, number); // ends nothing
  world.event("Exchange", "Answered", {"yes"}, number);
  EXPECT_EQ(world.said(), Texts{"Answered [yes]"});
  EXPECT_FALSE(world.conversation->waits_for_answer());
}

TEST(EffectHandler, ARequestRefused) {
  World world(R"xml(<handler name="H"><messages><component><Bell><Rings>
    <try><request module="Taxi" command="Book" param="" return="r"/>
    <catch name="e"><speak param="{e.kind}: {e.message}"/></catch></try>
    </Rings></Bell></component></messages></handler>)xml");
  world.components["Cabs"] = {"Taxi"};
  world.event("Bell", "Rings");
  world.event("Cabs", "Refused", {"no car"}, world.messages.back().correlation);
  EXPECT_EQ(world.said(), Texts{"Refused: Cabs: no car"});
}

// What a plug-in says of its own events counts, where its role says nothing.
TEST(EffectHandler, ARequestHearsOfOwnEventsWhatTheyMean) {
  Bell world(call, R"xml(<handler name="Hold"><messages><component>
    <Exchange><Held><speak param="Held for {_LPARAM1}."/></Held></Exchange>
    </component></messages></handler>)xml");
  world.own_events = {{"Held", "seconds", Reply::none},
                      {"Forwarded", "number", Reply::answer},
                      {"Barred", "reason", Reply::refusal}};
  const auto answer = [&](const char* command, Value value) {
    world.event("Exchange", command, {std::move(value)},
                world.messages.back().correlation);
    return world.said();
  };
  world.ring();
  EXPECT_EQ(answer("Held", 3), Texts{"Held for 3."});
  EXPECT_TRUE(world.conversation->waits_for_answer());
  EXPECT_EQ(answer("Forwarded", 7), Texts{"Forwarded [7]"});
  world.ring();
  EXPECT_EQ(answer("Barred", "no credit"),
            Texts{"Refused: Exchange: no credit"});
  world.ring();
  EXPECT_EQ(answer("Undescribed", 1), Texts{"Undescribed [1]"});
}

TEST(EffectHandler, ARequestTooLate) {
  Bell world(call);
  world.ring();
  world.advance(2999ms);
  EXPECT_EQ(world.said(), Texts{});
  world.advance(1ms);
  EXPECT_EQ(world.said(), Texts{"Timeout: no reply came in time"});
  world.event("Exchange", "Answered", {}, world.messages.back().correlation);
  EXPECT_EQ(world.said(), Texts{}); // an event like any other
  EXPECT_EQ(world.seen(InspectionKind::unhandled).size(), 1u);
}

TEST(EffectHandler, ARequestToNobody) {
  Bell world(call);
  world.components.erase("Exchange");
  world.ring();
  auto said = world.said();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0].rfind("Offline: ", 0), 0u);
}

TEST(EffectHandler, ARequestAnsweredInline) {
  Bell world(call);
  world.answers = [](const Message& asked) {
    Message reply;
    reply.source = "Exchange";
    reply.command = "Answered";
    reply.correlation = asked.correlation;
    return std::vector<Message>{reply};
  };
  world.ring();
  EXPECT_EQ(world.said(), Texts{"Answered []"});
  EXPECT_EQ(world.timers(), 1u); // the session's last only
}

TEST(EffectHandler, PostForwardsTheParameters) {
  Bell world("<post module='Telephone' command='Call'/>");
  world.ring({"a", 2});
  EXPECT_EQ(world.posted(), Texts{"Telephone.Call(a, 2)"});
}

TEST(EffectHandler, TimersRepeatUntilCancelledAndKeepTheirLocals) {
  Bell world(R"xml(<if cond="_LPARAM1 == 'stop'"><cancel timer="tick"/>
    <else><var name="n" expr="_LPARAM1"/>
    <timer name="tick" after="1s" repeat="true"><speak param="Tick {n}."/>
    </timer><set name="n" expr="0"/></else></if>)xml");
  world.ring({7});
  world.advance(2500ms);
  EXPECT_EQ(world.said(), (Texts{"Tick 7.", "Tick 7."}));
  world.ring({"stop"});
  world.advance(5s);
  EXPECT_EQ(world.said(), Texts{});
}

TEST(EffectHandler, WaitGoesOnAfterAWhile) {
  Bell world("<speak param='One.'/><wait for='1s'/><speak param='Two.'/>");
  world.ring();
  EXPECT_EQ(world.said(), Texts{"One."});
  world.advance(1s);
  EXPECT_EQ(world.said(), Texts{"Two."});
}

TEST(EffectHandler, WhatIsAskedForHappensAtTheWait) {
  Bell world("<activate topic='T'/><wait for='1s'/><speak param='After.'/>",
             "<topic name='T'><slot name='S' type='Functional' question='S?'/>"
             "</topic>");
  world.ring();
  EXPECT_EQ(world.said(), Texts{"S?"});
  world.advance(1s);
  EXPECT_EQ(world.said(), Texts{"After."});
}

TEST(EffectHandler, AWaitInATopicHoldsNothingElse) {
  Bell world("<speak param='Bell.'/>", R"xml(
    <topic name="T"><slot name="S" type="Functional" question="S?">
      <filled><activate topic="U"/><wait for="1s"/><speak param="Waited."/>
      </filled></slot></topic>
    <topic name="U"><slot name="R" type="Functional" question="R?"/></topic>
    )xml");
  world.say(inform("T", {{"S", 1}}));
  world.say(inform("U", {{"R", 1}}));
  EXPECT_EQ(world.slot("U", "R"), 1);
  world.ring();
  EXPECT_EQ(world.said(), (Texts{"R?", "Bell."}));
  world.advance(1s);
  EXPECT_EQ(world.said().front(), "Waited.");
}

TEST(EffectHandler, QueriesGiveRows) {
  Bell world("<querydb param=\"select name from staff where id = ?\" args='3' "
             "return='r'/><speak param='{r[0]}'/>");
  world.database = [](const QueryRequest& request) -> Expected<ResultSet> {
    EXPECT_EQ(request.values, List{3});
    EXPECT_FALSE(request.write);
    return rows({"name"}, {"Ann"});
  };
  world.ring();
  EXPECT_EQ(world.said(), Texts{"Ann"});
}

Expected<ResultSet> broken(const QueryRequest&) {
  return fail(ErrorKind::database, "no such table");
}

TEST(EffectHandler, AQuerysErrorCaught) {
  Bell world("<try><querydb param='select 1' return='r'/><catch name='e'>"
             "<speak param='{e.kind}'/></catch></try>");
  world.database = broken;
  world.ring();
  EXPECT_EQ(world.said(), Texts{"Database"});
}

TEST(EffectHandler, AnErrorThatNobodyCatches) {
  Bell world("<querydb param='select 1' return='r'/>");
  world.database = broken;
  world.ring();
  EXPECT_EQ(world.said(), Texts{"[unavailable {reason: no such table}]"});
  EXPECT_EQ(world.seen(InspectionKind::error).size(), 1u);
  world.ring(); // the session lives
  EXPECT_EQ(world.said(), Texts{});
  EXPECT_EQ(world.seen(InspectionKind::error).size(), 2u);
}

TEST(EffectHandler, AnErrorWithAHandlerOfItsOwn) {
  Bell world("<throw expr=\"'bad'\"/>", R"xml(
    <handler name="E"><messages><component><Script><Error>
      <speak param="Error: {_LPARAM1}"/><throw expr="'worse'"/>
    </Error></Script></component></messages></handler>)xml");
  world.ring();
  EXPECT_EQ(world.said(), Texts{"Error: bad"});
  EXPECT_EQ(world.seen(InspectionKind::error).size(), 2u);
}

constexpr const char* transfer = R"xml(
  <topic name="Transfer">
    <slot name="Host" type="Functional" question="Whom?">
      <filled><try><confirm question="Call {this.Host}?">
        <yes><speak param="Calling."/></yes>
        <no><speak param="Not calling."/><clear slot="Host"/></no></confirm>
        <catch name="e"><speak param="{e.kind}."/></catch></try></filled>
    </slot>
    <slot name="Reason" type="Functional" question="Why?"/>
  </topic>
  <topic name="Hours"><slot name="Day" type="Functional" question="Which day?"
    confirm="explicit"/><completed><speak param="Nine."/></completed></topic>
  )xml";

TEST(EffectHandler, ConfirmYesAndNo) {
  for (bool yes : {true, false}) {
    Bell world("<speak param='Bell.'/>", transfer);
    world.say(inform("Transfer", {{"Host", "Ann"}}));
    EXPECT_EQ(world.said(), Texts{"Call Ann?"});
    world.ring(); // the pipeline keeps running
    EXPECT_EQ(world.said(), Texts{"Bell."});
    world.say(yes ? "confirm" : "deny");
    EXPECT_EQ(world.said(), yes ? (Texts{"Calling.", "Why?"})
                                : (Texts{"Not calling.", "Whom?"}));
  }
}

TEST(EffectHandler, CancelEndsAConfirm) {
  Bell world("", transfer);
  world.say(inform("Transfer", {{"Host", "Ann"}}));
  world.said();
  world.say("cancel");
  EXPECT_EQ(world.said(), (Texts{"Cancelled.", "[cancelled Transfer]"}));
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{"[acknowledge]"});
}

TEST(EffectHandler, AConfirmIsAskedAgainAfterAnotherTopic) {
  Bell world("", transfer);
  world.say(inform("Transfer", {{"Host", "Ann"}}));
  world.said();
  world.say(inform("Hours", {{"Day", "Monday"}}));
  EXPECT_EQ(world.said(), Texts{"[confirm Hours.Day {value: Monday}]"});
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{"Nine."});
  world.advance(2s);
  EXPECT_EQ(world.said(), Texts{"Call Ann?"});
  world.say("confirm");
  EXPECT_EQ(world.said(), (Texts{"Calling.", "Why?"}));
}

TEST(EffectHandler, AYesAfterAnotherTopicIsAskedForAgain) {
  Bell world("", transfer);
  world.say(inform("Transfer", {{"Host", "Ann"}}));
  world.say(inform("Hours", {{"Day", slot_value("Monday", 1)}}));
  world.say("confirm");
  world.said();
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{"Call Ann?"});
  world.say("confirm");
  EXPECT_EQ(world.said(), (Texts{"Calling.", "Why?"}));
}

TEST(EffectHandler, WhatElseWasSaidDoesNotWaitForAConfirm) {
  Bell world("", transfer);
  world.say(List{inform("Transfer", {{"Host", "Ann"}}),
                 inform("Hours", {{"Day", slot_value("Monday", 1)}})});
  EXPECT_EQ(world.said(), Texts{"[confirm Hours.Day {value: Monday}]"});
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{"Nine."});
  world.advance(2s);
  EXPECT_EQ(world.said(), Texts{"Call Ann?"});
  world.say("confirm");
  EXPECT_EQ(world.said(), (Texts{"Calling.", "Why?"}));
}

TEST(EffectHandler, AYesThatNamesATopicIsForItsConfirm) {
  Bell world("", transfer);
  world.say(inform("Transfer", {{"Host", "Ann"}}));
  world.say(inform("Hours", {{"Day", "Monday"}}));
  world.said(); // the day is to be confirmed, too
  world.say(act("confirm", "Transfer"));
  EXPECT_EQ(world.said(), (Texts{"Calling.", "Why?"}));
  EXPECT_EQ(world.conversation->current_topic(), "Transfer");
}

TEST(EffectHandler, ConsumeCountsAlsoAfterAWait) {
  World world(std::string(transfer) + R"xml(
    <handler name="H"><messages><component><Dialogue><inform><consume/>
      <confirm question="Sure?"><yes><speak param="Well."/></yes></confirm>
    </inform></Dialogue></component></messages></handler>)xml");
  world.say(inform("Hours", {{"Day", slot_value("Monday", 1)}}));
  EXPECT_EQ(world.said(), Texts{"Sure?"});
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{"Well."});
  EXPECT_EQ(world.slot("Hours", "Day"), Value());
}

TEST(EffectHandler, AConfirmThatIsCancelledIsNoError) {
  Bell world("<confirm question='Open?'/><speak param='Never.'/>");
  world.ring();
  world.say("cancel");
  EXPECT_EQ(world.said(), (Texts{"Open?", "[cancelled]"}));
  EXPECT_EQ(world.seen(InspectionKind::error), Texts{});
  EXPECT_EQ(world.seen(InspectionKind::log), Texts{});
  EXPECT_EQ(world.seen(InspectionKind::cancelled).size(), 1u);
}

TEST(EffectHandler, AConfirmRepeatedInSilenceEndsSomewhere) {
  Bell world("", transfer);
  world.say(inform("Transfer", {{"Host", "Ann"}}));
  world.advance(10min);
  EXPECT_TRUE(world.has_ended);
  auto said = world.said();
  EXPECT_EQ(said.size(), 7u); // asked, five times again, cancelled
  EXPECT_EQ(said.back(), "Cancelled.");
}

TEST(EffectHandler, EventsOfScripts) {
  Bell world("<fire event='Rung' param='5'/>", R"xml(
    <handler name="E"><messages><component><Script><Rung>
      <speak param="Rung {_LPARAM1}."/></Rung></Script></component></messages>
    </handler>)xml");
  world.ring();
  EXPECT_EQ(world.said(), Texts{"Rung 5."});
}

TEST(EffectHandler, AScriptsOwnErrorEventNeedsNoParameter) {
  World world(R"xml(<handler name="H"><messages><component><Bell><Rings>
    <fire event="Error"/></Rings></Bell></component></messages></handler>)xml");
  world.components["Bell"] = {};
  world.event("Bell", "Rings");
  EXPECT_EQ(world.said(), Texts{"[unavailable {reason: unknown}]"});
  EXPECT_FALSE(world.has_ended);
}

TEST(EffectHandler, EndEndsTheSession) {
  Bell world("<speak param='Bye.'/><end/>",
             R"xml(<handler name="E"><messages><component><Session><Ended>
      <post module="Telephone" command="Over" param=""/></Ended></Session>
      </component></messages></handler>)xml");
  world.ring();
  EXPECT_EQ(world.said(), Texts{"Bye."});
  EXPECT_EQ(world.posted(), Texts{"Telephone.Over()"});
  EXPECT_TRUE(world.has_ended);
}

TEST(EffectHandler, PrivateSlotsAreMasked) {
  World world(R"xml(<topic name="T"><slot name="Pin" private="true"/>
    <slot name="Free"/></topic>)xml");
  world.say(inform("T", {{"Pin", 4711}, {"Free", 12}}));
  EXPECT_EQ(world.seen(InspectionKind::slot),
            (Texts{"T.Pin: *** (accepted)", "T.Free: 12 (accepted)"}));
}

TEST(EffectHandler, SetChangesASlotAndUnknownSlotsAreErrors) {
  Bell world("", R"xml(<topic name="T"><slot name="A"/><slot name="B">
      <filled><set name="this.A" expr="this.B + 1"/></filled></slot></topic>
    )xml");
  world.say(inform("T", {{"B", 1}}));
  EXPECT_EQ(world.slot("T", "A"), 2);
}

} // namespace
} // namespace parlour::dialogue
