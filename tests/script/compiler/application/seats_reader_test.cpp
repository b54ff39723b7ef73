#include <gmock/gmock.h>

#include "script/compiler/application/settings_reader.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Read {
  Settings settings;
  std::vector<std::string> lines;
};

// Each seat in a line of its own, from line 2 on.
Read read(const std::string& seats) {
  Findings findings;
  findings.add_file("s.xml");
  auto settings = read_settings(
      test::tree_of(
          "<settings><Plugins><Plugin>Mic</Plugin><Plugin>Loud"
          "</Plugin></Plugins><component name='Loud' scope='session'/>"
          "<agents><agent name='olivia' roles='Robot'/></agents>\n" +
          seats + "</settings>"),
      {{"OldMic", "Mic"}}, [](const std::string&) { return std::string(); },
      findings);
  return {std::move(settings), test::lines_of(findings)};
}

TEST(SeatsReader, reads_what_a_seat_binds) {
  const auto [settings, lines] = read(
      "<seat name='desk' Record='OldMic' Robot='olivia' "
      "opens='VAD.SpeechStarted' closes-after='5s'/>\n<seat name='hall'/>");
  EXPECT_THAT(lines, IsEmpty());
  ASSERT_EQ(settings.seats.size(), 2u);
  const auto& desk = settings.seats[0];
  EXPECT_EQ(desk.name, "desk");
  EXPECT_EQ(desk.place.line, 2u);
  EXPECT_EQ(desk.closes_after, Milliseconds(5'000));
  ASSERT_EQ(desk.components.size(), 2u);
  EXPECT_EQ(desk.components[0].role, "Microphone");
  EXPECT_EQ(desk.components[0].component, "Mic");
  EXPECT_EQ(desk.components[1].component, "olivia");
  EXPECT_FALSE(settings.seats[1].closes_after);
  const auto& policy = settings.components[0].policy;
  EXPECT_EQ(policy.seat, "desk");
  EXPECT_EQ(policy.scope.kind, Scope::Kind::seat);
  EXPECT_EQ(settings.components[1].policy.seat, "");
}

TEST(SeatsReader, tells_of_a_component_that_is_not_there) {
  EXPECT_THAT(read("<seat name='desk' Microphone='Mik'/>").lines,
              ElementsAre("s.xml:2:31: error: there is no component and no "
                          "agent 'Mik', did you mean 'Mic'?"));
  EXPECT_THAT(read("<seat name='desk' Microphone='AlsaMicrophone'/>").lines,
              ElementsAre("s.xml:2:31: error: there is no component and no "
                          "agent 'AlsaMicrophone'; list it in <Plugins>, or "
                          "say <component name=\"AlsaMicrophone\" "
                          "plugin=\"…\"/>"));
}

TEST(SeatsReader, tells_of_a_role_that_is_none) {
  EXPECT_THAT(read("<seat name='desk' Microphne='Mic'/>").lines,
              ElementsAre("s.xml:2:19: error: <seat> has no attribute "
                          "'Microphne', and no role has that name, did you "
                          "mean 'Microphone'?"));
  EXPECT_THAT(read("<seat name='desk' Camera='Mic'/>").lines,
              ElementsAre("s.xml:2:19: error: <seat> has no attribute "
                          "'Camera', and no role has that name; roles are "
                          "listed by `parlour plugin roles`"));
  EXPECT_THAT(read("<seat name='desk' System='Mic'/>").lines,
              ElementsAre(HasSubstr("no attribute 'System'")));
}

TEST(SeatsReader, tells_of_a_component_at_two_seats) {
  const auto [settings, lines] = read("<seat name='desk' Microphone='Mic'/>\n"
                                      "<seat name='hall' Microphone='Mic'/>");
  EXPECT_THAT(lines, ElementsAre("s.xml:3:31: error: 'Mic' is at the seat "
                                 "'desk' already, and a component is at one "
                                 "seat; a further instance of its plug-in has "
                                 "a name of its own: <component name=\"…\" "
                                 "plugin=\"…\"/>"));
  EXPECT_EQ(settings.components[0].policy.seat, "desk");
}

TEST(SeatsReader, lets_a_component_fill_two_roles_of_a_seat) {
  const auto [settings, lines] =
      read("<seat name='desk' Microphone='Mic' VAD='Mic'/>");
  EXPECT_THAT(lines, IsEmpty());
  EXPECT_EQ(settings.seats[0].components.size(), 2u);
}

TEST(SeatsReader, tells_of_another_scope) {
  EXPECT_THAT(read("<seat name='desk' Speaker='Loud'/>").lines,
              ElementsAre("s.xml:2:28: error: 'Loud' has another scope, and a "
                          "component of a seat has one instance, there; leave "
                          "its scope=\"…\" out"));
}

TEST(SeatsReader, tells_of_names_that_are_not_free) {
  const auto [settings, lines] =
      read("<seat name='desk'/>\n<seat name='desk'/>\n<seat name=''/>\n"
           "<seat name='seat-1'/>");
  EXPECT_THAT(
      lines,
      ElementsAre("s.xml:3:13: error: a second seat 'desk', after the one in "
                  "line 2; put both into one, or give this one another name",
                  "s.xml:4:13: error: a seat needs a name",
                  "s.xml:5:13: error: 'seat-1' is what a run calls a seat of "
                  "its own; give this one a name that does not begin with "
                  "'seat-'"));
  EXPECT_EQ(settings.seats.size(), 1u);
}

} // namespace
} // namespace parlour::script
