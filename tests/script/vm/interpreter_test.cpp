#include <gtest/gtest.h>

#include "script/vm/interpreter.hpp"
#include "tests/script/recording_host.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

namespace {

class InterpreterTest : public testing::Test {
protected:
  // Functions of a script; `main` is started.
  void load(const std::string& declarations) {
    auto outcome = test::compile_declarations(declarations);
    ASSERT_TRUE(outcome.program)
        << (outcome.lines.empty() ? "" : outcome.lines[0]);
    program = outcome.program;
    interpreter.emplace(program);
    ASSERT_TRUE(interpreter->initialise(host));
  }
  std::unique_ptr<Activation> start(ActivationContext context = {}) {
    return interpreter->start(program->functions.at("main"), {},
                              std::move(context));
  }

  test::RecordingHost host;
  std::shared_ptr<const Program> program;
  std::optional<Interpreter> interpreter;
};

TEST_F(InterpreterTest, WaitsAndGoesOnWithTheOutcome) {
  load("<function name='main'><confirm question='Sure?'>"
       "<yes><return expr=\"'yes'\"/></yes>"
       "<no><return expr=\"'no'\"/></no></confirm></function>");
  host.answers = {Waits{}, Waits{}};
  auto first = start();
  auto second = start();
  EXPECT_EQ(interpreter->run(*first, host).status, RunStatus::waiting);
  EXPECT_EQ(interpreter->run(*second, host).status, RunStatus::waiting);
  EXPECT_EQ(host.effects[0].kind, EffectKind::confirm);
  EXPECT_EQ(host.effects[0].operand(0), Value("Sure?"));
  EXPECT_EQ(interpreter->resume(*second, Value(false), host).value, "no");
  EXPECT_EQ(interpreter->resume(*first, Value(true), host).value, "yes");
}

TEST_F(InterpreterTest, AWaitMayEndWithAnErrorThatACatchTakes) {
  load("<function name='main'><request module='DB' command='Ask' return='r'>"
       "<catch name='e'><return expr='e.kind'/></catch></request></function>");
  host.answers = {Waits{}};
  auto activation = start();
  EXPECT_EQ(interpreter->run(*activation, host).status, RunStatus::waiting);
  auto result = interpreter->resume(
      *activation, fail(ErrorKind::timeout, "no answer"), host);
  EXPECT_EQ(result.status, RunStatus::finished);
  EXPECT_EQ(result.value, "Timeout");
}

TEST_F(InterpreterTest, YieldsAfterASliceAndFindsItsPlaceAgain) {
  load("<function name='main'><var name='n' expr='0'/>"
       "<for name='i' from='1' to='20000'><set name='n' expr='n + 1'/></for>"
       "<return expr='n'/></function>");
  auto activation = start();
  auto result = interpreter->run(*activation, host);
  int slices = 1;
  for (; result.status == RunStatus::yielded; ++slices)
    result = interpreter->run(*activation, host);
  EXPECT_GT(slices, 2);
  EXPECT_EQ(result.value, 20000);
}

TEST_F(InterpreterTest, AnErrorHasItsPlaceAndTheScriptStack) {
  load("<function name='main'>\n<var name='x' expr='inner(0)'/></function>\n"
       "<function name='inner'><param name='n'/>\n"
       "<return expr='1 / n'/></function>");
  auto activation = start();
  const auto result = interpreter->run(*activation, host);
  EXPECT_EQ(result.status, RunStatus::failed);
  EXPECT_EQ(result.error.kind, ErrorKind::arithmetic);
  EXPECT_EQ(result.error.place.line, 4u);
  ASSERT_EQ(result.stack.size(), 2u);
  EXPECT_NE(result.stack[0].find("inner"), std::string::npos);
  EXPECT_NE(result.stack[1].find(":2)"), std::string::npos);
}

TEST_F(InterpreterTest, TheMessageIsSeenAndForwarded) {
  load("<function name='main'><post module='ASR' command='Go'/>"
       "<post module='ASR' command='Go' param=''/>"
       "<return expr=\"_SOURCE + _LPARAM1_ + length(_LPARAMS) + _STATE\"/>"
       "</function>");
  auto message = std::make_shared<Message>();
  message->source = "Mic";
  message->params = {Value("a"), Value(2)};
  ActivationContext context;
  context.message = message;
  auto activation = start(context);
  EXPECT_EQ(interpreter->run(*activation, host).value, "Mica2Welcome");
  EXPECT_EQ(host.effects[0].operand(2), Value(List{Value("a"), Value(2)}));
  EXPECT_EQ(host.effects[1].operand(2), Value(List{}));
}

TEST_F(InterpreterTest, ATimersBodyGetsTheLocalsThatItMentions) {
  load("<function name='main'><var name='a' expr='1'/><var name='b' expr='2'/>"
       "<timer name='t' after='1.5s'><post module='M' command='C' param='b'/>"
       "</timer></function>");
  auto activation = start();
  interpreter->run(*activation, host);
  const auto timer = host.effects.at(0);
  EXPECT_EQ(timer.operand(1), Value(1500));
  EXPECT_EQ(timer.captured, List{Value(2)});
  auto body = interpreter->start(timer.body, timer.captured, {});
  EXPECT_EQ(interpreter->run(*body, host).status, RunStatus::finished);
  EXPECT_EQ(host.effects.at(1).operand(2), Value(List{Value(2)}));
}

TEST_F(InterpreterTest, BranchesAreReportedForCoverage) {
  load("<function name='main'>\n<if cond='true'>\n<print param='a'/>\n"
       "<else>\n<print param='b'/></else></if></function>");
  auto activation = start();
  interpreter->run(*activation, host);
  EXPECT_EQ(host.branches, std::vector<std::uint32_t>{2});
}

TEST_F(InterpreterTest, SlotsAreReadAndSet) {
  load("<function name='main'/><topic name='T'><slot name='A'/><slot name='B'/>"
       "<filled><set name='this.B' expr=\"this.A + '!'\"/></filled></topic>");
  host.slots[0] = "x";
  ActivationContext context;
  context.topic = 0;
  auto activation = interpreter->start(program->topics[0].filled, {}, context);
  EXPECT_EQ(interpreter->run(*activation, host).status, RunStatus::finished);
  EXPECT_EQ(host.slots[1], Value("x!"));
}

TEST_F(InterpreterTest, SqlBindsWhatIsEmbedded) {
  load(
      "<function name='main'><var name='n' expr='7'/><querydb param=\"select * "
      "from t where a=? and b={n} and c='?'\" args=\"'x'\" return='r'/>"
      "<return expr='r.count'/></function>");
  ResultSet rows;
  rows.columns = {"a"};
  rows.cells = {Value(1), Value(2)};
  host.answers = {Value(rows)};
  auto activation = start();
  EXPECT_EQ(interpreter->run(*activation, host).value, 2);
  EXPECT_EQ(host.effects[0].operand(0),
            Value("select * from t where a=? and b=? and c='?'"));
  EXPECT_EQ(host.effects[0].operand(1), Value(List{Value("x"), Value(7)}));
}

TEST_F(InterpreterTest, AResultSetHasCellsRowsAndColumns) {
  load("<function name='main'><querydb param='select a, b from t' return='r'/>"
       "<var name='names' expr='[]'/>"
       "<for each='row' in='r'><append name='names' expr='row.b'/></for>"
       "<return expr=\"[r[3], r[9], r.rows[1].a, names, r.columns, "
       "column(r, 'a')]\"/></function>");
  ResultSet rows;
  rows.columns = {"a", "b"};
  rows.cells = {Value(1), Value("x"), Value(2), Value("y")};
  host.answers = {Value(rows)};
  auto activation = start();
  EXPECT_EQ(to_string(interpreter->run(*activation, host).value),
            "[y, unknown, 2, [x, y], [a, b], [1, 2]]");
}

TEST_F(InterpreterTest, EvaluateRefusesToWait) {
  load("<function name='main'><wait for='1s'/></function>");
  host.answers = {Waits{}};
  const auto value =
      interpreter->evaluate(program->functions.at("main"), {}, {}, host);
  ASSERT_FALSE(value);
  EXPECT_EQ(value.error().kind, ErrorKind::refused);
}

TEST_F(InterpreterTest, AnActivationMayOutliveItsInterpreter) {
  load("<function name='main'><var name='l' expr=\"['a', ['b']]\"/>"
       "<wait for='1s'/></function>");
  host.answers = {Waits{}};
  auto activation = start();
  interpreter->run(*activation, host);
  interpreter.reset();
  program.reset();
  activation.reset(); // AddressSanitizer would object
}

} // namespace

} // namespace parlour::script
