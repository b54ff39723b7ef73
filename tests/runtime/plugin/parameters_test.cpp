#include <set>

#include <gtest/gtest.h>

#include "runtime/message/roles.hpp"
#include "runtime/plugin/parameters.hpp"

namespace parlour {
namespace {

TEST(Parameters, AreReadFromTheTablesText) {
  EXPECT_TRUE(read_parameters("").empty());
  const auto some = read_parameters("text, context?, act...");
  ASSERT_EQ(some.size(), 3u);
  EXPECT_EQ(some[0].name, "text");
  EXPECT_EQ(some[0].kind, ParameterKind::text);
  EXPECT_FALSE(some[0].optional);
  EXPECT_TRUE(some[1].optional);
  EXPECT_EQ(some[1].kind, ParameterKind::value);
  EXPECT_TRUE(some[2].repeats);
  EXPECT_EQ(some[2].name, "act");
}

// A name of parameters.def that no role uses is a slip.
TEST(Parameters, AreAllUsedBySomeRole) {
  std::set<std::string> used;
  for (const auto& role : roles()) {
    for (const auto& command : role.commands)
      for (const auto& parameter : read_parameters(command.parameters))
        used.insert(parameter.name);
    for (const auto& event : role.events)
      for (const auto& parameter : read_parameters(event.parameters))
        used.insert(parameter.name);
  }
#define PARAMETER(name, kind) EXPECT_TRUE(used.count(#name)) << #name;
#include "runtime/plugin/parameters.def"
#undef PARAMETER
}

TEST(Parameters, HaveSamplesThatFit) {
  std::string text;
  std::int64_t integer = 0;
  double number = 0;
  bool boolean = true;
  List list;
  Map map;
  Binary audio;
  ResultSet rows;
  auto sample = [](ParameterKind kind) { return sample_of({"x", kind}); };
  EXPECT_TRUE(read(sample(ParameterKind::text), text));
  EXPECT_TRUE(read(sample(ParameterKind::integer), integer));
  EXPECT_TRUE(read(sample(ParameterKind::number), number));
  EXPECT_TRUE(read(sample(ParameterKind::boolean), boolean));
  EXPECT_TRUE(read(sample(ParameterKind::list), list));
  EXPECT_TRUE(read(sample(ParameterKind::map), map));
  EXPECT_TRUE(read(sample(ParameterKind::audio), audio));
  EXPECT_TRUE(read(sample(ParameterKind::rows), rows));
  EXPECT_FALSE(audio.bytes.empty());
}

TEST(Parameters, ReadNumbersFromWhatReadsAsOne) {
  std::int64_t integer = 0;
  EXPECT_TRUE(read(Value(7.0), integer));
  EXPECT_TRUE(read(Value("12"), integer));
  EXPECT_EQ(integer, 12);
  for (const auto& value : {Value(7.5), Value("x"), Value(), Value(1e300),
                            Value(List{}), Value(true)})
    EXPECT_FALSE(read(value, integer)) << to_string(value);
  double number = 0;
  EXPECT_TRUE(read(Value("0.5"), number));
  EXPECT_EQ(number, 0.5);
  EXPECT_FALSE(read(Value("half"), number));
}

TEST(Parameters, ReadTextsFromWhatCanBeSaid) {
  std::string text;
  EXPECT_TRUE(read(Value(3), text));
  EXPECT_EQ(text, "3");
  for (const auto& value : {Value(), Value(List{}), Value(Map{})})
    EXPECT_FALSE(read(value, text)) << to_string(value);
}

} // namespace
} // namespace parlour
