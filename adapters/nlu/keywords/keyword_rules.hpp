// The rules of KeywordNLU: their XML, checked against the application's topics.
//
//   <keywords>
//     <rule topic="Borrow">                  act="inform" unless it is said
//       <keyword>borrow</keyword>            any of these makes it apply
//       <slot name="Robot"/>                 a value of the slot, wherever it
//       is <slot name="Purpose" after="for"/>   the words behind that <slot
//       name="Urgent" value="true"/>   that
//     </rule>
//     <rule act="greet"><keyword>hello</keyword></rule>
//   </keywords>
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "adapters/nlu/values/schema.hpp"

namespace parlour::adapters::nlu {

using Words = std::vector<std::string>; // as tokenize() makes them

struct KeywordSlot {
  std::string name;
  EntityId entity = words_entity;
  Words after;                      // empty: anywhere
  std::optional<std::string> value; // nothing: what is found
};

struct KeywordRule {
  TopicNumber topic = no_topic; // none: a generic act
  std::string act;
  std::vector<Words> keywords;
  std::vector<KeywordSlot> slots;
};

struct KeywordRules {
  Schema schema;
  std::vector<KeywordRule> rules; // the first that applies counts
};

// All errors, each with its line in `file`. Reads the columns that slots name.
tl::expected<KeywordRules, std::vector<Error>>
read_keyword_rules(std::string_view text, const std::string& file,
                   const UnderstandingModel& model,
                   const ColumnReader& columns);

} // namespace parlour::adapters::nlu
