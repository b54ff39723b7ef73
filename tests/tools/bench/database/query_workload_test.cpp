#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/database/sqlite/sqlite_database.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/bench/database/facility_table.hpp"
#include "tools/bench/database/query_workload.hpp"
#include "tools/bench/database/raw_queries.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

class QueryWorkloadTest : public testing::Test {
protected:
  QueryWorkloadTest() : desk_(folder_.path().string()) {
    folder_.write("schema.sql", facility_schema());
    folder_.write("seed.sql", facility_seed());
  }
  Expected<Measured> run(const Options& options, std::size_t sessions) {
    const auto workload = QueryWorkload::load(
        test::source_path("tools/bench/workloads/query.xml"));
    if (!workload)
      return tl::make_unexpected(workload.error());
    const auto component = adapters::sqlite_database_factory().create();
    if (auto started = component->start(desk_, options); !started)
      return tl::make_unexpected(started.error());
    return workload->run(*component, desk_, 0, sessions, 50);
  }

  test::TemporaryFolder folder_;
  Desk desk_;
};

TEST_F(QueryWorkloadTest, gets_what_the_library_gets) {
  const auto raw = raw_sqlite(50);
  ASSERT_TRUE(raw);
  for (const auto sessions : {std::size_t{1}, std::size_t{7}}) {
    const auto measured =
        run({{"schema", "schema.sql"}, {"seed", "seed.sql"}}, sessions);
    ASSERT_TRUE(measured) << measured.error().message;
    EXPECT_EQ(measured->result, raw->result);
  }
}

TEST_F(QueryWorkloadTest, tells_what_the_component_says) {
  folder_.write("schema.sql", "create table facility (id integer);");
  folder_.write("seed.sql", "");
  const auto measured =
      run({{"schema", "schema.sql"}, {"seed", "seed.sql"}}, 2);
  ASSERT_FALSE(measured);
  EXPECT_THAT(measured.error().message, HasSubstr("no such column: name"));
}

} // namespace
} // namespace parlour::tools
