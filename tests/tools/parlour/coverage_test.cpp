#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "script/instruction.hpp"
#include "tools/parlour/coverage.hpp"

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
    handler.reactions = {{"Record", "BufferFull", script::no_code, {}},
                         {"*", "Odd", script::no_code, {}}};
  }
  std::vector<std::string> missing(std::size_t part) const {
    return coverage_.parts()[part].missing;
  }
  void note_message(const std::string& source, const std::string& command,
                    std::vector<std::string> sinks = {}) {
    auto message = std::make_shared<Message>();
    message->source = source;
    message->command = command;
    message->sinks = std::move(sinks);
    coverage_.note({InspectionKind::message, "s", "", "", message, ""});
  }

  script::Program program_;
  ModuleNames names_{Composition{}};
  Coverage coverage_{program_, names_};
};

TEST_F(CoverageTest, notes_states_topics_and_slots) {
  EXPECT_THAT(missing(0), ElementsAre("Welcome", "Rest"));
  coverage_.note({InspectionKind::transition, "s", "Welcome", ""});
  coverage_.note({InspectionKind::topic, "s", "Visit", "active"});
  coverage_.note({InspectionKind::slot, "s", "Visit.Guest", "Ada"});
  EXPECT_THAT(missing(0), ElementsAre("Rest"));
  EXPECT_THAT(missing(1), ElementsAre());
  EXPECT_THAT(missing(2), ElementsAre());
}

TEST_F(CoverageTest, notes_reactions_to_messages_that_reach_the_session) {
  note_message("Microphone", "BufferFull", {"ASR"});
  EXPECT_THAT(missing(3),
              ElementsAre("Turn (Record.BufferFull)", "Turn (*.Odd)"));
  note_message("Microphone", "BufferFull");
  EXPECT_THAT(missing(3), ElementsAre("Turn (*.Odd)"));
  note_message("Anybody", "Odd");
  EXPECT_THAT(missing(3), ElementsAre());
}

TEST_F(CoverageTest, adds_what_another_has_seen) {
  Coverage other(program_, names_);
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
  EXPECT_THAT(missing(4), ElementsAre());
}

} // namespace
} // namespace parlour::tools
