#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/conversation_test/witness.hpp"

namespace parlour::tools {
namespace {

// crash_test.py tests what it prints.
TEST(WitnessDeathTest, lets_no_exit_in_the_middle_count_as_success) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        Witness witness;
        const Witness::Held held(witness, "one.txt");
        std::exit(0);
      },
      testing::ExitedWithCode(exit_code::wrong), "");
  EXPECT_EXIT(
      {
        Witness witness;
        { const Witness::Held held(witness, "one.txt"); }
        std::exit(0);
      },
      testing::ExitedWithCode(0), "");
}

TEST(Witness, takes_more_names_than_it_has_places_for) {
  Witness witness;
  std::vector<std::unique_ptr<Witness::Held>> held;
  for (int i = 0; i < 1'100; ++i)
    held.push_back(
        std::make_unique<Witness::Held>(witness, std::string(300, 'x')));
}

} // namespace
} // namespace parlour::tools
