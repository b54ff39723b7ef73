#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/database/sqlite/sqlite_options.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;

TEST(SQLiteOptions, HaveDefaults) {
  auto options = read_sqlite_options({}, "/data", "/app");
  ASSERT_TRUE(options);
  EXPECT_TRUE(options->in_memory());
  EXPECT_TRUE(options->schema.empty());
  EXPECT_EQ(options->limits().rows, 10'000u);
}

TEST(SQLiteOptions, AreTakenRelativeToTheirFolders) {
  auto options = read_sqlite_options({{"file", "a.db"},
                                      {"schema", "sql/schema.sql"},
                                      {"seed", "sql/../seed.sql"}},
                                     "/data", "/app");
  ASSERT_TRUE(options);
  EXPECT_FALSE(options->in_memory());
  EXPECT_EQ(options->file, "/data/a.db");
  EXPECT_EQ(options->schema, "/app/sql/schema.sql");
  EXPECT_EQ(options->seed, "/app/seed.sql");
}

TEST(SQLiteOptions, DoNotLeaveTheirFolders) {
  for (const auto* name : {"file", "schema", "seed"})
    for (const auto* text : {"/elsewhere/x", "../x", "sql/../../app/../x"}) {
      auto options = read_sqlite_options({{name, text}}, "/data", "/app");
      ASSERT_FALSE(options) << name << text;
      EXPECT_EQ(options.error().kind, ErrorKind::settings);
      EXPECT_THAT(options.error().message,
                  testing::AllOf(HasSubstr(name), HasSubstr(text)));
    }
}

TEST(SQLiteOptions, NameWhatIsWrong) {
  for (const auto& [name, text] :
       {std::pair("max-bytes", "1.5"), std::pair("file", ""),
        std::pair("transaction-timeout", "-1s")}) {
    auto options = read_sqlite_options({{name, text}}, "/data", "/app");
    ASSERT_FALSE(options) << name;
    EXPECT_EQ(options.error().kind, ErrorKind::settings);
    EXPECT_THAT(options.error().message, HasSubstr(name));
  }
}

} // namespace
} // namespace parlour::adapters
