// No built-in function and no instruction runs longer on a large value than its
// fuel says (language rule 9.6). Each of them has a row here: what it does with
// something large must cost more with something larger.
#include <algorithm>
#include <functional>
#include <map>

#include <gtest/gtest.h>

#include "script/expression/builtins.hpp"
#include "script/program/instruction.hpp"
#include "script/values/convert.hpp"
#include "script/vm/machine.hpp"
#include "tests/script/recording_host.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

namespace {

// The statements of each way to use it. The variables: `numbers` is a list,
// `twin` one that is equal, `texts` one of texts, `shared` one that holds
// `numbers` a hundred times, `text`, `blanks` and `digits` are texts, the last
// of them a number; `map` and `rows`, a result; `few`, a short list; `one`.
using Ways = std::vector<std::string>;
using Rows = std::map<std::string, Ways>;

const Rows builtins_that_walk = {
    {"upper", {"upper(text)"}},
    {"lower", {"lower(text)"}},
    {"trim", {"trim(blanks)"}},
    {"substring", {"substring(text, 0, 1)", "substring('abc', digits)"}},
    {"find", {"find(text, 'b')", "find('b', text)"}},
    {"replace", {"replace(text, 'b', '')", "replace('b', text, '')"}},
    {"split", {"split(text)", "split(text, '')", "split('a', text)"}},
    {"join", {"join(numbers)", "join(shared)", "join([1, 2], text)"}},
    {"startswith", {"startswith(text, 'a')", "startswith('a', text)"}},
    {"endswith", {"endswith(text, 'a')", "endswith('a', text)"}},
    {"contains",
     {"contains(numbers, -1)", "contains(text, 'b')", "contains('b', numbers)",
      "contains(map, shared)", "contains([twin], numbers)",
      "contains(['b', 1], digits)"}},
    {"matches", {"matches(text, 'b')"}},
    {"capture", {"capture(text, 'b')"}},
    {"format", {"format(text)", "format('{}', shared)"}},
    {"append", {"append(few, numbers)"}},
    {"insert", {"insert(few, 0, numbers)", "insert(numbers, 0, 1)"}},
    {"remove", {"remove(map, 'k1')", "remove(numbers, 0)"}},
    {"sort", {"sort(numbers)", "sort(texts)", "sort([text, text])"}},
    {"reverse", {"reverse(numbers)"}},
    {"indexof", {"indexof(numbers, -1)", "indexof([twin], numbers)"}},
    {"slice", {"slice(numbers, 0)", "slice(text, -1)"}},
    {"first", {"first(text)"}},
    {"last", {"last(text)"}},
    {"range", {"range(1, length(numbers))", "range(1, digits)"}},
    {"keys", {"keys(map)"}},
    {"values", {"values(map)"}},
    {"has", {"has(map, text)"}},
    {"abs", {"abs(digits)"}},
    {"min", {"min(numbers)", "min(texts)", "min([digits, 1])"}},
    {"max", {"max(numbers)", "max([text, text])", "max(digits, 2)"}},
    {"floor", {"floor(digits)"}},
    {"ceil", {"ceil(digits)"}},
    {"round", {"round(digits)"}},
    {"sqrt", {"sqrt(digits)"}},
    {"pow", {"pow(digits, 1)", "pow(1, digits)"}},
    {"random", {"random(0, digits)"}},
    {"number", {"number(digits)"}},
    {"integer", {"integer(digits)"}},
    {"date", {"date(text)", "date('x', digits)"}},
    {"time", {"time(text)"}},
    {"string", {"string(numbers)", "string(shared)"}},
    {"tojson", {"tojson(numbers)", "tojson(shared)", "tojson(rows)"}},
    {"fromjson", {"fromjson(text)"}},
    {"online", {"online(text)"}},
    {"count", {"count(digits, 'box')", "count(2, text)"}},
    {"ordinal", {"ordinal(digits)"}},
    {"list", {"list(numbers)", "list([text])"}},
    {"an", {"an(text)"}},
    {"spoken", {"spoken(numbers)", "spoken(text)"}},
    {"column", {"column(rows, 'name')", "column(rows, text)"}}};

const Rows builtins_that_do_not = {
    {"length", {"length(numbers)", "length(text)", "length(map)"}},
    {"first", {"first(numbers)"}},
    {"last", {"last(numbers)", "last(rows)"}},
    {"now", {"now()"}},
    {"type", {"type(shared)"}},
    {"isknown", {"isknown(shared)"}}};

std::string computed(const std::string& expression) {
  return R"x(<var name="x" expr=")x" + expression + R"x("/>)x";
}

std::string tested(const std::string& condition) {
  return R"x(<if cond=")x" + condition + R"x("/>)x";
}

const Rows instructions_that_walk = {
    {"load_slot", {computed("this.S")}},
    {"store_slot", {R"x(<set name="this.S" expr="numbers"/>)x"}},
    {"load_system", {computed("_LPARAMS")}},
    {"load_message_parameter", {computed("_LPARAM1")}},
    {"load_message_parameters", {R"x(<post module="M" command="C"/>)x"}},
    {"add",
     {computed("numbers + numbers"), computed("text + text"),
      computed("'a' + shared"), computed("numbers + 'a'")}},
    {"add_constant", {computed("text + 1")}},
    {"subtract", {computed("one - digits")}},
    {"subtract_constant", {computed("digits - 1")}},
    {"multiply", {computed("digits * one")}},
    {"multiply_constant", {computed("digits * 2")}},
    {"divide", {computed("digits / one")}},
    {"modulo", {computed("digits % one")}},
    {"modulo_constant", {computed("digits % 2")}},
    {"negate", {computed("-digits")}},
    {"equal",
     {computed("numbers == twin"), computed("digits == one"),
      computed("[text] == [text + '']"), computed("map == other"),
      computed("one == text")}},
    {"less", {computed("digits lt one"), computed("text lt text + ''")}},
    {"less_equal", {computed("digits le one")}},
    {"contained",
     {computed("-1 in numbers"), computed("'b' in text"),
      computed("shared in text"), computed("numbers in [twin]")}},
    {"jump_if_equal", {tested("numbers == twin")}},
    {"jump_if_equal_constant", {tested("digits == 5")}},
    {"jump_if_less", {tested("digits lt one")}},
    {"jump_if_less_constant", {tested("digits lt 5")}},
    {"jump_if_less_equal", {tested("digits le one")}},
    {"jump_if_less_equal_constant", {tested("digits le 5")}},
    {"jump_if_greater_constant", {tested("digits gt 5")}},
    {"jump_if_greater_equal_constant", {tested("digits ge 5")}},
    {"get_index",
     {computed("text[3]"), computed("map[shared]"), computed("few[digits]"),
      computed("map[text]")}},
    {"get_field", {computed("rows.rows")}},
    {"set_index",
     {R"x(<set name="few[0]" expr="numbers"/>)x",
      R"x(<set name="map[shared]" expr="1"/>)x",
      R"x(<set name="few[digits]" expr="1"/>)x"}},
    {"set_field", {R"x(<set name="map.k1" expr="numbers"/>)x"}},
    {"new_array",
     {R"x(<object name="a" class="array" size="length(numbers)"/>)x"}},
    {"append", {R"x(<append name="few" expr="numbers"/>)x"}},
    {"concatenate", {R"x(<log param="{shared} of {text}"/>)x"}},
    {"for_prepare", {R"x(<for name="i" from="2" to="digits"/>)x"}},
    {"each_prepare",
     {R"x(<for each="x" in="numbers"><break/></for>)x",
      R"x(<for each="x" in="text"><break/></for>)x",
      R"x(<for each="x" in="map"><break/></for>)x",
      R"x(<for each="x" in="rows"><break/></for>)x"}},
    {"raise", {R"x(<try><throw expr="shared"/><catch/></try>)x"}},
    {"effect",
     {R"x(<fire event="E" param="numbers"/>)x", R"x(<log param="{text}"/>)x",
      R"x(<fire event="E" param="map"/>)x"}}};

// What takes the same time whatever the size of its operands.
constexpr const char* instructions_that_do_not[] = {
    "load_constant", "move",          "load_parameter", "store_parameter",
    "bind_register", "bind_variable", "load_variable",  "store_variable",
    "invert",        "jump",          "loop",           "jump_if",
    "jump_if_given",
    "jump_by_table", // a text remembers its hash, which its making has paid
    "new_list",      "new_map",    // as large as the program says
    "milliseconds",  "call_named", // no more than 1000 bytes are looked at
    "call",          "call_builtin",  "give_back",      "give_unknown",
    "for_next",      "each_next",     "reached"};

constexpr const char* variables =
    "<var name='numbers'/><var name='twin'/><var name='texts'/>"
    "<var name='shared'/><var name='text'/><var name='blanks'/>"
    "<var name='digits'/><var name='map'/><var name='other'/>"
    "<var name='rows'/><var name='few'/><var name='one'/>";

// One use of something, with the topic that makes it.
struct Way {
  std::string name;
  std::string statements;
};

// A program with a topic for each way, in whose body all statements may stand.
std::shared_ptr<const Program> compiled(const std::vector<Way>& ways) {
  std::string text = variables;
  for (std::size_t i = 0; i < ways.size(); ++i)
    text += "<topic name='T" + std::to_string(i) +
            "'><slot name='S' question='?'/><completed>" + ways[i].statements +
            "</completed></topic>";
  const auto outcome = test::compile_declarations(text);
  EXPECT_TRUE(outcome.program) << testing::PrintToString(outcome.lines);
  return outcome.program;
}

std::vector<Way> ways_of(const Rows& rows, auto statements_of) {
  std::vector<Way> ways;
  for (const auto& [name, uses] : rows)
    for (const auto& use : uses)
      ways.push_back({name, statements_of(use)});
  return ways;
}

List numbers_up_to(std::size_t size) {
  List numbers;
  for (std::size_t i = 0; i < size; ++i)
    numbers.emplace_back(static_cast<std::int64_t>(i));
  return numbers;
}

Value map_of(std::size_t size) {
  Map map;
  for (std::size_t i = 0; i < size; ++i)
    map.set("k" + std::to_string(i), 1);
  return map;
}

Value rows_of(std::size_t size) {
  ResultSet rows;
  rows.columns = {"name", "number"};
  for (std::size_t i = 0; i < size; ++i)
    rows.cells.insert(rows.cells.end(), {Value("Ho"), Value(1)});
  return rows;
}

// Everything that a way may use, in one size.
Value value_of(const std::string& name, std::size_t size) {
  if (name == "numbers" || name == "twin" || name == "shared")
    return numbers_up_to(size);
  if (name == "texts")
    return List(size, Value("Ho"));
  if (name == "text")
    return std::string(size, 'a');
  if (name == "blanks")
    return std::string(size, ' ') + "a";
  if (name == "digits")
    return std::string(size, '0') + "1";
  if (name == "map" || name == "other")
    return map_of(size);
  if (name == "rows")
    return rows_of(size);
  return name == "few" ? Value(List{Value(1)}) : Value(1);
}

// Runs a topic's body and measures the fuel that it takes.
class Measured {
public:
  Measured(const std::shared_ptr<const Program>& program, TopicId topic,
           std::size_t size)
      : machine_(program) {
    machine_.instructions = 100'000'000;
    machine_.new_event();
    for (const auto& instruction : body_of(topic).instructions)
      if (instruction.operation ==
          static_cast<std::uint8_t>(Operation::load_variable))
        fill(instruction.b, size);
    host_.slots[0] = numbers_up_to(size);
    run(topic, size);
  }

