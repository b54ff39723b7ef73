#include <gmock/gmock.h>

#include "tests/tools/bench/speech/spoken_receptionist.hpp"
#include "tools/bench/speech/load_row.hpp"

namespace parlour::tools {
namespace {

TEST(LoadRow, is_measured) {
  const auto application = test::spoken_receptionist();
  SpeechBank bank(application.plugins);
  std::ostringstream out;
  EXPECT_TRUE(load_row(application, bank, true,
                       {"What time is it?", "Thank you."}, "en-us", out));
  EXPECT_THAT(out.str(), testing::HasSubstr(" MB (bar 60: "));
  EXPECT_THAT(out.str(), testing::HasSubstr(" s (bar 1.5: "));
}

} // namespace
} // namespace parlour::tools
