// Starts every language case that stops on its way in one process, and finishes
// it in another. The first process writes the states to files and starts this
// program again; the second writes the results to files of the same names.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include <gtest/gtest.h>

#include "adapters/files/data_files.hpp"
#include "tests/script/margin.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

namespace {

namespace fs = std::filesystem;

constexpr const char* states_of_the_first = "PARLOUR_TEST_STATES";
// Of one step: a script stops at every loop and call.
constexpr std::uint64_t slice = 1;

struct Case {
  std::string name;
  std::shared_ptr<const Program> program;
};

// Those that compile.
std::vector<Case> programs() {
  std::vector<Case> all;
  for (const auto& file : test::language_cases())
    if (auto compiled = compile_file(file, test::platform()); compiled.program)
      all.push_back({test::name_of_case(file), std::move(compiled.program)});
  return all;
}

std::string all_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write_all(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

// A run of one case in a folder of its own.
struct CaseRun {
  CaseRun(Case begun, const fs::path& folder)
      : one(std::move(begun)), state(folder / (one.name + ".state")),
        outcome(folder / (one.name + ".outcome")),
        options(stage.options(
            test::run_instructions,
            adapters::data_files(folder / (one.name + ".data")))) {}
  CaseRun(const CaseRun&) = delete; // the options refer to the stage
  CaseRun& operator=(const CaseRun&) = delete;

  Case one;
  fs::path state;
  fs::path outcome;
  test::Stage stage;
  ExecOptions options;

  std::unique_ptr<ExecRun> start() const {
    auto run = std::make_unique<ExecRun>(one.program, options);
    run->set_slice(slice);
    return run;
  }
  // What is told of an ended run: all that it printed, how it failed, and
  // every byte of what it holds.
  std::string tell(const ExecRun& run) const {
    const auto result = stage.result(run);
    auto text = result.printed;
    for (const auto& [line, error] : result.errors)
      text += std::to_string(line) + ": " + error + '\n';
    return run.failure() ? text : text + run.save();
  }
};

void step(ExecRun& run, int count) {
  for (; count > 0 && run.step(); --count) {
  }
}

int steps_of(ExecRun& run) {
  int count = 0;
  while (run.step())
    ++count;
  return count;
}

void end_in_this_process(const fs::path& folder) {
  for (auto& one : programs()) {
    CaseRun second(std::move(one), folder);
    if (!fs::exists(second.state))
      continue;
    auto run = ExecRun::restore(second.one.program, second.options,
                                all_of(second.state));
    ASSERT_TRUE(run) << run.error().message;
    (*run)->set_slice(slice);
    second.stage.clock = (*run)->now();
    steps_of(**run);
    write_all(second.outcome, second.tell(**run));
  }
}

// With the folder in its environment; ctest tells this process to run half of
// the tests, but the other has only one.
bool end_in_another_process(const fs::path& folder) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto command = "env -u GTEST_TOTAL_SHARDS -u GTEST_SHARD_INDEX " +
                       std::string(states_of_the_first) + "='" +
                       folder.string() + "' '" +
                       fs::read_symlink("/proc/self/exe").string() +
                       "' --gtest_filter=" + test->test_suite_name() + "." +
                       test->name() + " > '" + (folder / "log").string() + "'";
  return std::system(command.c_str()) == 0;
}

TEST(SecondProcess, EndsWhatTheFirstBegan) {
  if (const auto* folder = std::getenv(states_of_the_first))
    return end_in_this_process(folder);
  const test::TemporaryFolder whole;
  const test::TemporaryFolder begun;
  struct Expected {
    std::string printed; // by the first
    std::string outcome; // of both
  };
  std::map<fs::path, Expected> expected;
  for (const auto& one : programs()) {
    CaseRun at_once(one, whole.path());
    const auto run = at_once.start();
    const auto steps = steps_of(*run);
    if (steps < 2)
      continue;
    CaseRun first(one, begun.path());
    const auto half = first.start();
    step(*half, steps / 2);
    write_all(first.state, half->save());
    expected[first.outcome] = {first.stage.printed, at_once.tell(*run)};
  }
  ASSERT_GT(expected.size(), 80u);
  ASSERT_TRUE(end_in_another_process(begun.path())) << begun.read("log");
  for (const auto& [outcome, both] : expected)
    EXPECT_EQ(both.printed + all_of(outcome), both.outcome) << outcome;
}

} // namespace

} // namespace parlour::script
