#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/paths.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/bench/dialogue/dialogue_workload.hpp"

namespace parlour::tools {
namespace {

const std::string folder = test::source_path("tools/bench/workloads/");

DialogueWorkload load(const char* name) {
  return DialogueWorkload::load(std::string(folder) + name).value();
}

// Which facility, what of it, the taxi, back to the form, the answer, good bye.
TEST(DialogueWorkload, says_the_same_in_every_conversation) {
  const auto workload = load("turns.xml");
  const std::size_t said =
      sizeof("Which facility do you want to know more?") +
      sizeof("What do you want to know, location or opening hours?") * 2 +
      sizeof("Where do you want to go?") +
      sizeof("Your taxi to airport is booked.") +
      sizeof("The swimming pool location is on floor twenty three.") +
      sizeof("Anything else?") + sizeof("Good bye.") - 6;
  for (int count : {1, 3}) {
    const auto turns = workload.turns(count);
    ASSERT_TRUE(turns);
    EXPECT_EQ(turns->result, std::to_string(said));
    EXPECT_GT(turns->nanoseconds, 0);
  }
}

TEST(DialogueWorkload, every_event_leads_to_the_next_state) {
  const auto workload = load("events.xml");
  EXPECT_EQ(workload.events(1)->result, "Greeting");
  EXPECT_EQ(workload.events(7)->result, "Asking");
}

TEST(DialogueWorkload, tells_what_went_wrong) {
  const test::TemporaryFolder made;
  made.write("x.xml", "<dialogue><brake/></dialogue>");
  EXPECT_FALSE(DialogueWorkload::load(made.path() / "x.xml"));
  made.write("y.xml", "<dialogue><var name=\"n\" expr=\"1 / 0\"/></dialogue>");
  const auto workload = DialogueWorkload::load(made.path() / "y.xml");
  ASSERT_TRUE(workload);
  EXPECT_FALSE(workload->events(1));
}

} // namespace
} // namespace parlour::tools
