#include <gtest/gtest.h>

#include "script/compiler/code/expressions/table_builder.hpp"

namespace parlour::script {

namespace {

class TableBuilderTest : public testing::Test {
protected:
  std::uint32_t found(const Box& value) {
    return *builder_.code.tables.front().find(value);
  }

  Program program_;
  Names names_;
  Findings findings_;
  CodeBuilder builder_{program_, names_, findings_, {}};
};

TEST_F(TableBuilderTest, TakesConstantsOfOneType) {
  TableBuilder table(builder_, 3);
  EXPECT_TRUE(table.takes(1, Box::small(5)));
  table.arm(Box::small(5), 50);
  EXPECT_FALSE(table.takes(2, std::nullopt));
  EXPECT_FALSE(table.takes(3, Box::small(6)));
  table.end(9);
  EXPECT_EQ(found(Box::small(5)), 50u);
  EXPECT_EQ(found(Box::small(6)), 2u);
}

TEST_F(TableBuilderTest, MayTakeAllTests) {
  TableBuilder table(builder_, 3);
  EXPECT_TRUE(table.takes(1, Box::small(5)));
  table.end(9);
  EXPECT_EQ(found(Box::small(6)), 9u);
}

TEST_F(TableBuilderTest, MayTakeNone) {
  TableBuilder table(builder_, 3);
  EXPECT_FALSE(table.takes(1, Box::number(0.5)));
  EXPECT_EQ(found(Box::small(6)), 1u);
}

} // namespace

} // namespace parlour::script
