#include <gtest/gtest.h>

#include "tests/script/margin.hpp"
#include "tests/script/recording_host.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

namespace {

class RestoredCase : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(RestoredCase, DoesTheSameFromBytes) {
  test::expect_as_in_margin(GetParam(), &test::run_with_restores);
}

INSTANTIATE_TEST_SUITE_P(Language, RestoredCase,
                         testing::ValuesIn(test::language_cases()),
                         [](const auto& one) {
                           return test::name_of_case(one.param);
                         });

class InterpreterStateTest : public testing::Test {
protected:
  // Compiles declarations and runs `main` to its first wait or end.
  void run(const std::string& declarations,
           std::shared_ptr<const Message> message = {}) {
    program = compiled(declarations);
    interpreter.emplace(program);
    ASSERT_TRUE(interpreter->initialise(host));
    ActivationContext context;
    context.message = std::move(message);
    activation = interpreter->start(program->functions.at("main"), {}, context);
    host.answers = {Waits{}};
    result = interpreter->run(*activation, host);
  }
  static std::shared_ptr<const Program>
  compiled(const std::string& declarations) {
    auto outcome = test::compile_declarations(declarations);
    EXPECT_TRUE(outcome.program)
        << (outcome.lines.empty() ? "" : outcome.lines[0]);
    return outcome.program;
  }
  std::string saved() const {
    return interpreter->save({activation.get()});
  }
  // Goes on in a new interpreter of a program that was compiled anew.
  Value after_restore(const std::string& declarations) {
    auto restored = Interpreter::restore(compiled(declarations), saved());
    if (!restored)
      return restored.error().message;
    interpreter = std::move(restored->interpreter);
    activation = std::move(restored->activations.at(0));
    result = interpreter->resume(*activation, Value("answer"), host);
    EXPECT_EQ(result.status, RunStatus::finished) << result.error.message;
    return result.value;
  }
  std::string error_of(const std::string& bytes) const {
    const auto restored = Interpreter::restore(program, bytes);
    return restored ? "restored" : restored.error().message;
  }
  // Every byte changed, every part: an error, or a state that runs safely.
  struct Tried {
    int refused = 0;
    int restored = 0;
  };
  Tried damaged_in_all_ways();
  void try_out(const std::string& bytes, Tried& tried);

