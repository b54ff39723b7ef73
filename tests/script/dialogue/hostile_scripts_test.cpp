// Scripts that wait, push, set timers and raise events without end. The session
// must become quiet, hear and answer the user, and end some time after the user
// has left.
#include <algorithm>
#include <ostream>

#include <gtest/gtest.h>

#include "tests/script/dialogue/speaker.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

struct Hostile {
  const char* name;
  const char* script; // further children of <dialogue>
  const char* start = "";
};

void PrintTo(const Hostile& hostile, std::ostream* stream) {
  *stream << hostile.name;
}

constexpr const char* ordinary = R"xml(
  <handler name="Pipeline"><messages><component>
    <ASR><RecognitionResult>
      <post module="NLU" command="DoNLU" param="_LPARAM1"/>
    </RecognitionResult></ASR>
    <NLU><FrameInfo><fire param="_LPARAMS"/></FrameInfo></NLU>
  </component></messages></handler>
  <topic name="Ping"><completed><speak param="pong"/></completed></topic>
  <topic name="Order"><slot name="What" type="Functional" question="What?"
    confirm="never"/><completed><speak param="{this.What} it is."/></completed>
  </topic>)xml";

// What a <Bell><Rings> handler does.
#define ON_RING(statements)                                                    \
  "<handler name='B'><messages><component><Bell><Rings>" statements            \
  "</Rings></Bell></component></messages></handler>"

// What a handler of any other event does.
#define ON(source, event, statements)                                          \
  "<handler name='O'><messages><on source='" source "' event='" event          \
  "'>" statements "</on></messages></handler>"

#define STATE(name, fields) "<state name='" name "'>" fields "</state>"

