#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tools/parlour/console/descriptor_source.hpp"

namespace parlour::tools {
namespace {

class DescriptorSourceTest : public testing::Test {
protected:
  DescriptorSourceTest() {
    EXPECT_EQ(pipe(input_), 0);
    EXPECT_EQ(pipe(interrupt_), 0);
  }
  ~DescriptorSourceTest() override {
    for (const auto end : {input_[0], interrupt_[0], interrupt_[1]})
      close(end);
  }

  int input_[2];
  int interrupt_[2];
};

TEST_F(DescriptorSourceTest, gives_bytes_and_then_the_end) {
  ASSERT_EQ(write(input_[1], "abc", 3), 3);
  close(input_[1]);
  DescriptorSource source(input_[0], interrupt_[0]);
  EXPECT_EQ(source.read(std::nullopt).bytes, "abc");
  EXPECT_EQ(source.read(std::nullopt).kind, Read::Kind::end);
}

TEST_F(DescriptorSourceTest, tells_silence) {
  DescriptorSource source(input_[0], interrupt_[0]);
  EXPECT_EQ(source.read(Milliseconds(0)).kind, Read::Kind::silence);
  close(input_[1]);
}

} // namespace
} // namespace parlour::tools
