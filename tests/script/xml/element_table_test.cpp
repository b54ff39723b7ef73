#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "runtime/base/defaults.hpp"
#include "script/xml/attribute_check.hpp"
#include "script/xml/element_table.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

TEST(ElementTable, tells_elements_of_one_name_apart_by_where_they_stand) {
  const auto* declaration = find_rule("var", {"script"});
  const auto* statement = find_rule("var", {"statements"});
  const auto* argument = find_rule("var", {"arguments"});
  ASSERT_TRUE(declaration && statement && argument);
  EXPECT_TRUE(declaration->attribute("private"));
  EXPECT_FALSE(statement->attribute("private"));
  EXPECT_TRUE(argument->attribute("expr")->required);
  EXPECT_FALSE(find_rule("var", {"topic"}));
}

TEST(ElementTable, has_rows_for_all_names_where_names_are_free) {
  EXPECT_EQ(find_rule("Anything", {"sources"})->name, "*");
  EXPECT_EQ(find_rule("on", {"sources"})->name, "on");
  EXPECT_TRUE(find_rule("fact", {"facts"})->attribute("colour"));
}

TEST(ElementTable, knows_what_is_not_available_yet) {
  EXPECT_FALSE(find_rule("reload", {"statements"})->available);
  EXPECT_TRUE(find_rule("post", {"statements"})->available);
}

TEST(ElementTable, says_where_an_element_belongs) {
  EXPECT_EQ(parents_of("slot"), std::vector<std::string>{"topic"});
  EXPECT_EQ(parents_of("Plugin"), std::vector<std::string>{"Plugins"});
  EXPECT_TRUE(parents_of("nothing").empty());
}

// Every content that an element holds is what some element may be part of,
// and the other way round; every row has its sentence.
TEST(ElementTable, holds_together) {
  std::set<std::string> held{"root"}, taken{"text"};
  for (const auto& rule : element_table()) {
    held.insert(rule.holds.begin(), rule.holds.end());
    taken.insert(rule.in.begin(), rule.in.end());
  }
  for (const auto& rule : element_table()) {
    for (const auto& content : rule.in)
      EXPECT_TRUE(held.count(content)) << rule.name << " in " << content;
    for (const auto& content : rule.holds)
      EXPECT_TRUE(taken.count(content)) << rule.name << " holds " << content;
    if (rule.name != "*") {
      EXPECT_FALSE(rule.sentence.empty()) << rule.name;
    }
  }
}

// What is said of children and attributes is of some that there are.
TEST(ElementTable, names_what_it_has_in_its_rules_of_company) {
  for (const auto& rule : element_table()) {
    auto children = rule.once;
    children.insert(children.end(), rule.last.begin(), rule.last.end());
    std::vector<std::string> attributes;
    for (const auto& form : rule.forms)
      for (const auto& word : form)
        attributes.push_back(word.attribute);
    for (const auto& either : rule.either) {
      attributes.push_back(either.attribute);
      if (either.child != "text")
        children.push_back(either.child);
    }
    for (const auto& child : children)
      EXPECT_TRUE(find_rule(child, rule.holds)) << rule.name << ' ' << child;
    for (const auto& attribute : attributes)
      EXPECT_TRUE(rule.attribute(attribute)) << rule.name << ' ' << attribute;
  }
}

// Where forms differ by the words of a choice, each word has one.
TEST(ElementTable, has_a_form_for_every_word) {
  for (const auto& rule : element_table())
    for (const auto& attribute : rule.attributes) {
      std::set<std::string> words;
      bool chooses = false;
      for (const auto& form : rule.forms)
        if (const auto* word = find_word(form, attribute.name)) {
          chooses |= !word->values.empty();
          words.insert(word->values.begin(), word->values.end());
        }
      if (chooses) {
        EXPECT_EQ(words, std::set<std::string>(attribute.words.begin(),
                                               attribute.words.end()))
            << rule.name;
      }
    }
}

