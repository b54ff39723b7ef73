#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/database/database_options.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;

Expected<DatabaseOptions> read(const Options& options) {
  const auto described = with_database_options({{"own", "", "an own one"}});
  DatabaseOptions made;
  OptionReader reader(options, described);
  read_database_options(reader, "/app", made);
  return reader.outcome().map([&] { return made; });
}

TEST(DatabaseOptions, HoldWithoutSettings) {
  const auto options = read({});
  ASSERT_TRUE(options);
  EXPECT_TRUE(options->schema.empty());
  EXPECT_EQ(options->busy_timeout, Milliseconds(2'000));
  EXPECT_EQ(options->transaction_timeout, Milliseconds(30'000));
  EXPECT_EQ(options->rows, 10'000u);
  EXPECT_EQ(options->bytes, 4u << 20);
}

TEST(DatabaseOptions, AreRead) {
  const auto options = read({{"schema", "a.sql"},
                             {"seed", "b.sql"},
                             {"busy-timeout", "1s"},
                             {"max-rows", "7"}});
  ASSERT_TRUE(options);
  EXPECT_EQ(options->schema, "/app/a.sql");
  EXPECT_EQ(options->seed, "/app/b.sql");
  EXPECT_EQ(options->busy_timeout, Milliseconds(1'000));
  EXPECT_EQ(options->rows, 7u);
}

TEST(DatabaseOptions, NameTheOneThatIsWrong) {
  for (const auto& [name, value] :
       {std::pair("busy-timeout", "soon"), std::pair("max-rows", "0"),
        std::pair("max-bytes", "1.5"), std::pair("schema", "../x")}) {
    const auto wrong = read({{name, value}});
    ASSERT_FALSE(wrong) << name;
    EXPECT_EQ(wrong.error().kind, ErrorKind::settings);
    EXPECT_THAT(wrong.error().message, HasSubstr(name));
  }
}

} // namespace
} // namespace parlour::adapters
