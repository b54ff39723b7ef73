#include "adapters/database/mariadb/mariadb_columns.hpp"
#include "tests/adapters/database/mariadb_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class MariaDBColumnsTest : public MariaDBTest {
protected:
  Expected<std::vector<std::string>> read(const Options& options,
                                          const std::string& column) {
    return mariadb_column_reader(options, host.application)(column);
  }
};

TEST_F(MariaDBColumnsTest, AreOfTheServer) {
  ASSERT_TRUE(start(options_for("columns")));
  write("insert into staff (name) values ('Ong')");
  const auto names = read(options_for("columns"), "db:staff.name");
  ASSERT_TRUE(names);
  EXPECT_THAT(*names,
              ElementsAre("Dr. Jeffery Ho", "Lim", "Ong", "Tan Ah Kow"));
}

TEST_F(MariaDBColumnsTest, AreOfSchemaAndSeedWhereNothingIsMadeYet) {
  for (const auto& given : {options(), options_for("not_made")})
    EXPECT_THAT(read(given, "staff.level").value(), ElementsAre("13"));
}

TEST_F(MariaDBColumnsTest, SayWhatIsWrong) {
  ASSERT_TRUE(start(options_for("wrong")));
  EXPECT_FALSE(read(options_for("wrong"), "staff; drop"));
  const auto missing = read(options_for("wrong"), "staff.nam");
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().message, HasSubstr("'staff.nam' cannot be read"));
}

} // namespace
} // namespace parlour::adapters
