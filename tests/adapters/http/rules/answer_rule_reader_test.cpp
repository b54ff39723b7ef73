#include "adapters/http/rules/answer_rule_reader.hpp"
#include "tests/adapters/http/rules/errors_of.hpp"

namespace parlour::adapters::http {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string of_role(const std::string& role, const std::string& command,
                    const std::string& event) {
  return "<service role='" + role + "' address='http://a.com'><command " +
         command + "><get url='/'/><on>" + event + "</on></command></service>";
}

TEST(AnswerRuleReader, KnowsTheRole) {
  EXPECT_THAT(errors_of(of_role("Wether", "name='Ask'", "<event name='E'/>")),
              ElementsAre(HasSubstr("there is no role 'Wether'")));
  EXPECT_THAT(errors_of(of_role("System", "name='Ask'", "<event name='E'/>")),
              ElementsAre(HasSubstr("there is no role 'System'")));
  EXPECT_THAT(
      errors_of(of_role("Weather", "name='Ask'", "<event name='Report'/>")),
      ElementsAre(HasSubstr("the event Report has the parameters \"text, "
                            "data\", and here are 0")));
  EXPECT_THAT(errors_of(of_role("SMS", "name='Send'",
                                "<event name='Sent'><param/></event>")),
              ElementsAre(HasSubstr("the event Sent has no parameters, and "
                                    "here are 1")));
  EXPECT_THAT(
      errors_of(of_role("Telephone", "name='Call'", "<event name='Ringing'/>")),
      ElementsAre(HasSubstr("Ringing ends no request")));
  EXPECT_THAT(errors_of(of_role("SMS", "name='Send' params='to'",
                                "<event name='Sent'/>")),
              ElementsAre(HasSubstr("has the parameters \"number, text\"")));
  EXPECT_THAT(
      errors_of(of_role("SMS", "name='Send'", "<event name='Failed'/>")),
      ElementsAre(HasSubstr("\"reason\", and here are 0")));
}

TEST(AnswerRuleReader, ReadsConditions) {
  const auto rules = rules_of(
      "<command name='A'><get url='/'/>"
      "<on status='200 4xx 500-502' has='/a' is='b' matches='(x)(y)'>"
      "<event name='E'><param value='{2}'/></event></on>"
      "<on><event name='E'/></on><otherwise><event name='E'/></otherwise>"
      "</command>");
  const auto& answers = rules.commands.at(0).answers;
  using Ranges = std::vector<std::pair<int, int>>;
  EXPECT_EQ(answers[0].statuses, (Ranges{{200, 200}, {400, 499}, {500, 502}}));
  EXPECT_EQ(answers[0].has->text(), "/a");
  EXPECT_EQ(answers[0].is, "b");
  EXPECT_TRUE(answers[0].matches);
  EXPECT_EQ(answers[1].statuses, (Ranges{{200, 299}}));
  EXPECT_EQ(answers[2].statuses, Ranges{});
}

} // namespace
} // namespace parlour::adapters::http