TEST(ElementTable, has_words_for_every_choice_and_no_attribute_twice) {
  for (const auto& rule : element_table()) {
    std::set<std::string> names;
    for (const auto& attribute : rule.attributes) {
      EXPECT_TRUE(names.insert(attribute.name).second) << attribute.name;
      EXPECT_EQ(attribute.kind == AttributeKind::choice,
                !attribute.words.empty())
          << rule.name << " " << attribute.name;
    }
  }
}

TEST(ElementTable, has_forms_of_attributes_that_are_there) {
  for (const auto& rule : element_table())
    for (const auto& form : rule.forms)
      for (const auto& part : form) {
        const auto* attribute = rule.attribute(part.attribute);
        ASSERT_TRUE(attribute) << rule.name << " " << part.attribute;
        for (const auto& value : part.values)
          EXPECT_NE(std::find(attribute->words.begin(), attribute->words.end(),
                              value),
                    attribute->words.end())
              << value;
      }
}

TEST(ElementTable, names_alternatives) {
  EXPECT_EQ(alternatives({}), "");
  EXPECT_EQ(alternatives({"a"}), "a");
  EXPECT_EQ(alternatives({"a", "b"}), "a or b");
  EXPECT_EQ(alternatives({"a", "b", "c"}), "a, b or c");
}

namespace {

// "8s" of "silence that counts as no input; else 8s".
std::string otherwise(const std::string& element, const std::string& name,
                      const std::string& content) {
  constexpr std::string_view mark = "; else ";
  const auto* attribute = find_rule(element, {content})->attribute(name);
  if (!attribute || attribute->sentence.find(mark) == std::string::npos)
    return "";
  return attribute->sentence.substr(attribute->sentence.find(mark) +
                                    mark.size());
}

Milliseconds session(const char* name) {
  return parse_duration(otherwise("sessions", name, "settings")).value();
}

std::size_t limit(const char* name) {
  return parse_size(otherwise("limits", name, "settings")).value();
}

// name="word", as it counts where nothing is said.
std::string written(const char* element, const char* name,
                    const char* content) {
  return std::string(" ") + name + "='" + otherwise(element, name, content) +
         "'";
}

} // namespace

TEST(ElementTable, tells_the_defaults_of_settings) {
  EXPECT_EQ(session("resume-after"), defaults::resume_after);
  EXPECT_EQ(session("no-input-after"), defaults::no_input_after);
  EXPECT_EQ(session("context-for"), defaults::context_for);
  EXPECT_EQ(session("request-timeout"), defaults::request_timeout);
  EXPECT_EQ(session("closes-after"), defaults::closes_after);
  EXPECT_EQ(limit("instructions"), defaults::instructions);
  EXPECT_EQ(limit("depth"), defaults::depth);
  EXPECT_EQ(limit("bytes"), defaults::session_bytes);
  EXPECT_EQ(limit("result"), defaults::result_bytes);
}

TEST(ElementTable, tells_what_topics_and_slots_are_where_nothing_is_said) {
  std::string topic;
  std::string slot;
  for (const auto* name : {"kind", "initiative", "resume"})
    topic += written("topic", name, "script");
  for (const auto* name : {"type", "confirm", "match"})
    slot += written("slot", name, "topic");
  const auto outcome = test::compile_declarations(
      "<topic name='A'><slot name='S'/></topic><topic name='B'" + topic +
      "><slot name='S'" + slot + "/></topic>");
  ASSERT_TRUE(outcome.program) << outcome.lines.front();
  const auto& silent = outcome.program->topics.at(0);
  const auto& said = outcome.program->topics.at(1);
  EXPECT_EQ(silent.kind, said.kind);
  EXPECT_EQ(silent.initiative, said.initiative);
  EXPECT_EQ(silent.resume, said.resume);
  EXPECT_EQ(silent.slots[0].functional, said.slots[0].functional);
  EXPECT_EQ(silent.slots[0].confirm, said.slots[0].confirm);
  EXPECT_EQ(silent.slots[0].match, said.slots[0].match);
}

} // namespace parlour::script
