// Errors that another program or the disk causes.
#include <csignal>

#include <sys/resource.h>

#include "adapters/database/sqlite/sqlite_connection.hpp"
#include "adapters/database/sqlite/sqlite_open.hpp"
#include "tests/adapters/database/sqlite_fixture.hpp"

namespace parlour::adapters {
namespace {

using testing::AnyOf;
using testing::StartsWith;

const std::string count = "select count(*) from staff";

using SQLiteTroubleTest = SQLiteTest;

// No file of this process grows beyond `bytes` while this lives.
class SmallDisk {
public:
  explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST_F(SQLiteTroubleTest, WaitsForAnotherProgramButNotForEver) {
  auto options = file_options();
  options["busy-timeout"] = "20ms";
  ASSERT_TRUE(start(options));
  SQLiteConnection other(
      open_file(folder.path() / "data" / "staff.db", Missing::refuse).value(),
      {}, Milliseconds(0));
  ASSERT_TRUE(other.begin());
  ASSERT_TRUE(other.run("delete from staff", {}, Access::write));
  EXPECT_THAT(write("delete from staff"), StartsWith("Error(Timeout, "));
  EXPECT_THAT(tell("Begin"), StartsWith("Error(Timeout, "));
  EXPECT_EQ(query(count), "Result([3])");
  ASSERT_TRUE(other.commit());
  EXPECT_EQ(query(count), "Result([0])");
  EXPECT_EQ(write("insert into staff (name) values ('Ong')"), "Result([], 1)");
}

TEST_F(SQLiteTroubleTest, SaysThatTheDiskIsFullAndGoesOnWithRoom) {
  ASSERT_TRUE(start(file_options()));
  const std::string insert = "insert into staff (name) values (?)";
  const auto name = [](int i) {
    return std::string(10'000, 'x') + std::to_string(i);
  };
  int written = 0;
  std::string answer;
  {
    const SmallDisk disk(256 << 10);
    for (; (answer = write(insert, List{name(written)})) == "Result([], 1)" &&
           written < 1'000;
         ++written) {
    }
    EXPECT_THAT(answer, StartsWith("Error(Database, 'insert into"));
    EXPECT_GT(written, 0);
    EXPECT_EQ(query(count), "Result([" + std::to_string(3 + written) + "])");
    // A transaction that does not fit is undone as a whole.
    EXPECT_EQ(tell("Begin"), "Result([])");
    EXPECT_THAT(write("insert into staff (name) select a.name || b.name "
                      "from staff as a, staff as b"),
                StartsWith("Error(Database, "));
    EXPECT_THAT(tell("Rollback"),
                AnyOf("Result([])", StartsWith("Error(Database, Rollback")));
  }
  EXPECT_EQ(query(count), "Result([" + std::to_string(3 + written) + "])");
  EXPECT_EQ(write(insert, List{name(written)}), "Result([], 1)");
  ASSERT_TRUE(start(file_options())); // checks that it is sound
  EXPECT_EQ(query(count), "Result([" + std::to_string(4 + written) + "])");
}

} // namespace
} // namespace parlour::adapters
