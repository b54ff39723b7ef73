#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/database/option_values.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;

const std::vector<OptionDescription> described{{"time", "2s", "", false},
                                               {"count", "10", "", false},
                                               {"path", "", "", false},
                                               {"truth", "false", "", false}};

TEST(OptionValues, HoldWhatIsDescribedOtherwise) {
  const Options given{{"time", "5s"}};
  const OptionValues values(given, described);
  Milliseconds time{};
  std::size_t count = 0;
  bool truth = true;
  ASSERT_TRUE(values.read("time", time));
  ASSERT_TRUE(values.read("count", count));
  ASSERT_TRUE(values.read("truth", truth));
  EXPECT_EQ(time, Milliseconds(5'000));
  EXPECT_EQ(count, 10u);
  EXPECT_FALSE(truth);
  EXPECT_EQ(values.text("unheard-of"), "");
}

TEST(OptionValues, NameTheOptionThatIsWrong) {
  const Options given{
      {"time", "soon"}, {"count", "0"}, {"path", "../x"}, {"truth", "perhaps"}};
  const OptionValues values(given, described);
  Milliseconds time{};
  std::size_t count = 0;
  bool truth = true;
  std::filesystem::path path;
  for (const auto& [name, read] :
       {std::pair("time", values.read("time", time)),
        std::pair("count", values.read("count", count)),
        std::pair("truth", values.read("truth", truth)),
        std::pair("path", values.read("path", "/data", path))}) {
    ASSERT_FALSE(read) << name;
    EXPECT_EQ(read.error().kind, ErrorKind::settings);
    EXPECT_THAT(read.error().message, HasSubstr(name));
  }
}

} // namespace
} // namespace parlour::adapters
