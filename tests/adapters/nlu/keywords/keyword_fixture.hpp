// A desk that lends robots: its topics, columns and keyword rules.
#pragma once

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/nlu/keywords/keyword_rules.hpp"

namespace parlour::adapters::nlu {

inline constexpr const char* desk_xml = R"(<keywords>
  <!-- what the desk does -->
  <rule topic="Borrow">
    <keyword>borrow</keyword>
    <keyword>book a robot</keyword>
    <slot name="Robot"/>
    <slot name="Day"/>
    <slot name="Purpose" after="for"/>
  </rule>
  <rule topic="Where">
    <keyword>where</keyword>
    <slot name="Robot" after="is"/>
    <slot name="Skill"/>
  </rule>
  <rule topic="Where">
    <keyword>anything at all</keyword>
    <slot name="Skill" value="any"/>
  </rule>
  <rule act="greet"><keyword>good morning</keyword></rule>
</keywords>)";

inline UnderstandingModel desk_model() {
  UnderstandingModel model;
  model.topics = {
      {"Borrow",
       false,
       {{"Robot", "", {}, "db:robot.name", false, false},
        {"Day", "date", {}, "", false, false},
        {"Purpose", "", {}, "", false, false}},
       {}},
      {"Where",
       true,
       {{"Robot", "", {}, "db:robot.name", false, false},
        {"Skill", "set", {"grasping", "talking"}, "", false, false}},
       {}}};
  return model;
}

inline ColumnReader desk_columns() {
  return [](const std::string&) {
    return Expected<std::vector<std::string>>(
        std::vector<std::string>{"Rover", "Spot", "Red Fox", "Grey Fox"});
  };
}

inline KeywordRules desk_rules() {
  auto read = read_keyword_rules(desk_xml, "keywords.xml", desk_model(),
                                 desk_columns());
  if (!read)
    throw std::runtime_error(to_string(read.error().front()));
  return std::move(*read);
}

} // namespace parlour::adapters::nlu
