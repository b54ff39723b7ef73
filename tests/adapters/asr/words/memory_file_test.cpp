#include <fstream>

#include <gtest/gtest.h>

#include "adapters/asr/words/memory_file.hpp"

namespace parlour::adapters::asr {
namespace {

TEST(MemoryFileTest, IsReadByItsPath) {
  const auto file = MemoryFile::make("one two");
  ASSERT_TRUE(file);
  std::ifstream stream(file->path());
  std::string text;
  std::getline(stream, text);
  EXPECT_EQ(text, "one two");
  EXPECT_EQ(file->text(), "one two");
}

TEST(MemoryFileTest, IsGoneWithItsObject) {
  auto file = MemoryFile::make("x");
  const auto path = file->path();
  auto other = std::move(*file);
  EXPECT_EQ(other.text(), "x");
  { const auto last = std::move(other); }
  EXPECT_FALSE(std::ifstream(path).is_open());
}

} // namespace
} // namespace parlour::adapters::asr