  test::RecordingHost host;
  std::shared_ptr<const Program> program;
  std::optional<Interpreter> interpreter;
  std::unique_ptr<Activation> activation;
  RunResult result;
};

TEST_F(InterpreterStateTest, WhatIsSharedStaysShared) {
  const auto script =
      "<var name='all' expr='[]'/>"
      "<function name='main'><var name='mine' expr='all'/>"
      "<var name='map' expr=\"{'k': mine}\"/><wait for='1s'/>"
      "<append name='map.k' expr='1'/><return expr='[all, mine]'/></function>";
  run(script);
  EXPECT_EQ(to_string(after_restore(script)), "[[1], [1]]");
}

TEST_F(InterpreterStateTest, ABoundParameterStaysBound) {
  const auto script =
      "<var name='g' expr='1'/><function name='main'><var name='l' expr='1'/>"
      "<call function='twice'><var expr='g'/><var expr='l'/></call>"
      "<return expr='[g, l]'/></function>"
      "<function name='twice'><param name='a'/><param name='b'/>"
      "<wait for='1s'/><set name='a' expr='a + 1'/>"
      "<set name='b' expr='b + 1'/></function>";
  run(script);
  EXPECT_EQ(to_string(after_restore(script)), "[2, 2]");
}

TEST_F(InterpreterStateTest, TheWholeMessageComesAlong) {
  Message message{.time = 1,
                  .number = 2,
                  .source = "a",
                  .command = "b",
                  .params = {Value(3)},
                  .sinks = {"c"},
                  .session = "d",
                  .correlation = 4,
                  .rounds = 5};
  run("<function name='main'><wait for='1s'/></function>",
      std::make_shared<const Message>(message));
  const auto restored = Interpreter::restore(program, saved());
  ASSERT_TRUE(restored);
  EXPECT_EQ(*restored->activations.at(0)->context().message, message);
}

TEST_F(InterpreterStateTest, TheMessageComesAlong) {
  const auto script = "<function name='main'><wait for='1s'/>"
                      "<return expr='_SOURCE + _LPARAM1'/></function>";
  auto message = std::make_shared<Message>();
  message->source = "ASR";
  message->params = {Value("hello")};
  run(script, message);
  EXPECT_EQ(after_restore(script), Value("ASRhello"));
}

TEST_F(InterpreterStateTest, AnErrorKeepsItsPlace) {
  const auto script = "<function name='main'><try>\n<var name='x' expr='1/0'/>"
                      "<catch name='e'><wait for='1s'/>"
                      "<return expr='[e.kind, e.line]'/></catch></try>"
                      "</function>";
  run(script);
  EXPECT_EQ(to_string(after_restore(script)), "[Arithmetic, 2]");
}

TEST_F(InterpreterStateTest, ASharedRowOfAResultStaysShared) {
  const auto script = "<function name='main'><var name='r' expr='unknown'/>"
                      "<querydb param='select a from t' return='r'/>"
                      "<var name='row' expr='r.rows[0]'/>"
                      "<wait for='1s'/><set name='row.a' expr='9'/>"
                      "<return expr='r.rows[0].a'/></function>";
  run(script);
  ResultSet rows;
  rows.columns = {"a"};
  rows.cells = {Value(1)};
  host.answers = {Waits{}};
  interpreter->resume(*activation, Value(rows), host);
  EXPECT_EQ(to_string(after_restore(script)), "9");
}

TEST_F(InterpreterStateTest, TheSameProgramElsewhereIsTheSame) {
  const auto script = "<function name='main'><wait for='1s'/></function>";
  run(script);
  EXPECT_EQ(compiled(script)->files.empty(), false);
  EXPECT_EQ(after_restore(script), Value());
}

TEST_F(InterpreterStateTest, AnotherProgramsBytesAreRefused) {
  run("<function name='main'><wait for='1s'/></function>");
  const auto other = after_restore(
      "<function name='main'><wait for='1s'/><print param='x'/></function>");
  EXPECT_NE(other.text().find("belongs to another program"), std::string::npos);
}

TEST_F(InterpreterStateTest, AnotherVersionIsRefused) {
  run("<function name='main'><wait for='1s'/></function>");
  auto bytes = saved();
  bytes[0] = 9;
  EXPECT_NE(error_of(bytes).find("of version 9, but only 5"),
            std::string::npos);
}

TEST_F(InterpreterStateTest, ASuspendedActivationIsSmall) {
  run("<function name='main'><var name='n' expr='1'/><wait for='1s'/>"
      "<print param='{n}'/></function>");
  EXPECT_LE(saved().size() - interpreter->save({}).size(), 32u);
}

void InterpreterStateTest::try_out(const std::string& bytes, Tried& tried) {
  auto state = Interpreter::restore(program, bytes);
  state ? ++tried.restored : ++tried.refused;
  if (!state)
    return;
  state->interpreter.limit_instructions(1000);
  state->interpreter.new_event();
  for (auto& one : state->activations)
    state->interpreter.resume(*one, Value(1), host);
  host.effects.clear();
}

InterpreterStateTest::Tried InterpreterStateTest::damaged_in_all_ways() {
  const auto whole = saved();
  Tried tried;
  for (std::size_t size = 0; size < whole.size(); ++size)
    try_out(whole.substr(0, size), tried);
  EXPECT_EQ(tried.restored, 0);
  for (std::size_t at = 9; at < whole.size(); ++at)
    for (const int change : {1, 2, 4, 7, 64, 128, 255}) {
      auto bytes = whole;
      bytes[at] = static_cast<char>(bytes[at] ^ change);
      try_out(bytes, tried);
    }
  return tried;
}

TEST_F(InterpreterStateTest, DamagedBytesNeverCrash) {
  run("<var name='g' expr=\"{'a': [1, 2.5, 'x'], 'b': 140737488355328}\"/>"
      "<function name='main'>"
      "<for each='e' in='g.a'><for name='i' from='1' to='3'>"
      "<call function='f'><var expr='g'/><var expr='e'/></call></for></for>"
      "</function>"
      "<function name='f'><param name='a'/><param name='b'/>"
      "<param name='c' expr='3'/><wait for='1s'/>"
      "<set name='a.b' expr='[a.b, b, c]'/></function>");
  ASSERT_EQ(result.status, RunStatus::waiting);
  const auto tried = damaged_in_all_ways();
  EXPECT_GT(tried.refused, 500);
  EXPECT_GT(tried.restored, 10);
}

// A parameter that is bound elsewhere writes there.
TEST_F(InterpreterStateTest, DamagedBindingsNeverCrash) {
  run("<var name='g'/><function name='main'>"
      "<for each='e' in='[1, 2, 3]'><for name='i' from='1' to='3'>"
      "<var name='v' expr='7'/>"
      "<call function='f'><var expr='v'/><var expr='g'/></call>"
      "</for></for></function>"
      "<function name='f'><param name='a'/><param name='b'/><wait for='1s'/>"
      "<set name='a' expr='5'/><set name='b' expr='[a]'/></function>");
  ASSERT_EQ(result.status, RunStatus::waiting);
  EXPECT_GT(damaged_in_all_ways().restored, 10);
}

// What stands ready for an instruction that comes after the wait.
TEST_F(InterpreterStateTest, DamagedOperandsNeverCrash) {
  run("<function name='main'><var name='m' expr=\"{'a': f(), 'b': [1, f()], "
      "'c': 'x' + f() + 1}\"/></function>"
      "<function name='f'><wait for='1s'/><return expr='2'/></function>");
  ASSERT_EQ(result.status, RunStatus::waiting);
  EXPECT_GT(damaged_in_all_ways().restored, 10);
}

} // namespace

} // namespace parlour::script
