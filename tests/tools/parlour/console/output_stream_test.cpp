#include <cerrno>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "tools/parlour/console/output_stream.hpp"

namespace parlour::tools {
namespace {

struct Close {
  void operator()(std::FILE* file) const {
    std::fclose(file);
  }
};
using File = std::unique_ptr<std::FILE, Close>;

TEST(OutputStream, writes_what_it_is_given) {
  const File file(std::tmpfile());
  OutputStream out(file.get());
  out << "one " << 2 << '\n' << std::string(10'000, 'x') << std::flush;
  EXPECT_TRUE(out);
  EXPECT_EQ(out.trouble(), 0);
  EXPECT_EQ(std::ftell(file.get()), 10'006);
}

TEST(OutputStream, remembers_why_it_could_not) {
  const File file(std::fopen("/dev/full", "w"));
  OutputStream out(file.get());
  out << "words";
  EXPECT_FALSE(out.flush());
  errno = 0;
  EXPECT_EQ(out.trouble(), ENOSPC);
}

TEST(OutputStream, remembers_it_of_a_large_text_too) {
  const File file(std::fopen("/dev/full", "w"));
  OutputStream out(file.get());
  out << std::string(1 << 20, 'x');
  EXPECT_FALSE(out);
  EXPECT_EQ(out.trouble(), ENOSPC);
}

} // namespace
} // namespace parlour::tools
