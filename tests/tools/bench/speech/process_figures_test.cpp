#include <algorithm>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tools/bench/speech/process_figures.hpp"

namespace parlour::tools {
namespace {

TEST(ProcessFigures, count_children) {
  int pipe_ends[2];
  ASSERT_EQ(pipe(pipe_ends), 0);
  const auto child = fork();
  if (child == 0) {
    close(pipe_ends[1]);
    char none = 0;
    _exit(read(pipe_ends[0], &none, 1) > 0);
  }
  const auto children = child_processes();
  EXPECT_EQ(std::ranges::count(children, child), 1);
  EXPECT_GT(process_figures().mebibytes, resident_mebibytes(getpid()));
  EXPECT_GT(process_figures().cpu_seconds, 0);
  close(pipe_ends[1]);
  close(pipe_ends[0]);
  waitpid(child, nullptr, 0);
  EXPECT_EQ(resident_mebibytes(0), 0);
}

} // namespace
} // namespace parlour::tools
