#include <gtest/gtest.h>

#include "runtime/plugin/options.hpp"

namespace parlour {
namespace {

OptionDescription option(OptionType type) {
  return {"it", "", "what it is", false, type, {"sent", "failed"}};
}

TEST(Options, TakeWhatFitsTheirType) {
  struct {
    OptionType type;
    const char* value;
    bool fits;
  } const cases[] = {
      {OptionType::text, "anything at all", true},
      {OptionType::boolean, "true", true},
      {OptionType::boolean, "yes", false},
      {OptionType::integer, "-7", true},
      {OptionType::integer, "7.5", false},
      {OptionType::integer, "seven", false},
      {OptionType::number, "0.4", true},
      {OptionType::number, "0.4.", false},
      {OptionType::duration, "200ms", true},
      {OptionType::duration, "200", false},
      {OptionType::choice, "failed", true},
      {OptionType::choice, "maybe", false},
      {OptionType::integer, "", true}, // as good as none
  };
  for (const auto& [type, value, fits] : cases)
    EXPECT_EQ(check_option(option(type), value).has_value(), fits)
        << name_of(type) << " " << value;
}

TEST(Options, SayWhatTheyTakeInstead) {
  EXPECT_EQ(check_option(option(OptionType::duration), "soon").error().message,
            "the option 'it' takes a time such as 200ms, 1.5s or 2m, not "
            "'soon': what it is");
  EXPECT_EQ(check_option(option(OptionType::choice), "no").error().message,
            "the option 'it' takes one of 'sent', 'failed', not 'no': what it "
            "is");
}

TEST(Options, FallBackOnWhatIsDescribed) {
  const std::vector<OptionDescription> described = {{"pace", "2s", ""}};
  EXPECT_EQ(option_value({{"pace", "1s"}}, described, "pace"), "1s");
  EXPECT_EQ(option_value({{"pace", ""}}, described, "pace"), "2s");
  EXPECT_EQ(option_value({}, described, "pace"), "2s");
  EXPECT_EQ(option_value({}, described, "other"), "");
}

} // namespace
} // namespace parlour
