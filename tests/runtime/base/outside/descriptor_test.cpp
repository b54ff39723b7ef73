#include <utility>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "runtime/base/outside/descriptor.hpp"

namespace parlour {
namespace {

// The other end of a pipe is hung up once the last descriptor of this end is
// closed.
class DescriptorTest : public testing::Test {
protected:
  DescriptorTest() {
    int ends[2] = {-1, -1};
    EXPECT_EQ(pipe2(ends, O_CLOEXEC | O_NONBLOCK), 0);
    reading = Descriptor(ends[0]);
    writing = Descriptor(ends[1]);
  }
  bool is_closed() const {
    char byte = 0;
    return read(reading.get(), &byte, 1) == 0;
  }

  Descriptor reading;
  Descriptor writing;
};

TEST_F(DescriptorTest, IsClosedByItsOwner) {
  EXPECT_FALSE(is_closed());
  { const Descriptor owner(std::move(writing)); }
  EXPECT_TRUE(is_closed());
}

TEST_F(DescriptorTest, MovesToItsNextOwner) {
  Descriptor owner;
  EXPECT_FALSE(owner);
  owner = std::move(writing);
  EXPECT_TRUE(owner);
  EXPECT_FALSE(is_closed());
  owner = Descriptor();
  EXPECT_TRUE(is_closed());
}

TEST_F(DescriptorTest, CanBeGivenAway) {
  const int number = writing.get();
  EXPECT_EQ(writing.release(), number);
  EXPECT_FALSE(writing);
  writing = Descriptor();
  EXPECT_FALSE(is_closed());
  close(number);
  EXPECT_TRUE(is_closed());
}

} // namespace
} // namespace parlour
