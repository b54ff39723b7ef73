#include <cstdio>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/support/paths.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// Where `parlour status` looks is a folder of the test's own.
class StatusCommandTest : public CommandTest {
protected:
  StatusCommandTest() {
    places_.environment =
        [this](const char* name) -> std::optional<std::string> {
      if (std::string(name) == "XDG_RUNTIME_DIR")
        return runtime_.path().string();
      return std::nullopt;
    };
  }

  // A run by pipe whose input is open as long as this is.
  class Running {
  public:
    Running(const std::string& arguments, const std::string& runtime) {
      const auto pipe = runtime + "/input";
      mkfifo(pipe.c_str(), S_IRWXU);
      input_ = open(pipe.c_str(), O_RDWR | O_CLOEXEC);
      output_ =
          popen(("XDG_RUNTIME_DIR=" + runtime + " " + test::program_path() +
                 " run " + arguments + " < " + pipe + " 2>/dev/null")
                    .c_str(),
                "r");
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    ~Running() {
      close(input_);
      pclose(output_);
    }

    // The next that the robot says.
    std::string hear() const {
      char line[100] = {};
      return std::fgets(line, sizeof line, output_) ? line : "";
    }

  private:
    int input_ = -1;
    std::FILE* output_ = nullptr;
  };

  test::TemporaryFolder runtime_;
};

TEST_F(StatusCommandTest, tells_how_a_running_application_is) {
  test::TemporaryFolder data;
  {
    const Running running(application("greeter") + " --data " +
                              data.path().string(),
                          runtime_.path().string());
    ASSERT_EQ(running.hear(), "Hello.\n");
    EXPECT_EQ(call({"status", "greeter"}), exit_code::success) << err_.str();
    EXPECT_THAT(out_.str(),
                AllOf(HasSubstr("message_centre"), HasSubstr("supervisor"),
                      HasSubstr("SQLiteDatabase")));
    EXPECT_EQ(call({"status", application("greeter")}), exit_code::success);
    EXPECT_EQ(call({"status", "--json"}), exit_code::success);
    EXPECT_THAT(out_.str(), HasSubstr("\"application\": \"greeter\""));
    EXPECT_EQ(call({"status", "butler"}), exit_code::wrong);
    EXPECT_THAT(err_.str(),
                HasSubstr("'butler' does not run; running: greeter"));
  }
  EXPECT_EQ(call({"status"}), exit_code::wrong);
}

TEST_F(StatusCommandTest, says_that_nothing_runs) {
  EXPECT_EQ(call({"status"}), exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("no application runs"));
}

} // namespace
} // namespace parlour::tools
