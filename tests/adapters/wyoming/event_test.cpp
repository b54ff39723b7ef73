#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/wyoming/event.hpp"
#include "tests/support/paths.hpp"

namespace parlour::adapters::wyoming {
namespace {

using nlohmann::json;
using testing::HasSubstr;

// From the protocol's public description.
json vectors() {
  std::ifstream file(test::source_path("tests/adapters/wyoming/vectors.json"));
  return json::parse(file);
}

json as_json(const std::vector<Event>& events) {
  auto all = json::array();
  for (const auto& event : events)
    all.push_back({{"type", event.type},
                   {"data", event.data},
                   {"payload", event.payload}});
  return all;
}

TEST(WyomingEvent, is_read_as_the_description_says) {
  for (const auto& vector : vectors()) {
    EventReader reader;
    const auto events = reader.take(vector["bytes"].get<std::string>());
    if (vector.contains("error")) {
      ASSERT_FALSE(events) << vector["sentence"];
      EXPECT_THAT(events.error().message,
                  HasSubstr(vector["error"].get<std::string>()));
    } else {
      ASSERT_TRUE(events) << vector["sentence"];
      EXPECT_EQ(as_json(*events), vector["events"]) << vector["sentence"];
    }
  }
}

TEST(WyomingEvent, may_arrive_byte_by_byte) {
  for (const auto& vector : vectors()) {
    if (vector.contains("error"))
      continue;
    EventReader reader;
    std::vector<Event> all;
    const auto bytes = vector["bytes"].get<std::string>();
    for (const char byte : bytes) {
      const auto events = reader.take({&byte, 1});
      ASSERT_TRUE(events);
      all.insert(all.end(), events->begin(), events->end());
    }
    EXPECT_EQ(as_json(all), vector["events"]) << vector["sentence"];
  }
}

TEST(WyomingEvent, is_written_as_it_is_read) {
  const Event event{"audio-chunk", {{"rate", 16'000}}, "ab\ncd"};
  EventReader reader;
  EXPECT_EQ(as_json(*reader.take(encode(event))), as_json({event}));
  EXPECT_FALSE(reader.is_inside());
  EXPECT_EQ(encode({"describe"}), "{\"type\":\"describe\"}\n");
  EXPECT_THAT(encode({"synthesize", {{"text", "\xff"}}}), HasSubstr("\ufffd"));
}

TEST(WyomingEvent, has_a_line_that_ends) {
  EventReader reader;
  const std::string spaces(100'000, ' ');
  Expected<std::vector<Event>> taken;
  int times = 0;
  for (; times < 20 && taken; ++times)
    taken = reader.take(spaces);
  EXPECT_EQ(times, 11);
  EXPECT_THAT(taken.error().message, HasSubstr("no end"));
}

TEST(WyomingEvent, does_not_nest_deep) {
  auto nested = [](int depth) {
    return "{\"type\": \"info\", \"data\": {\"a\": " +
           std::string(static_cast<std::size_t>(depth), '[') +
           std::string(static_cast<std::size_t>(depth), ']') + "}}\n";
  };
  EXPECT_TRUE(EventReader().take(nested(EventReader::max_depth - 2)));
  EXPECT_FALSE(EventReader().take(nested(EventReader::max_depth)));
  EXPECT_FALSE(EventReader().take(nested(400'000)));
}

TEST(WyomingEvent, has_texts_of_some_length) {
  const json data = {{"text", std::string(max_text - 1, 'a') + "\u00fc"}};
  EXPECT_EQ(text_of(data, "text"), std::string(max_text - 1, 'a'));
}

TEST(WyomingEvent, has_members_of_any_type) {
  const json data = {{"text", "yes"}, {"number", 4}, {"other", json::array()}};
  EXPECT_EQ(text_of(data, "text"), "yes");
  EXPECT_EQ(text_of(data, "number"), "");
  EXPECT_EQ(number_of(data, "number", 1), 4);
  EXPECT_EQ(number_of(data, "other", 1), 1);
}

} // namespace
} // namespace parlour::adapters::wyoming
