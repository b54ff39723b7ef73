#include <gmock/gmock.h>

#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// A session that subscribes as it is told.
World world_that(const std::string& statements) {
  return World("<handler name='H'><messages><on source='Bell' event='Rings'>" +
               statements + "</on></messages></handler>");
}

std::vector<Subscription> after(const std::string& statements) {
  auto world = world_that(statements);
  world.event("Bell", "Rings");
  EXPECT_THAT(world.seen(InspectionKind::error), IsEmpty()) << statements;
  return world.subscriptions;
}

TEST(Subscriptions, AreKeptOnceEach) {
  EXPECT_THAT(
      after("<subscribe source='Radar'/><subscribe source='Radar' "
            "command='*'/><subscribe source='ASR' command='Partial'/>"),
      ElementsAre(Subscription{"Radar", "*"}, Subscription{"ASR", "Partial"}));
}

TEST(Subscriptions, AreTakenBack) {
  const std::string all = "<subscribe source='A'/><subscribe source='B' "
                          "command='x'/><subscribe source='B' command='y'/>";
  EXPECT_THAT(after(all + "<unsubscribe source='B' command='x'/>"),
              ElementsAre(Subscription{"A", "*"}, Subscription{"B", "y"}));
  EXPECT_THAT(after(all + "<unsubscribe source='B'/>"),
              ElementsAre(Subscription{"A", "*"}));
  EXPECT_THAT(after(all + "<unsubscribe source='*' command='y'/>"),
              ElementsAre(Subscription{"A", "*"}, Subscription{"B", "x"}));
  EXPECT_THAT(after(all + "<unsubscribe source='*'/>"), IsEmpty());
  EXPECT_EQ(after(all + "<unsubscribe source='C'/>").size(), 3u);
}

} // namespace

} // namespace parlour::dialogue
