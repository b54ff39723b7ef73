// The rules of KeywordNLU: their XML, checked against the application's topics.
//
//  <keywords>
//    <rule topic="Borrow">                   act="inform" is the default
//      <keyword>borrow</keyword>             any keyword makes the rule apply
//      <slot name="Robot"/>                  a value, anywhere in the text
//      <slot name="Purpose" after="for"/>    the words behind "for"
//      <slot name="Urgent" value="true"/>    this value
//    </rule>
//    <rule act="greet"><keyword>hello</keyword></rule>
//  </keywords>
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "adapters/nlu/values/schema.hpp"

namespace parlour::adapters::nlu {

// As tokenize() makes them.
using Words = std::vector<std::string>;

struct KeywordSlot {
  std::string name;
  EntityId entity = words_entity;
  // The words after which the value stands; empty: anywhere.
  Words after;
  // The rule's own value; nothing: what is found in the text.
  std::optional<std::string> value;
};

// A rule applies if one of its keywords occurs in the text.
struct KeywordRule {
  // no_topic for a generic act.
  TopicNumber topic = no_topic;
  std::string act;
  std::vector<Words> keywords;
  std::vector<KeywordSlot> slots;
};

// The rules of one file, with the topics they refer to.
struct KeywordRules {
  Schema schema;
  // In the order of the file. Of several about one topic, the first that
  // applies counts.
  std::vector<KeywordRule> rules;
};

// Parses the rules. Returns all errors, each with its line in `file`, if there
// are any. Reads the columns that slots name.
tl::expected<KeywordRules, std::vector<Error>>
read_keyword_rules(std::string_view text, const std::string& file,
                   const UnderstandingModel& model,
                   const ColumnReader& columns);

} // namespace parlour::adapters::nlu
