// WatchingTest: a program that runs an application, and commands that ask it.
#pragma once

#include <cstdio>
#include <optional>
#include <string>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/support/paths.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {

// Where commands look for what runs is a folder of the test's own.
class WatchingTest : public CommandTest {
protected:
  WatchingTest() {
    places_.environment =
        [this](const char* name) -> std::optional<std::string> {
      if (std::string(name) == "XDG_RUNTIME_DIR")
        return folders_.path().string();
      return std::nullopt;
    };
  }

  // A run by pipe whose input is open as long as this is.
  class Running {
  public:
    Running(const std::string& app, const std::string& folder) {
      const auto pipe = folder + "/input";
      mkfifo(pipe.c_str(), S_IRWXU);
      input_ = open(pipe.c_str(), O_RDWR | O_CLOEXEC);
      output_ = popen(("XDG_RUNTIME_DIR=" + folder + " " +
                       test::program_path() + " run " + app + " --data " +
                       folder + "/data < " + pipe + " 2>/dev/null")
                          .c_str(),
                      "r");
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    ~Running() {
      close(input_);
      pclose(output_);
    }

    void say(const std::string& line) const {
      [[maybe_unused]] const auto size =
          write(input_, line.data(), line.size());
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

  test::TemporaryFolder folders_;
};

} // namespace parlour::tools