const Hostile scripts[] = {
    // waits
    {"wait_in_a_handler", ON_RING("<wait for='20m'/>")},
    {"wait_in_an_entrance",
     STATE("S", "<Entrance><wait for='20m'/></Entrance>"), "S"},
    {"wait_in_an_exit",
     STATE("S", "<Exit><wait for='20m'/></Exit>")
         STATE("T", "<Entrance><log param='in'/></Entrance>")
             ON_RING("<transit state='T'/>"),
     "S"},
    {"wait_without_end_in_an_exit",
     STATE("S", "<Exit><while cond='1 lt 2'><wait for='1s'/></while></Exit>")
         STATE("T", "") ON_RING("<transit state='T'/>"),
     "S"},
    {"wait_in_a_transit",
     STATE("S", "") STATE("T", "")
         ON_RING("<transit state='T'><wait for='20m'/></transit>"),
     "S"},
    {"wait_before_the_understanding",
     "<handler name='First'><messages><component><ASR><RecognitionResult>"
     "<if cond='_LPARAM1 == \"hm\"'><wait for='20m'/></if></RecognitionResult>"
     "</ASR></component></messages></handler>"},
    {"wait_before_the_dialogue", ON("NLU", "NoResult", "<wait for='20m'/>")},
    {"wait_for_an_act", ON("Dialogue", "no_match", "<wait for='20m'/>")},
    {"waits_without_number",
     ON_RING("<timer name='t' after='1ms' repeat='true'><wait for='20m'/>"
             "</timer>")},
    {"wait_in_the_error_handler",
     ON("Script", "Error", "<wait for='20m'/>") ON_RING("<throw expr='1'/>")},
    {"wait_for_silence",
     ON("Dialogue", "no_input", "<wait for='20m'/>") STATE("S", ""), "S"},
    // requests
    {"request_that_takes_long",
     ON_RING("<request module='Ghost' command='Ask' timeout='20m'/>")},
    {"request_for_long_in_an_entrance",
     STATE("S", "<Entrance><request module='Ghost' command='Ask' "
                "timeout='20m'/></Entrance>"),
     "S"},
    {"request_in_the_way_of_words",
     "<handler name='First'><messages><component><ASR><RecognitionResult>"
     "<if cond='_LPARAM1 == \"hm\"'><request module='Ghost' command='Ask' "
     "timeout='20m'/></if></RecognitionResult></ASR></component></messages>"
     "</handler>"},
    // questions
    {"confirm_in_a_handler", ON_RING("<confirm question='Sure?'/>")},
    {"confirm_of_words",
     "<handler name='First'><messages><component><ASR><RecognitionResult>"
     "<if cond='_LPARAM1 == \"hm\"'><confirm question='Sure?'/></if>"
     "</RecognitionResult></ASR></component></messages></handler>"},
    {"confirm_of_what_is_not_understood",
     ON("NLU", "NoResult", "<confirm question='Pardon?'/>")},
    {"confirm_of_no_match",
     ON("Dialogue", "no_match", "<confirm question='Help?'/>")},
    {"confirm_without_words", ON_RING("<confirm question=''/>")},
    {"confirm_in_an_exit",
     STATE("S", "<Exit><confirm question='Really?'/></Exit>") STATE("T", "")
         ON_RING("<transit state='T'/>"),
     "S"},
    {"confirm_in_the_error_handler",
     ON("Script", "Error",
        "<confirm question='Again?'><yes><throw expr='2'/>"
        "</yes></confirm>") ON_RING("<throw expr='1'/>")},
    {"confirm_in_a_timer",
     ON_RING("<timer name='t' after='1s' repeat='true'><confirm "
             "question='There?'/></timer>")},
    {"confirm_when_cancelled",
     ON_RING("<var name='n' expr='0'/><while cond='n lt 50'><set name='n' "
             "expr='n + 1'/><try><confirm question='Now?'/><catch/></try>"
             "</while>")},
    {"confirm_at_the_end",
     ON("Session", "Ended", "<confirm question='Stay?'/>")},
    {"confirm_at_the_start",
     ON("Session", "Started", "<confirm question='Ready?'/>")},
    {"confirm_of_the_robots_words",
     ON("NLG", "Speak", "<confirm question='Say it?'/>")},
    // states
    {"push_without_a_way_back", STATE("S", "") ON_RING("<push state='S'/>")},
    {"push_of_itself", STATE("S", "<Entrance><push state='S'/></Entrance>")
                           ON_RING("<push state='S'/>")},
    {"push_by_each_event",
     STATE("S", "<Messages><component><Bell><Rings><push state='S'/></Rings>"
                "</Bell></component></Messages>"),
     "S"},
    {"push_by_each_word",
     STATE("S",
           "<Entrance><log param='in'/></Entrance>") "<handler "
                                                     "name='First'><messages><"
                                                     "component><ASR><"
                                                     "RecognitionResult>"
                                                     "<if cond='_LPARAM1 == "
                                                     "\"hm\"'><push "
                                                     "state='S'/></if>"
                                                     "</RecognitionResult></"
                                                     "ASR></component></"
                                                     "messages></handler>"},
    {"pop_of_nothing", ON_RING("<pop/><pop/>")},
    {"states_that_lead_to_each_other",
     STATE("S", "<Entrance><transit state='T'/></Entrance>")
         STATE("T", "<Entrance><transit state='S'/></Entrance>"),
     "S"},
    {"transit_and_push_at_once",
     STATE("S", "<Exit><wait for='5s'/></Exit>") STATE("T", "")
         ON_RING("<transit state='T'/><push state='S'/>"),
     "S"},
    {"restart_in_the_entrance", STATE("S", "<Entrance><restart/></Entrance>"),
     "S"},
    // timers
    {"timer_of_no_time",
     "<function name='f'><timer name='t' after='0s'><call function='f'/>"
     "</timer></function>" ON_RING("<call function='f'/>")},
    {"timer_that_leads_to_its_own_state",
     STATE("S", "<Entrance><timer name='t' after='0s'><transit state='S'/>"
                "</timer></Entrance>"),
     "S"},
    {"timers_that_start_each_other",
     "<function name='f'><timer name='a' after='0s'><timer name='b' "
     "after='0s'><call function='f'/></timer></timer></function>" ON_RING(
         "<call function='f'/>")},
    {"timers_without_number",
     "<var name='rung'/>" ON_RING(
         "<if cond='rung'><return/></if><set name='rung' expr='true'/><for "
         "name='i' from='1' to='1001'><timer name='{i}' after='1s'/></for>")},
    {"timer_that_rings_while_nobody_can",
     ON_RING("<timer name='t' after='1ms' repeat='true'/>")
         ON("Dialogue", "request",
            "<request module='Ghost' command='Ask' timeout='9s'/>")},
    {"timer_in_the_handler_of_timers",
     ON("Timer", "Fired", "<timer name='t' after='1ms'/>")
         ON_RING("<timer name='t' after='1ms'/>")},
    // events
    {"event_that_raises_itself", ON("Script", "Again", "<fire event='Again'/>")
                                     ON_RING("<fire event='Again'/>")},
    {"events_that_raise_two",
     ON("Script", "Again", "<fire event='Again'/><fire event='Again'/>")
         ON_RING("<fire event='Again'/>")},
    {"every_event_raises_another", ON("*", "*", "<fire event='Again'/>")},
    {"error_in_the_error_handler",
     ON("Script", "Error", "<throw expr='2'/>") ON_RING("<throw expr='1'/>")},
    {"error_handler_that_raises", ON("Script", "Error", "<fire event='Error'/>")
                                      ON_RING("<throw expr='1'/>")},
    {"acts_that_are_never_understood",
     ON("Dialogue", "no_match", "<fire param='[]'/>")},
    {"repair_that_needs_repair",
     "<repair act='no_match'><fire param='[]'/></repair>"},
    {"every_event_fails", ON("*", "*", "<throw expr='1'/>")},
    {"handler_that_takes_itself_away",
     ON_RING("<unregister handler='B'/><fire event='Again'/>")},
    // topics
    {"topics_that_activate_each_other",
     "<topic name='A'><started><activate topic='C'/></started><slot name='S' "
     "type='Functional' question='A?'/></topic><topic name='C'><started>"
     "<activate topic='A'/></started><slot name='S' type='Functional' "
     "question='C?'/></topic>" ON_RING("<activate topic='A'/>")},
    {"topic_that_completes_itself_again",
     "<topic name='A'><completed><activate "
     "topic='A'/></completed></topic>" ON_RING("<activate topic='A'/>")},
    {"topic_that_waits_when_it_is_left",
     "<topic name='A'><slot name='S' type='Functional' question='A?'/>"
     "<suspended><wait for='5s'/></suspended></topic>" ON_RING(
         "<activate topic='A'/>")},
    {"topic_that_is_cancelled_again",
     "<topic name='A'><slot name='S' type='Functional' question='A?'/>"
     "<cancelled><cancel/><activate topic='A'/></cancelled></topic>" ON_RING(
         "<activate topic='A'/>")},
    {"topic_that_says_nothing",
     "<topic name='A'><slot name='S' type='Functional'/></topic>" ON_RING(
         "<activate topic='A'/>")},
};

