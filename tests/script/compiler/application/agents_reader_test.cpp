#include <gmock/gmock.h>

#include "script/compiler/application/agents_reader.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string environment(const std::string& name) {
  return name == "SECRET" ? "abc" : "";
}

struct Read {
  AgentsSettings settings;
  std::vector<std::string> lines;
};

Read read(const std::string& attributes, const std::string& agents) {
  Findings findings;
  findings.add_file("s.xml");
  auto settings = read_agents(
      test::tree_of("<agents " + attributes + ">" + agents + "</agents>"),
      environment, findings);
  return {std::move(settings), test::lines_of(findings)};
}

TEST(AgentsReader, ReadsAnAgent) {
  const auto [settings, lines] =
      read("", "<agent name='Porter' roles='Robot  TTS' token='${SECRET}'"
               " key='k' stand-in='LogRobot'>"
               "<option name='place' value='hall'/></agent>");
  EXPECT_THAT(lines, IsEmpty());
  ASSERT_EQ(settings.agents.size(), 1u);
  const auto& porter = settings.agents[0];
  EXPECT_EQ(porter.name, "Porter");
  EXPECT_THAT(porter.roles, ElementsAre("Robot", "TTS"));
  EXPECT_EQ(porter.token, "abc");
  EXPECT_EQ(porter.key, "k");
  EXPECT_EQ(porter.stand_in, "LogRobot");
  EXPECT_EQ(porter.options.at("place"), "hall");
  EXPECT_EQ(porter.place, (SourceLocation{"s.xml", 1, 10}));
}

TEST(AgentsReader, KnowsWhereAgentsConnect) {
  const auto usual = read("", "").settings;
  EXPECT_EQ(usual.lines, defaults::agent_lines);
  EXPECT_EQ(usual.zeromq, defaults::agent_zeromq);
  EXPECT_EQ(usual.taps, "");
  const auto given = read("lines='0.0.0.0:7' zeromq='off' taps='127.0.0.1:8' "
                          "certificate='a' private-key='b'"
                          " secret-key='${SECRET}'",
                          "")
                         .settings;
  EXPECT_EQ(given.lines, "0.0.0.0:7");
  EXPECT_EQ(given.zeromq, "");
  EXPECT_EQ(given.taps, "127.0.0.1:8");
  EXPECT_EQ(given.certificate, "a");
  EXPECT_EQ(given.private_key, "b");
  EXPECT_EQ(given.secret_key, "abc");
}

TEST(AgentsReader, RefusesNamesThatAreTaken) {
  const auto [settings, lines] = read("", "<agent name='Robot' roles='Robot'/>"
                                          "<agent name='Arm' roles='Robot'/>"
                                          "<agent name='Arm' roles='Robot'/>");
  EXPECT_THAT(lines, ElementsAre(HasSubstr("'Robot' is the name of a role"),
                                 HasSubstr("an agent 'Arm' already")));
  EXPECT_EQ(settings.agents.size(), 1u);
}

TEST(AgentsReader, RefusesWhatIsNotWhole) {
  EXPECT_THAT(read("", "<agent name='Arm'/>").lines,
              ElementsAre(HasSubstr("needs 'roles'")));
  EXPECT_THAT(read("", "<agent name='Arm' roles='Session'/>").lines,
              testing::Contains(HasSubstr("'Session' is no role")));
  EXPECT_THAT(read("certificate='a'", "").lines,
              ElementsAre(HasSubstr("needs both")));
  EXPECT_THAT(read("", "<agent name='Arm' roles='Robot'>"
                       "<option name='a' value='1'/>"
                       "<option name='a' value='2'/></agent>")
                  .lines,
              ElementsAre(HasSubstr("given twice")));
}

} // namespace
} // namespace parlour::script
