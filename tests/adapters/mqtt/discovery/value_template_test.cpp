#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/mqtt/discovery/value_template.hpp"

namespace parlour::adapters::mqtt {
namespace {

using testing::HasSubstr;

std::string made(const std::string& text, const std::string& payload) {
  const auto value = ValueTemplate::parse(text);
  if (!value)
    return "error: " + value.error().message;
  return value->apply(Payload(payload)).value_or("nothing");
}

TEST(ValueTemplate, TakesThePayload) {
  EXPECT_EQ(made("{{ value }}", "ON"), "ON");
  EXPECT_EQ(made("{{value}}", " 21.5 "), "21.5");
  EXPECT_EQ(ValueTemplate().apply(Payload("ON")), "ON");
  EXPECT_EQ(made("ON", "whatever"), "ON");
}

TEST(ValueTemplate, TakesAPartOfJson) {
  const auto* json = R"({"state": "ON", "a b": {"list": [7, {"x": 2.50}]},
                         "yes": true, "none": null, "whole": 21})";
  EXPECT_EQ(made("{{ value_json.state }}", json), "ON");
  EXPECT_EQ(made("{{ value_json['state'] }}", json), "ON");
  EXPECT_EQ(made(R"({{ value_json["a b"].list[1].x }})", json), "2.5");
  EXPECT_EQ(made("{{ value_json['a b']['list'][0] }}", json), "7");
  EXPECT_EQ(made("{{ value_json.yes }}", json), "True");
  EXPECT_EQ(made("{{ value_json.none }}", json), "None");
  EXPECT_EQ(made("{{ value_json.whole }}", json), "21");
  EXPECT_EQ(made("{{ value_json['a b'].list }}", json), R"([7,{"x":2.5}])");
}

TEST(ValueTemplate, MakesNothingOfWhatIsNotThere) {
  EXPECT_EQ(made("{{ value_json.state }}", R"({"other": 1})"), "nothing");
  EXPECT_EQ(made("{{ value_json.a.b }}", R"({"a": 1})"), "nothing");
  EXPECT_EQ(made("{{ value_json[3] }}", "[1]"), "nothing");
  EXPECT_EQ(made("{{ value_json['x'] }}", "[1]"), "nothing");
  EXPECT_EQ(made("{{ value.x }}", "text"), "nothing");
}

TEST(ValueTemplate, Filters) {
  EXPECT_EQ(made("{{ value | float }}", "2"), "2");
  EXPECT_EQ(made("{{ value | int }}", "2.9"), "2");
  EXPECT_EQ(made("{{ value|float|round(1) }}", "21.449"), "21.4");
  EXPECT_EQ(made("{{ value | float | round }}", "21.5"), "22");
  EXPECT_EQ(made("{{ value | lower }}", "OFF"), "off");
  EXPECT_EQ(made("{{ value | upper }}", "off"), "OFF");
  EXPECT_EQ(made("{{ value_json.x | string }}", R"({"x": true})"), "True");
  EXPECT_EQ(made("{{ value_json.x | default('OFF') }}", "{}"), "OFF");
  EXPECT_EQ(made("{{ value_json.x | default(0) | int }}", "{}"), "0");
  EXPECT_EQ(made("{{ value_json.x | is_defined }}", "{}"), "nothing");
  EXPECT_EQ(made("{{ value | int(3) }}", "many"), "3");
  EXPECT_EQ(made("{{ value | float }}", "many"), "nothing");
  // What is too large for a whole number stays one with a fraction.
  EXPECT_EQ(made("{{ value | int }}", "1e300"), "1e+300");
  EXPECT_EQ(made("{{ value_json.x | round(1e308) }}", R"({"x": 1.5})"), "1.5");
}

TEST(ValueTemplate, HasTextsBesideIt) {
  EXPECT_EQ(made(R"({"t": {{ value }}, "u": "{{ value | int }}"})", "20.5"),
            R"({"t": 20.5, "u": "20"})");
}

TEST(ValueTemplate, RefusesWhatItDoesNotKnow) {
  for (const auto* text :
       {"{% if value == 'x' %}a{% endif %}", "{{ value + 1 }}",
        "{{ states('x')", "{{ now() }}", "{{ value_json. }}",
        "{{ value_json[ }}", "{{ value_json['a }}",
        "{{ value | timestamp_local }}", "{{ }}", "{{", "{{ value }",
        "{{ value_json[-1] }}", "{{ value | round(x) }}",
        "{# note #}{{ value }}", "{{ value ~ 'x' }}"})
    EXPECT_THAT(made(text, "{}"), HasSubstr("is not supported")) << text;
  EXPECT_THAT(made("{{ 'ON' if value else 'OFF' }}", "1"),
              HasSubstr("'{{ value_json.name }}'"));
}

TEST(ValueTemplate, SaysThatThePayloadIsBroken) {
  const Payload broken("{\"state\": ");
  const auto state = *ValueTemplate::parse("{{ value_json.state }}");
  EXPECT_FALSE(state.apply(broken));
  EXPECT_TRUE(broken.is_broken());
  const Payload plain("ON");
  EXPECT_TRUE(ValueTemplate().apply(plain));
  EXPECT_FALSE(plain.is_broken());
}

} // namespace
} // namespace parlour::adapters::mqtt
