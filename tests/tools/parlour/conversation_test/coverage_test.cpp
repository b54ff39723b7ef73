#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "script/program/host.hpp"
#include "script/program/instruction.hpp"
#include "tools/parlour/conversation_test/coverage.hpp"

namespace parlour::tools {
namespace {

using testing::ElementsAre;

class CoverageTest : public testing::Test {
protected:
  CoverageTest() {
    program_.files = {"/site/desk.xml"};
    for (const auto* name : {"Welcome", "Rest"})
      program_.states.emplace_back().name = name;
    auto& topic = program_.topics.emplace_back();
    topic.name = "Visit";
    topic.slots.emplace_back().name = "Guest";
    auto& handler = program_.handlers.emplace_back();
    handler.name = "Turn";
    handler.reactions = {{"Record", "BufferFull", script::no_code, {0, 4, 1}},
                         {"*", "Odd", script::no_code, {0, 9, 1}}};
  }
  std::vector<std::string> missing(std::size_t part) const {
    return coverage_.parts()[part].missing;
  }
  script::Program program_;
  Coverage coverage_{program_};
};

TEST_F(CoverageTest, notes_states_topics_and_slots) {
  EXPECT_THAT(missing(0), ElementsAre("Welcome", "Rest"));
  coverage_.note({InspectionKind::transition, "s", "Welcome", ""});
  coverage_.note({InspectionKind::topic, "s", "Visit", "active"});
  coverage_.note({InspectionKind::slot, "s", "Visit.Guest", "Ada"});
  EXPECT_THAT(missing(0), ElementsAre("Rest"));
  EXPECT_THAT(missing(2), ElementsAre());
  EXPECT_THAT(missing(3), ElementsAre());
}

// A message alone is no evidence: it may have been captured or consumed.
TEST_F(CoverageTest, notes_handlers_that_ran) {
  auto message = std::make_shared<Message>();
  message->source = "Record";
  message->command = "BufferFull";
  coverage_.note({InspectionKind::message, "s", "", "", message, "session"});
  EXPECT_THAT(missing(4),
              ElementsAre("Turn (Record.BufferFull)", "Turn (*.Odd)"));
  coverage_.note({InspectionKind::branch, "s", "/site/desk.xml:4", ""});
  EXPECT_THAT(missing(4), ElementsAre("Turn (*.Odd)"));
  coverage_.note({InspectionKind::branch, "s", "/site/desk.xml:9", ""});
  EXPECT_THAT(missing(4), ElementsAre());
}

TEST_F(CoverageTest, adds_what_another_has_seen) {
  Coverage other(program_);
  other.note({InspectionKind::transition, "s", "Rest", ""});
  coverage_.add(other);
  EXPECT_THAT(missing(0), ElementsAre("Welcome"));
}

TEST_F(CoverageTest, names_branches_from_the_working_folder) {
  auto& code = program_.code.emplace_back();
  code.instructions.emplace_back().operation =
      static_cast<std::uint8_t>(script::Operation::reached);
  code.positions = {{0, 7, 3}};
  Places places;
  places.working = "/site";
  std::ostringstream out;
  print(out, coverage_, places);
  EXPECT_THAT(out.str(), testing::HasSubstr("  branches 0 of 1\n"
                                            "    not reached: desk.xml:7\n"));
  coverage_.note({InspectionKind::branch, "s", "/site/desk.xml:7", ""});
  EXPECT_THAT(missing(5), ElementsAre());
}

TEST_F(CoverageTest, notes_transitions_that_were_made) {
  auto& code = program_.code.emplace_back();
  for (const auto kind : {script::EffectKind::transit, script::EffectKind::push,
                          script::EffectKind::pop}) {
    auto& instruction = code.instructions.emplace_back();
    instruction.operation =
        static_cast<std::uint8_t>(script::Operation::effect);
    instruction.c = static_cast<std::uint16_t>(code.effects.size());
    code.effects.emplace_back().kind = static_cast<std::uint8_t>(kind);
  }
  code.positions = {{0, 7, 3}, {0, 8, 3}, {0, 9, 3}};
  EXPECT_THAT(missing(1), ElementsAre("/site/desk.xml:7", "/site/desk.xml:8"));
  coverage_.note({InspectionKind::branch, "s", "/site/desk.xml:7", ""});
  EXPECT_THAT(missing(1), ElementsAre("/site/desk.xml:8"));
}

} // namespace
} // namespace parlour::tools
