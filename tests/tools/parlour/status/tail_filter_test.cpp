#include <gtest/gtest.h>

#include "tools/parlour/status/tail_filter.hpp"

namespace parlour::tools {
namespace {

const RolesByComponent roles = {{"Words", {"NLU"}}, {"Ear", {"ASR", "VAD"}}};

Inspection message(const std::string& source, const std::string& way) {
  Message made;
  made.source = source;
  made.command = "Command";
  made.time = 1'500;
  Inspection seen;
  seen.kind = InspectionKind::message;
  seen.session = made.session = "s1";
  seen.message = std::make_shared<const Message>(made);
  seen.way = way;
  return seen;
}

bool takes(const TailFilter& filter, const Inspection& seen) {
  return filter.takes(seen, roles);
}

TEST(TailFilter, TakesAllButCoverageUnlessAsked) {
  for (const auto kind : {InspectionKind::slot, InspectionKind::log})
    EXPECT_TRUE(takes({}, {kind, "s1", "", ""}));
  EXPECT_FALSE(takes({}, {InspectionKind::branch, "s1", "", ""}));
  EXPECT_TRUE(
      takes({.kinds = {"branch"}}, {InspectionKind::branch, "", "", ""}));
}

TEST(TailFilter, ChoosesBySessionAndKind) {
  const Inspection slot{InspectionKind::slot, "s1", "T.S", "x"};
  EXPECT_TRUE(takes({.session = "s1"}, slot));
  EXPECT_FALSE(takes({.session = "s2"}, slot));
  EXPECT_TRUE(takes({.kinds = {"log", "slot"}}, slot));
  EXPECT_FALSE(takes({.kinds = {"log", "message"}}, slot));
}

TEST(TailFilter, ChoosesMessagesByWhoSendsAndWhoGets) {
  const auto heard = message("Ear", "session");
  EXPECT_TRUE(takes({.from = "Ear"}, heard));
  EXPECT_TRUE(takes({.from = "ASR"}, heard)); // the component fills it
  EXPECT_FALSE(takes({.from = "NLU"}, heard));
  EXPECT_FALSE(takes({.to = "Ear"}, heard));
  const auto posted = message("Script", "-> NLU");
  EXPECT_TRUE(takes({.to = "NLU"}, posted));
  EXPECT_TRUE(takes({.to = "Words"}, posted)); // it fills the role
  EXPECT_FALSE(takes({.to = "Ear"}, posted));
  EXPECT_TRUE(takes({.from = "Script", .to = "Words"},
                    message("Script", "relay -> Words")));
  const Inspection slot{InspectionKind::slot, "s1", "T.S", "x"};
  EXPECT_FALSE(takes({.from = "Ear"}, slot));
}

TEST(TailFilter, ALineHasTimeSessionAndTurn) {
  auto seen = message("Ear", "session");
  seen.turn = 3;
  const auto second = format_timestamp(1'500, "%H:%M:%S");
  EXPECT_EQ(tail_line(seen, 9'000),
            second + ".500  s1  3  message     Ear.Command()  [session]");
  const Inspection log{InspectionKind::log, "", "info", "a\nb"};
  EXPECT_EQ(tail_line(log, 1'007),
            second + ".007  -  -  log         info: a b");
}

TEST(TailFilter, GoesFromProcessToProcess) {
  const TailFilter filter{"s1", {"slot"}, "Ear", "Words"};
  const auto read = filter_from_json(to_json(filter));
  ASSERT_TRUE(read);
  EXPECT_EQ(to_json(*read), to_json(filter));
  for (const auto* text : {"", "{}", "[]", "{\"session\": 1}"})
    EXPECT_FALSE(filter_from_json(text)) << text;
}

} // namespace
} // namespace parlour::tools