  std::uint64_t instructions = 0;
  RunResult result;

private:
  const Code& body_of(TopicId topic) const {
    const auto& program = *machine_.program;
    return program.code.at(program.topics.at(topic).completed);
  }
  void fill(std::size_t index, std::size_t size) {
    const auto& name = machine_.program->variables.at(index).name;
    auto& variable = machine_.variables.at(index);
    variable = to_box(machine_.heap(), value_of(name, size));
    if (name != "shared")
      return;
    // A list that holds a long one several times, so it is short and large.
    Box shared = make_list(machine_.heap());
    shared.list()->elements.assign(10, variable);
    variable = std::move(shared);
  }
  void run(TopicId topic, std::size_t size) {
    Message message;
    message.params = {Value(numbers_up_to(size))};
    ActivationContext context;
    context.message = std::make_shared<const Message>(std::move(message));
    context.topic = topic;
    const auto body = machine_.program->topics.at(topic).completed;
    auto activation = machine_.start(body, {}, std::move(context));
    result = machine_.run(*activation, host_, true);
    instructions = machine_.instructions - machine_.event_fuel().left;
  }

  test::RecordingHost host_;
  Machine machine_;
};

constexpr std::size_t smaller = 100;
constexpr std::size_t larger = 4000;
// A byte for each element is the least that any of them has to look at; a
// tenth is left for rounding.
constexpr auto least_growth =
    WalkBudget::price_of_bytes(larger - smaller) * 9 / 10;

std::uint64_t growth(const std::shared_ptr<const Program>& program,
                     TopicId topic) {
  return Measured(program, topic, larger).instructions -
         Measured(program, topic, smaller).instructions;
}

bool has_instruction(const Program& program, TopicId topic, auto wanted) {
  const auto& code = program.code.at(program.topics.at(topic).completed);
  return std::ranges::any_of(code.instructions, wanted);
}

TEST(GiantValues, EachBuiltInCostsByTheSizeOfWhatItWalksThrough) {
  const auto ways = ways_of(builtins_that_walk, computed);
  const auto program = compiled(ways);
  ASSERT_TRUE(program);
  for (TopicId i = 0; i < ways.size(); ++i) {
    SCOPED_TRACE(ways[i].statements);
    EXPECT_TRUE(has_instruction(*program, i, [&](const Instruction& each) {
      return each.operation ==
                 static_cast<std::uint8_t>(Operation::call_builtin) &&
             each.b == *builtin_index(ways[i].name);
    }));
    EXPECT_GE(growth(program, i), least_growth);
  }
}

TEST(GiantValues, OtherBuiltInsCostTheSameWhateverTheSize) {
  const auto ways = ways_of(builtins_that_do_not, computed);
  const auto program = compiled(ways);
  ASSERT_TRUE(program);
  for (TopicId i = 0; i < ways.size(); ++i) {
    SCOPED_TRACE(ways[i].statements);
    EXPECT_EQ(growth(program, i), 0u);
    EXPECT_EQ(Measured(program, i, larger).result.status, RunStatus::finished);
  }
}

TEST(GiantValues, EachInstructionCostsByTheSizeOfWhatItWalksThrough) {
  std::map<std::string, std::uint8_t> operations;
#define INSTRUCTION(name, sentence)                                            \
  operations[#name] = static_cast<std::uint8_t>(Operation::name);
#include "script/program/instructions.def"
#undef INSTRUCTION
  const auto ways = ways_of(instructions_that_walk, std::identity());
  const auto program = compiled(ways);
  ASSERT_TRUE(program);
  for (TopicId i = 0; i < ways.size(); ++i) {
    SCOPED_TRACE(ways[i].statements);
    EXPECT_TRUE(has_instruction(*program, i, [&](const Instruction& each) {
      return each.operation == operations.at(ways[i].name);
    }));
    EXPECT_GE(growth(program, i), least_growth);
  }
}

TEST(GiantValues, NoBuiltInIsForgotten) {
  for (const auto& name : builtin_names())
    EXPECT_TRUE(builtins_that_walk.contains(name) ||
                builtins_that_do_not.contains(name))
        << name;
}

TEST(GiantValues, NoInstructionIsForgotten) {
#define INSTRUCTION(name, sentence)                                            \
  EXPECT_NE(instructions_that_walk.contains(#name),                            \
            std::ranges::count(instructions_that_do_not,                       \
                               std::string_view(#name)) > 0)                   \
      << #name;
#include "script/program/instructions.def"
#undef INSTRUCTION
}

} // namespace

} // namespace parlour::script
