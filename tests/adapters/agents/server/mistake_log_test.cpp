#include <gmock/gmock.h>

#include "adapters/agents/server/mistake_log.hpp"

namespace parlour::adapters::agents {
namespace {

using testing::ElementsAre;
using testing::Pair;

TEST(MistakeLog, CountsAllAndWritesFew) {
  std::vector<std::string> lines;
  MistakeLog log([&](const std::string& line) { lines.push_back(line); });
  const WireError wrong{WireErrorKind::identity, "the token is wrong"};
  for (int i = 0; i < 5; ++i)
    log.note("1.2.3.4:5", wrong, 100 + i);
  log.note("Robot", {WireErrorKind::malformed, "no time"}, 105);
  log.note("1.2.3.4:5", wrong, 1100);
  EXPECT_THAT(lines,
              ElementsAre("agent 1.2.3.4:5: identity: the token is wrong",
                          "agent Robot: malformed: no time",
                          "agent 1.2.3.4:5: identity: the token is wrong "
                          "(and 4 more)"));
  EXPECT_THAT(log.counts(),
              ElementsAre(Pair("identity", 6U), Pair("malformed", 1U)));
}

TEST(MistakeLog, CountsConnectionsThatAreNotAccepted) {
  std::vector<std::string> lines;
  MistakeLog log([&](const std::string& line) { lines.push_back(line); });
  for (int i = 0; i < 3; ++i)
    log.note_not_accepted("too many files", 700 * i);
  EXPECT_THAT(lines, ElementsAre("an agent's connection is not accepted: too "
                                 "many files",
                                 "an agent's connection is not accepted: too "
                                 "many files (and 1 more)"));
  EXPECT_THAT(log.counts(), ElementsAre(Pair("accept", 3U)));
}

TEST(MistakeLog, MayHaveNoLog) {
  MistakeLog log({});
  log.note("Robot", {WireErrorKind::malformed, "no time"}, 5);
  EXPECT_EQ(log.counts().at("malformed"), 1U);
}

} // namespace
} // namespace parlour::adapters::agents
