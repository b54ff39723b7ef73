// Every element, built-in function and role has an example, and each example is
// correct: `check` finds nothing, and functions give the written result.
#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "runtime/message/roles.hpp"
#include "runtime/plugin/parameters.hpp"
#include "script/expression/builtins.hpp"
#include "script/run/exec_run.hpp"
#include "script/xml/validator.hpp"
#include "tests/script/snippets.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tools/parlour/command_fixture.hpp"
#include "tools/parlour/reference/entry_text.hpp"
#include "tools/parlour/reference/examples.hpp"

namespace parlour::tools {
namespace {

using script::Element;
using script::ElementRule;
using testing::HasSubstr;

// The application around an example: components, a table, and an agent that
// fills every role.
constexpr const char* settings = R"(<settings name="example"START>
  <Plugins>
    <Plugin>GrammarNLU</Plugin>
    <Plugin>PhraseNLG</Plugin>
    <Plugin>SQLiteDatabase</Plugin>
    <Plugin>LogTelephone</Plugin>
    <Plugin>LogRobot</Plugin>
  </Plugins>
  <component name="SQLiteDatabase">
    <option name="schema" value="schema.sql"/>
  </component>
  <Scripts><Script>museum.xml</Script></Scripts>
  <agents><agent name="Porter" roles="ROLES"/></agents>
</settings>
)";
constexpr const char* schema =
    "create table room (number integer primary key, guest text);\n";

std::string script_of(const ElementExample& example) {
  if (example.around == Around::statements)
    return "<dialogue><state name='Start'><Entrance>" + example.xml +
           "</Entrance></state></dialogue>";
  if (example.around == Around::script)
    return "<dialogue>" + example.xml + "</dialogue>";
  return example.xml.starts_with("<dialogue>")
             ? example.xml
             : "<dialogue><state name='Welcome'/></dialogue>";
}

// Settings whose start is the script's first state.
std::string settings_for(const std::string& script) {
  std::smatch state;
  const auto start =
      std::regex_search(script, state, std::regex("<state name=['\"](\\w+)"))
          ? " start='" + state.str(1) + "'"
          : "";
  std::string all_roles;
  for (const auto& role : roles())
    if (!role.reserved)
      all_roles += role.name + ' ';
  return std::regex_replace(
      std::regex_replace(std::string(settings), std::regex("START"), start),
      std::regex("ROLES"), all_roles);
}

std::string root_of(const ElementExample& example) {
  return example.around == Around::nothing ? example.xml : script_of(example);
}

void collect(const Element& element, const ElementRule& rule,
             std::set<std::string>& names) {
  names.insert(example_name(rule));
  for (const auto& child : element.children)
    if (const auto* inside = rule.child(child.name))
      collect(child, *inside, names);
}

// The names of all elements in an example.
std::set<std::string> names_in(const ElementExample& example) {
  std::set<std::string> names;
  const auto root = test::tree_of(root_of(example));
  if (const auto* rule = script::find_rule(root.name, {"root"}))
    collect(root, *rule, names);
  return names;
}

bool is_available(const ElementExample& example) {
  return std::ranges::none_of(script::element_table(), [&](const auto& rule) {
    return !rule.available &&
           std::ranges::count(example.names, example_name(rule)) > 0;
  });
}

std::string page_of(const std::string& path) {
  std::ifstream file(test::source_path(path));
  return {std::istreambuf_iterator<char>(file), {}};
}

// The part of a page that a rule or a file name means; empty if there is none.
std::string told_part(const std::string& told) {
  const bool is_engine = told.starts_with("engine ");
  const auto number = is_engine ? told.substr(7) : told;
  if (told.find('/') != std::string::npos)
    return page_of(told);
  const auto page =
      page_of(is_engine ? "docs/engine.md" : "script/LANGUAGE.md");
  const auto start =
      page.find(is_engine ? "\n### " + number + " " : "\n**" + number + "**");
  if (start == std::string::npos)
    return "";
  const auto end = page.find(is_engine ? "\n### " : "\n**", start + 1);
  return page.substr(start, end - start);
}

class ElementExamples : public CommandTest {
protected:
  // The findings of `check` about an application with the example.
  std::string checked(const ElementExample& example) {
    test::TemporaryFolder folder;
    const auto script = script_of(example);
    folder.write("settings.xml", example.xml.starts_with("<settings")
                                     ? example.xml
                                     : settings_for(script));
    folder.write("museum.xml", script);
    folder.write("schema.sql", schema);
    EXPECT_NE(call({"check", folder.path().string()}), exit_code::usage);
    return out_.str();
  }
};

TEST_F(ElementExamples, are_there_for_every_element) {
  for (const auto& rule : script::element_table())
    EXPECT_TRUE(example_of(rule))
        << "no EXAMPLE for \"" << example_name(rule)
        << "\" in tools/parlour/reference/element_examples.def";
}

TEST_F(ElementExamples, hold_what_they_are_of) {
  for (const auto& example : element_examples()) {
    const auto there = names_in(example);
    for (const auto& name : example.names)
      EXPECT_EQ(there.count(name), 1u) << name << " in\n" << example.xml;
  }
}

TEST_F(ElementExamples, are_checked_without_a_finding) {
  for (const auto& example : element_examples()) {
    if (is_available(example))
      EXPECT_EQ(checked(example), "") << example.xml;
    else
      EXPECT_THAT(checked(example), HasSubstr("is not available yet"));
  }
}

// Including elements of the platform's own files.
TEST_F(ElementExamples, are_what_the_table_allows) {
  for (const auto& example : element_examples()) {
    script::Findings findings;
    auto root = test::tree_of(root_of(example));
    EXPECT_TRUE(script::validate(root, {root.name}, findings)) << example.xml;
    EXPECT_EQ(findings.all().empty(), is_available(example)) << example.xml;
  }
}

TEST_F(ElementExamples, are_told_of_where_they_say) {
  for (const auto& example : element_examples()) {
    const auto part = told_part(example.told);
    EXPECT_TRUE(std::ranges::any_of(example.names,
                                    [&](const auto& name) {
                                      const auto tag =
                                          "<" + name.substr(0, name.find('@'));
                                      return part.find(tag) !=
                                             std::string::npos;
                                    }))
        << example.told << " does not tell of " << example.names.front();
  }
}

void expect_narrow(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    EXPECT_LE(line.size() + 2, text_width) << line;
}

TEST_F(ElementExamples, fit_in_a_terminal) {
  for (const auto& example : element_examples())
    expect_narrow(example.xml);
  for (const auto& example : role_examples())
    expect_narrow(example.xml);
}

ElementExample as_of_element(const RoleExample& example) {
  return {{}, "", example.around, example.xml};
}

// Whether a message of the example goes to the role or comes from it.
bool speaks_with(const Element& element, const std::string& role) {
  static const std::set<std::string> ways{"module", "source", "to"};
  const bool names_it =
      element.is(role) ||
      std::ranges::any_of(element.attributes, [&](const auto& attribute) {
        return ways.contains(attribute.name) && attribute.value == role;
      });
  return names_it || std::ranges::any_of(element.children, [&](auto& child) {
           return speaks_with(child, role);
         });
}

TEST_F(ElementExamples, of_roles_are_there_for_every_role) {
  for (const auto& role : roles())
    EXPECT_TRUE(role_example(role.name))
        << "no EXAMPLE for \"" << role.name
        << "\" in tools/parlour/reference/role_examples.def";
  EXPECT_EQ(role_examples().size(), roles().size());
}

TEST_F(ElementExamples, of_roles_are_checked_without_a_finding) {
  for (const auto& example : role_examples())
    EXPECT_EQ(checked(as_of_element(example)), "") << example.xml;
}

TEST_F(ElementExamples, of_roles_speak_with_what_they_are_of) {
  for (const auto& example : role_examples())
    // The SQL of an application is posted to its database by the engine.
    EXPECT_TRUE(speaks_with(test::tree_of(script_of(as_of_element(example))),
                            example.role) ||
                example.role == "Database")
        << example.xml;
}

std::string escaped(std::string text) {
  text = std::regex_replace(text, std::regex("&"), "&amp;");
  text = std::regex_replace(text, std::regex("<"), "&lt;");
  return std::regex_replace(text, std::regex("\""), "&quot;");
}

// The printed result or the error, on 21 November 2026 at nine.
std::string evaluated(const std::string& expression) {
  const auto outcome = test::compile_declarations(
      "<function name='main'><var name='x' expr=\"" + escaped(expression) +
      "\"/><print param='{x}'/></function>");
  if (!outcome.program)
    return outcome.lines.front();
  std::string printed;
  script::ExecOptions options;
  options.print = [&](auto text) { printed = text; };
  options.now = [] { return Timestamp{1'795'251'600'000}; };
  options.instructions = 100'000;
  const auto failure = script::run_main(outcome.program, options);
  return failure ? failure->error.message : printed;
}

TEST(FunctionExamples, AreThereForEveryFunction) {
  for (const auto& name : script::builtin_names()) {
    const auto* example = example_of(std::string_view(name));
    ASSERT_TRUE(example)
        << "no FUNCTION for \"" << name
        << "\" in tools/parlour/reference/function_examples.def";
    EXPECT_FALSE(example->trials.empty()) << name;
    EXPECT_THAT(told_part(example->told), HasSubstr(name));
  }
  EXPECT_EQ(function_examples().size(), script::builtin_names().size());
}

TEST(FunctionExamples, NameAsManyParametersAsTheFunctionTakes) {
  for (const auto& example : function_examples()) {
    std::size_t needed = 0;
    std::size_t most = 0;
    for (const auto& parameter : read_parameters(example.parameters)) {
      const bool repeats = parameter.repeats || parameter.name == "...";
      needed += parameter.optional || repeats ? 0 : 1;
      most += repeats ? 255 : 1;
    }
    const auto index = script::builtin_index(example.name);
    ASSERT_TRUE(index) << example.name;
    EXPECT_EQ(needed, script::builtin(*index).minimum) << example.name;
    EXPECT_EQ(std::min<std::size_t>(most, 255), script::builtin(*index).maximum)
        << example.name;
  }
}

TEST(FunctionExamples, GiveWhatIsWritten) {
  for (const auto& example : function_examples())
    for (const auto& trial : example.trials) {
      EXPECT_EQ(evaluated(trial.expression), trial.result) << trial.expression;
      EXPECT_THAT(trial.expression, HasSubstr(example.name + "("));
    }
}

} // namespace
} // namespace parlour::tools
