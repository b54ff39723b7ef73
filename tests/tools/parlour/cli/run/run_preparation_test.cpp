// Whole runs with --fresh and by voice are in run_command_test.cpp and
// tests/tools/parlour/voice/voice_start_test.py.
#include "tests/tools/parlour/command_fixture.hpp"
#include "tools/parlour/cli/run/run_preparation.hpp"
#include "tools/parlour/console/exit_code.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

class RunPreparationTest : public CommandTest {
protected:
  std::variant<Application, int> open(const std::string& app) {
    return open_for_run(places_, RunOptions{}, app, Console{out_, err_});
  }
};

TEST_F(RunPreparationTest, OpensTheApplicationOrPrintsWhyNot) {
  EXPECT_TRUE(std::holds_alternative<Application>(open("greeter")));
  const auto missing = open("nowhere");
  ASSERT_TRUE(std::holds_alternative<int>(missing));
  EXPECT_EQ(std::get<int>(missing), exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("nowhere"));
}

TEST_F(RunPreparationTest, PutsTheDatabaseFileAside) {
  const auto opened = open("greeter");
  const auto& application = std::get<Application>(opened);
  const test::TemporaryFolder data;
  data.write("greeter.db", "old");
  ASSERT_TRUE(put_databases_aside(application, data.path()));
  EXPECT_FALSE(std::filesystem::exists(data.path() / "greeter.db"));
  EXPECT_TRUE(std::filesystem::exists(data.path() / "greeter.db.before"));
}

} // namespace
} // namespace parlour::tools
