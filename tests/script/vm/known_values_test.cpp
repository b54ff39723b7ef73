#include <gtest/gtest.h>

#include "script/vm/interpreter.hpp"
#include "script/vm/known_values.hpp"
#include "tests/script/recording_host.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

namespace {

std::shared_ptr<const Program> compiled(const std::string& declarations) {
  auto outcome = test::compile_declarations(declarations);
  EXPECT_TRUE(outcome.program)
      << (outcome.lines.empty() ? "" : outcome.lines[0]);
  return outcome.program;
}

std::optional<Value> known(const std::string& expression) {
  const auto program =
      compiled("<function name='f'><return expr='1'/></function>"
               "<var name='first' expr='1'/><var name='v' expr=\"" +
               expression + "\"/>");
  return known_values_of(*program,
                         [&](CodeId code, Host& host) {
                           return Interpreter(program).evaluate(code, {}, {},
                                                                host);
                         })
      .back();
}

TEST(KnownValues, AreThoseThatDependOnNothing) {
  EXPECT_EQ(known("7"), Value(7));
  EXPECT_EQ(known("'text'"), Value("text"));
  EXPECT_EQ(known("split('a b')"), Value(List{"a", "b"}));
  EXPECT_EQ(known("[1, 2 + 3]"), Value(List{1, 5}));
}

TEST(KnownValues, AreNotThoseThatASessionHasToCompute) {
  EXPECT_FALSE(known("random()"));
  EXPECT_FALSE(known("now()"));
  EXPECT_FALSE(known("date()"));
  EXPECT_FALSE(known("first"));
  EXPECT_FALSE(known("f()"));
  EXPECT_FALSE(known("_SESSION"));
}

TEST(KnownValues, AreNotErrors) {
  EXPECT_FALSE(known("1 + [2]"));
}

// -- how sessions use them ----------------------------------------------------

class UntouchedVariable : public testing::Test {
protected:
  Value result_of(Interpreter& interpreter, const std::string& function) {
    auto value =
        interpreter.evaluate(program->functions.at(function), {}, {}, host);
    return value ? *value : Value(value.error().message);
  }

  test::RecordingHost host;
  std::shared_ptr<const Program> program = compiled(
      "<var name='words' expr=\"split('a b')\"/>"
      "<function name='add'><var name='ignored' expr=\"append(words, 'c')\"/>"
      "<return expr='length(words)'/></function>"
      "<function name='put'><set name='words' expr='3'/>"
      "<return expr='words'/></function>"
      "<function name='longer'><param name='list'/>"
      "<set name='list' expr='length(list)'/></function>"
      "<function name='lend'><call function='longer'><var expr='words'/></call>"
      "<return expr='words'/></function>");
  Interpreter one{program}, other{program};
  bool ready = one.initialise(host) && other.initialise(host);
};

TEST_F(UntouchedVariable, TakesNoMemory) {
  EXPECT_EQ(one.bytes_held(), 0U);
  EXPECT_EQ(one.variable(0), Value(List{"a", "b"}));
  EXPECT_EQ(one.bytes_held(), 0U);
}

TEST_F(UntouchedVariable, IsEachSessionsOwn) {
  EXPECT_EQ(result_of(one, "add"), Value(3));
  EXPECT_EQ(result_of(one, "add"), Value(4));
  EXPECT_EQ(result_of(other, "add"), Value(3));
}

TEST_F(UntouchedVariable, CanBeReplacedBeforeAnybodyLooks) {
  EXPECT_EQ(result_of(one, "put"), Value(3));
  EXPECT_EQ(one.variable(0), Value(3));
}

TEST_F(UntouchedVariable, CanBeLent) {
  EXPECT_EQ(result_of(one, "lend"), Value(2));
  EXPECT_EQ(one.variable(0), Value(2));
}

TEST_F(UntouchedVariable, StaysUntouchedInASavedState) {
  auto restored = Interpreter::restore(program, one.save({}));
  ASSERT_TRUE(restored) << restored.error().message;
  EXPECT_EQ(restored->interpreter.save({}), one.save({}));
  EXPECT_EQ(restored->interpreter.bytes_held(), 0U);
  EXPECT_EQ(result_of(restored->interpreter, "add"), Value(3));
}

TEST_F(UntouchedVariable, KeepsItsChangesInASavedState) {
  result_of(one, "add");
  auto restored = Interpreter::restore(program, one.save({}));
  ASSERT_TRUE(restored) << restored.error().message;
  EXPECT_EQ(result_of(restored->interpreter, "add"), Value(4));
}

} // namespace

} // namespace parlour::script