class HostileScript : public testing::TestWithParam<Hostile> {
protected:
  static std::string script() {
    return std::string(GetParam().script) + ordinary;
  }
  static WorldOptions options() {
    WorldOptions options;
    options.start = GetParam().start;
    options.settings = "<limits instructions='100000'/>";
    return options;
  }
  // One who answers questions and says what he wants again, as people do.
  bool answered() {
    for (int time = 0; time < 6; ++time) {
      world.hear("ping");
      const auto said = world.said();
      if (std::ranges::find(said, "pong") != said.end())
        return true;
      world.advance(10s);
      world.hear("yes");
    }
    return false;
  }

  Speaker world{script(), options()};
};

TEST_P(HostileScript, LeavesTheSessionAlive) {
  world.components["Bell"] = {};
  world.components["Ghost"] = {};
  EXPECT_TRUE(answered());
  for (int time = 0; time < 3; ++time) {
    world.event("Bell", "Rings");
    world.advance(2s);
    world.hear("hm");
    world.hear("hm");
  }
  EXPECT_TRUE(answered());
  world.hear("tea");
  world.hear("cancel");
  for (int time = 0; time < 30; ++time)
    world.event("Bell", "Rings");
  world.advance(15s);
  EXPECT_TRUE(answered());
  EXPECT_LT(world.said().size(), 20u);
  EXPECT_LT(world.timers(), 1010u);
}

TEST_P(HostileScript, LetsTheSessionEnd) {
  world.components["Bell"] = {};
  world.components["Ghost"] = {};
  world.event("Bell", "Rings");
  world.hear("hm");
  world.take(input::Closed());
  world.run();
  world.advance(11s);
  EXPECT_TRUE(world.has_ended);
}

INSTANTIATE_TEST_SUITE_P(All, HostileScript, testing::ValuesIn(scripts),
                         [](const auto& hostile) {
                           return std::string(hostile.param.name);
                         });

} // namespace
} // namespace parlour::dialogue
