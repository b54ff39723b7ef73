#include "tests/tools/parlour/application_fixture.hpp"
#include "tools/parlour/application/understanding.hpp"

namespace parlour::tools {
namespace {

class BuildUnderstanderTest : public ApplicationTest {
protected:
  auto build(const ColumnReader& columns) const {
    folder_.write("schema.sql", guest_schema);
    const auto application = load(guest_settings, guest_topic);
    EXPECT_EQ(findings(application), "");
    return build_engine(
        application, *first_of_role(application.composition, "NLU"), columns);
  }
};

TEST_F(BuildUnderstanderTest, knows_values_of_columns_and_generic_acts) {
  const auto built = build([](const std::string&) {
    return std::vector<std::string>{"Grace Hopper"};
  });
  ASSERT_TRUE(built);
  const auto said = built->understand("I am looking for Grace Hopper");
  ASSERT_FALSE(said.acts.empty());
  EXPECT_THAT(to_string(said.acts[0]), testing::HasSubstr("Grace Hopper"));
  EXPECT_FALSE(built->understand("goodbye").acts.empty());
  EXPECT_TRUE(built->understand("xyzzy").acts.empty());
}

TEST_F(BuildUnderstanderTest, tells_every_column_that_cannot_be_read) {
  const auto built =
      build([](const std::string&) -> Expected<std::vector<std::string>> {
        return fail(ErrorKind::database, "the disk is gone");
      });
  ASSERT_FALSE(built);
  ASSERT_EQ(built.error().size(), 1u);
  EXPECT_THAT(built.error()[0].message, testing::HasSubstr("the disk is gone"));
}

} // namespace
} // namespace parlour::tools
