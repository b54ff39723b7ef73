// Messages and requests of scripts to components.
#include <gtest/gtest.h>

#include "script/dialogue/engine/effects/request_effects.hpp"
#include "tests/script/dialogue/bell.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

constexpr const char* call = R"xml(
  <try><request module="Telephone" command="Call" param="123" return="r"
    timeout="3s"/><speak param="{r.command} {r.params}"/>
  <catch name="e"><speak param="{e.kind}: {e.message}"/></catch></try>)xml";

TEST(RequestEffects, ARequestTakesItsReply) {
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

TEST(RequestEffects, ARequestRefused) {
  World world(R"xml(<handler name="H"><messages><component><Bell><Rings>
    <try><request module="Taxi" command="Book" param="" return="r"/>
    <catch name="e"><speak param="{e.kind}: {e.message}"/></catch></try>
    </Rings></Bell></component></messages></handler>)xml");
  world.components["Cabs"] = {"Taxi"};
  world.event("Bell", "Rings");
  world.event("Cabs", "Refused", {"no car"}, world.messages.back().correlation);
  EXPECT_EQ(world.said(), Texts{"Refused: Cabs: no car"});
}

// A database names the kind, as it does to <querydb>.
TEST(RequestEffects, ARequestThatADatabaseRefuses) {
  World world(R"xml(<handler name="H"><messages><component><Bell><Rings>
    <try><request module="Archive" command="Query" param="" return="r"/>
    <catch name="e"><speak param="{e.kind}: {e.message}"/></catch></try>
    </Rings></Bell></component></messages></handler>)xml");
  world.components["Archive"] = {"Database"};
  const auto refused = [&](const char* event, const List& params) {
    world.event("Bell", "Rings");
    world.event("Archive", event, params, world.messages.back().correlation);
    return world.said();
  };
  EXPECT_EQ(refused("Error", {"InDoubt", "the line broke"}),
            Texts{"InDoubt: Archive: the line broke"});
  EXPECT_EQ(refused("Error", {"locked"}), Texts{"Database: Archive: locked"});
  EXPECT_EQ(refused("Failed", {"is down"}),
            Texts{"Database: Archive: is down"});
}

// What a plug-in says of its own events counts, where its role says nothing.
TEST(RequestEffects, ARequestHearsOfOwnEventsWhatTheyMean) {
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

TEST(RequestEffects, ARequestTooLate) {
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

TEST(RequestEffects, ARequestToNobody) {
  Bell world(call);
  world.components.erase("Exchange");
  world.ring();
  auto said = world.said();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0].rfind("Offline: ", 0), 0u);
}

TEST(RequestEffects, ARequestAnsweredInline) {
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

TEST(RequestEffects, PostForwardsTheParameters) {
  Bell world("<post module='Telephone' command='Call'/>");
  world.ring({"a", 2});
  EXPECT_EQ(world.posted(), Texts{"Telephone.Call(a, 2)"});
}

} // namespace
} // namespace parlour::dialogue
