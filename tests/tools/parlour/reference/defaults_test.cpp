// The defaults of attributes in the reference ("; else 8s") are true: writing
// the default leads to the same program, and another value to a different one.
// Defaults of statements take effect at run time and have language cases.
#include <algorithm>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>

#include "script/compiler/compiler.hpp"
#include "script/xml/element_table.hpp"
#include "tests/script/snippets.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/parlour/reference/examples.hpp"

namespace parlour::tools {
namespace {

using script::AttributeKind;
using script::AttributeRule;
using script::ElementRule;

// An attribute with a default that can be written, and another value.
struct Row {
  const ElementRule* rule;
  const AttributeRule* attribute;
  std::string value;
  std::string other;
};

bool is_a_word_of(const AttributeRule& attribute, const std::string& word) {
  return std::ranges::count(attribute.words, word) > 0;
}

// Empty if the sentence has no value, such as "half of …".
std::string default_of(const AttributeRule& attribute) {
  std::smatch found;
  static const std::regex says("else ([A-Za-z0-9.:]+)");
  if (!std::regex_search(attribute.sentence, found, says))
    return "";
  const auto word = found.str(1);
  const bool begins_with_digit = word.front() >= '0' && word.front() <= '9';
  return begins_with_digit || word == "true" || word == "false" ||
                 is_a_word_of(attribute, word)
             ? word
             : "";
}

std::string other_than(const AttributeRule& attribute,
                       const std::string& value) {
  for (const auto& word : attribute.words)
    if (word != value)
      return word;
  if (attribute.kind == AttributeKind::boolean)
    return value == "true" ? "false" : "true";
  return "7" + value; // 1 -> 71, 8s -> 78s
}

bool is_statement(const ElementRule& rule) {
  return std::ranges::count(rule.in, "statements") > 0;
}

std::vector<Row> rows() {
  std::vector<Row> all;
  for (const auto& rule : script::element_table())
    for (const auto& attribute : rule.attributes)
      if (const auto value = default_of(attribute);
          !value.empty() && rule.available && !is_statement(rule))
        all.push_back({&rule, &attribute, value, other_than(attribute, value)});
  return all;
}

// The example with that attribute, or (empty) without, in the first such
// element.
std::string written(const Row& row, const std::string& value) {
  const auto& name = row.attribute->name;
  auto xml = std::regex_replace(example_of(*row.rule)->xml,
                                std::regex("\\s" + name + "=\"[^\"]*\""), "");
  if (value.empty())
    return xml;
  return std::regex_replace(xml, std::regex("<" + row.rule->name + "\\b"),
                            "$& " + name + "=\"" + value + "\"",
                            std::regex_constants::format_first_only);
}

void print(std::ostream& out, const script::Topic& topic) {
  out << int(topic.kind) << int(topic.initiative) << int(topic.resume)
      << int(topic.summary);
  for (const auto& slot : topic.slots) {
    out << slot.functional << int(slot.confirm) << int(slot.match);
    for (const auto* bodies : {&slot.no_input, &slot.no_match})
      for (const auto& body : *bodies)
        out << body.count << ' ';
  }
  for (const auto& query : topic.queries)
    for (const auto& by : query.by)
      out << int(by.match);
}

void print(std::ostream& out, const Settings& settings) {
  const auto& [resume, no_input, context, request, rest, closes, strict, keep] =
      settings.sessions;
  for (const auto time :
       {resume, no_input, context, request, rest, closes, keep})
    out << time.count() << ' ';
  out << strict << ' ';
  const auto& [instructions, depth, bytes, result] = settings.limits;
  out << instructions << ' ' << depth << ' ' << bytes << ' ' << result << '\n'
      << settings.agents.lines << ' ' << settings.agents.zeromq << '\n';
}

// Everything in a program that a default may change.
std::string fingerprint(const script::Program& program) {
  std::ostringstream out;
  print(out, program.settings);
  for (const auto& state : program.states)
    out << int(state.capture);
  for (const auto& topic : program.topics)
    print(out, topic);
  for (const auto& repair : program.repairs)
    out << repair.count << ' ';
  return out.str();
}

std::string compiled(const ElementExample& example, const std::string& xml) {
  const bool is_settings = xml.starts_with("<settings");
  const auto script =
      is_settings ? "<dialogue><state name='Welcome'/></dialogue>"
      : example.around == Around::statements
          ? "<dialogue><function name='f'>" + xml + "</function></dialogue>"
          : "<dialogue>" + xml + "</dialogue>";
  test::TemporaryFolder folder;
  folder.write("museum.xml", script);
  folder.write("settings.xml",
               is_settings ? xml
                           : "<settings name='a'><Scripts><Script>museum.xml"
                             "</Script></Scripts></settings>");
  const auto outcome =
      script::compile_application(folder.path(), test::platform());
  if (outcome.program)
    return fingerprint(*outcome.program);
  ADD_FAILURE() << outcome.findings.all().front().message << " in\n" << xml;
  return "";
}

TEST(Defaults, are_those_that_the_reference_tells) {
  const auto all = rows();
  EXPECT_GT(all.size(), 15u);
  for (const auto& row : all) {
    SCOPED_TRACE(example_name(*row.rule) + " " + row.attribute->name);
    const auto& example = *example_of(*row.rule);
    const auto without = compiled(example, written(row, ""));
    EXPECT_EQ(without, compiled(example, written(row, row.value)));
    EXPECT_NE(without, compiled(example, written(row, row.other))) << row.other;
  }
}

} // namespace
} // namespace parlour::tools
