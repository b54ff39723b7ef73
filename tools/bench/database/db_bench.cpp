#include "tools/bench/database/db_bench.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <ostream>

#include <fmt/format.h>

#include "adapters/database/mariadb/mariadb_database.hpp"
#include "adapters/database/sqlite/sqlite_database.hpp"
#include "tools/bench/database/facility_table.hpp"
#include "tools/bench/database/mariadb_server.hpp"
#include "tools/bench/database/query_workload.hpp"
#include "tools/bench/database/raw_queries.hpp"
#include "tools/bench/support/contest.hpp"

namespace parlour::tools {

namespace {

namespace fs = std::filesystem;

// A script that queries one row by its name, again and again.
const fs::path workload = fs::path(PARLOUR_WORKLOADS) / "query.xml";

// Sessions for each connection. More than one, so that a query always waits for
// a free connection.
constexpr std::size_t sessions_for_each = 4;
constexpr std::size_t sqlite_queries = 100'000;
constexpr std::size_t mariadb_queries = 20'000;

struct Row {
  const char* name;
  const char* sentence;
  // 0: SQLite in memory.
  std::size_t connections;
  // The least share of the library's own speed; 0: no bar.
  double bar;
};

// The bars of MariaDB are for four connections, as the component has by
// default.
constexpr Row rows[] = {
    {"sqlite", "SQLite in memory", 0, 0.60},
    {"mariadb-1", "MariaDB, a connection", 1, 0},
    {"mariadb", "MariaDB, four connections", 4, 0.85},
    {"mariadb-16", "MariaDB, 16 connections", 16, 0},
};

// A temporary folder with schema and seed, removed at the end.
class Ground {
public:
  Ground() {
    auto pattern = (fs::temp_directory_path() / "parlour-XXXXXX").string();
    if (mkdtemp(pattern.data()))
      path = pattern;
    std::ofstream(path / "schema.sql") << facility_schema();
    std::ofstream(path / "seed.sql") << facility_seed();
  }
  Ground(const Ground&) = delete;
  Ground& operator=(const Ground&) = delete;
  ~Ground() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }

  fs::path path;
};

// Prints one row after another. The server is started with the first row that
// needs it.
class DbBench {
public:
  DbBench(int runs, std::ostream& out)
      : runs_(runs), out_(out), server_(ground_.path),
        desk_(ground_.path.string()), workload_(QueryWorkload::load(workload)) {
  }

  bool measure(const Row& row);

private:
  using Component = std::unique_ptr<IPlugin>;

  Expected<Component> component(const Row& row);
  // Runs both sides in turn, so that a change of the machine's load affects
  // both.
  Expected<void> contest(const Row& row, Series& ours, Series& theirs);
  bool say(const Row& row, const std::string& text);

  int runs_;
  std::ostream& out_;
  Ground ground_;
  MariaDBServer server_;
  Desk desk_;
  Expected<QueryWorkload> workload_;
};

// Starts the component that the row measures.
Expected<DbBench::Component> DbBench::component(const Row& row) {
  const bool is_server = row.connections > 0;
  Options options{{"schema", "schema.sql"}, {"seed", "seed.sql"}};
  if (is_server) {
    if (auto started = server_.start(); !started)
      return tl::make_unexpected(started.error());
    options.insert({{"socket", server_.socket()},
                    {"user", "root"},
                    {"database", "bench"},
                    {"connections", std::to_string(row.connections)}});
  }
  auto made = is_server ? adapters::mysql_database_factory().create()
                        : adapters::sqlite_database_factory().create();
  if (auto started = made->start(desk_, options); !started)
    return tl::make_unexpected(started.error());
  return made;
}

// The component is started once; the peer opens its connections for each run.
Expected<void> DbBench::contest(const Row& row, Series& ours, Series& theirs) {
  if (!workload_)
    return tl::make_unexpected(workload_.error());
  auto asked = component(row);
  if (!asked)
    return tl::make_unexpected(asked.error());
  const bool is_server = row.connections > 0;
  const auto count = is_server ? mariadb_queries : sqlite_queries;
  const auto sessions = is_server ? row.connections * sessions_for_each : 1;
  // The CPU time of the server counts on both sides.
  const auto server = is_server ? server_.process() : 0;
  for (int run = 0; run < runs_; ++run) {
    ours.add(workload_->run(**asked, desk_, server, sessions, count));
    theirs.add(is_server ? raw_mariadb(server_, row.connections, count)
                         : raw_sqlite(count));
  }
  (*asked)->stop();
  return {};
}

bool DbBench::measure(const Row& row) {
  Series ours;
  Series theirs;
  if (auto done = contest(row, ours, theirs); !done)
    return say(row, done.error().message);
  for (const auto* series : {&ours, &theirs})
    if (!series->trouble.empty())
      return say(row, series->trouble);
  // A row counts only if both sides have read the same data.
  if (ours.result != theirs.result)
    return say(row, "other answers: " + ours.result + ", not " + theirs.result);
  const auto our_time = median(ours.figures);
  const auto their_time = median(theirs.figures);
  // 1 means as fast as the library alone.
  const auto speed = their_time / our_time;
  out_ << fmt::format("{:<11} {:<26} {:6.2f} µs; its library {:6.2f}; {:.2f} "
                      "of its speed",
                      row.name, row.sentence, our_time / 1000,
                      their_time / 1000, speed);
  if (row.bar > 0)
    out_ << fmt::format(", bar {:.2f}: {}", row.bar,
                        speed >= row.bar ? "met" : "missed");
  out_ << fmt::format("; by the clock {:.2f} and {:.2f} µs",
                      median(ours.passed) / 1000, median(theirs.passed) / 1000)
       << std::endl;
  return true;
}

bool DbBench::say(const Row& row, const std::string& text) {
  out_ << fmt::format("{:<11} {}\n", row.name, text);
  return false;
}

} // namespace

std::vector<std::string> db_bench_rows() {
  std::vector<std::string> names;
  for (const auto& row : rows)
    names.emplace_back(row.name);
  return names;
}

bool db_bench(const BenchRows& wanted, std::ostream& out) {
  out << fmt::format("CPU time of one query of a script, the server's "
                     "included, median of {} runs\n",
                     wanted.runs);
  DbBench bench(wanted.runs, out);
  bool ok = true;
  for (const auto& row : rows)
    if (wanted.wants(row.name))
      ok &= bench.measure(row);
  return ok;
}

} // namespace parlour::tools
