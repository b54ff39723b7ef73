#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

TEST_F(CommandTest, schema_prints_relax_ng_or_xsd) {
  EXPECT_EQ(call({"schema"}), exit_code::success);
  EXPECT_THAT(out_.str(), HasSubstr("http://relaxng.org/ns/structure/1.0"));
  EXPECT_EQ(call({"schema", "--xsd"}), exit_code::success);
  EXPECT_THAT(out_.str(), HasSubstr("http://www.w3.org/2001/XMLSchema"));
}

TEST_F(CommandTest, what_cannot_be_printed_is_an_error) {
  out_.setstate(std::ios::badbit);
  EXPECT_EQ(call({"schema"}), exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("what is printed cannot be written"));
}

} // namespace
} // namespace parlour::tools
