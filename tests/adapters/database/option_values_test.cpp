#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/database/option_values.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;

const std::vector<OptionDescription> described{
    {"time", "2s", "", false, OptionType::duration},
    {"count", "10", "", false, OptionType::integer},
    {"path", "", "", false},
    {"truth", "false", "", false, OptionType::boolean}};

TEST(OptionValues, HoldWhatIsDescribedOtherwise) {
  const Options given{{"time", "5s"}, {"truth", ""}};
  const auto values = OptionValues::of(given, described);
  ASSERT_TRUE(values);
  std::size_t count = 0;
  ASSERT_TRUE(values->read("count", count));
  EXPECT_EQ(values->duration("time"), Milliseconds(5'000));
  EXPECT_EQ(count, 10u);
  EXPECT_FALSE(values->truth("truth"));
  EXPECT_EQ(values->text("unheard-of"), "");
}

TEST(OptionValues, AreOfTheirTypes) {
  for (const auto& [name, value] :
       {std::pair("time", "soon"), std::pair("count", "1.5"),
        std::pair("truth", "perhaps")}) {
    const Options given{{name, value}};
    const auto wrong = OptionValues::of(given, described);
    ASSERT_FALSE(wrong) << name;
    EXPECT_EQ(wrong.error().kind, ErrorKind::settings);
    EXPECT_THAT(wrong.error().message, HasSubstr(name));
  }
}

TEST(OptionValues, NameTheOptionThatIsWrong) {
  const Options given{{"count", "0"}, {"path", "../x"}};
  const auto values = OptionValues::of(given, described);
  ASSERT_TRUE(values);
  std::size_t count = 0;
  std::filesystem::path path;
  for (const auto& [name, read] :
       {std::pair("count", values->read("count", count)),
        std::pair("path", values->read("path", "/data", path))}) {
    ASSERT_FALSE(read) << name;
    EXPECT_EQ(read.error().kind, ErrorKind::settings);
    EXPECT_THAT(read.error().message, HasSubstr(name));
  }
}

} // namespace
} // namespace parlour::adapters
