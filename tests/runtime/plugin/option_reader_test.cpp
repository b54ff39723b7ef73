#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/plugin/option_reader.hpp"

namespace parlour {
namespace {

using testing::HasSubstr;

const std::vector<OptionDescription> described{
    {"time", "2s", "", false, OptionType::duration},
    {"count", "10", "", false, OptionType::integer},
    {"share", "0.5", "", false, OptionType::number},
    {"path", "", "", false},
    {"truth", "false", "", false, OptionType::boolean}};

// What is wrong with the options, if they are read so.
std::string mistake(const Options& given,
                    const std::function<void(OptionReader&)>& action) {
  OptionReader read(given, described);
  action(read);
  const auto outcome = read.outcome();
  if (outcome)
    return "none";
  EXPECT_EQ(outcome.error().kind, ErrorKind::settings);
  return outcome.error().message;
}

TEST(OptionReader, ReadsWhatIsGivenOrTheDefault) {
  const Options given{{"time", "5s"}, {"truth", ""}};
  OptionReader read(given, described);
  EXPECT_EQ(read.duration("time"), Milliseconds(5'000));
  EXPECT_EQ(read.count("count", 1), 10u);
  EXPECT_EQ(read.number("share", 0, 1), 0.5);
  EXPECT_FALSE(read.truth("truth"));
  EXPECT_TRUE(read.has("count"));
  EXPECT_FALSE(read.has("path"));
  EXPECT_EQ(read.file("path", "/data"), "");
  EXPECT_EQ(read.text("unheard-of"), "");
  EXPECT_TRUE(read.outcome());
}

TEST(OptionReader, ChecksTypes) {
  for (const auto& [name, value] :
       {std::pair("time", "soon"), std::pair("count", "1.5"),
        std::pair("truth", "perhaps")})
    EXPECT_THAT(mistake({{name, value}}, [](OptionReader&) {}),
                HasSubstr("the option '" + std::string(name) + "' takes"));
}

TEST(OptionReader, ChecksBounds) {
  EXPECT_EQ(mistake({{"count", "0"}},
                    [](auto& read) { EXPECT_EQ(read.integer("count", 1), 1); }),
            "the option 'count' is a whole number from 1, not '0'");
  EXPECT_EQ(mistake({{"count", "9"}},
                    [](auto& read) { (void)read.count("count", 1, 8); }),
            "the option 'count' is a whole number from 1 to 8, not '9'");
  EXPECT_EQ(mistake({{"share", "1.5"}},
                    [](auto& read) { (void)read.number("share", 0, 1); }),
            "the option 'share' is a number from 0 to 1, not '1.5'");
  EXPECT_EQ(mistake({{"time", "2h"}},
                    [](auto& read) {
                      (void)read.duration("time", Milliseconds(40),
                                          Milliseconds(3'600'000));
                    }),
            "the option 'time' is a time from 40ms to 1h, not '2h'");
  EXPECT_EQ(
      mistake({{"time", "0s"}},
              [](auto& read) { (void)read.duration("time", Milliseconds(1)); }),
      "the option 'time' is a time from 1ms, not '0s'");
}

TEST(OptionReader, KeepsFilesInTheirFolder) {
  const Options given{{"path", "a.txt"}};
  OptionReader read(given, described);
  EXPECT_EQ(read.file("path", "/data"), "/data/a.txt");
  EXPECT_THAT(mistake({{"path", "../x"}},
                      [](auto& other) { (void)other.file("path", "/data"); }),
              HasSubstr("path"));
}

TEST(OptionReader, KeepsTheFirstMistake) {
  EXPECT_EQ(mistake({},
                    [](auto& read) {
                      read.wrong("path", "is dark");
                      read.wrong("time", "is up");
                    }),
            "the option 'path' is dark");
}

} // namespace
} // namespace parlour
