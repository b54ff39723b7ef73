#include "adapters/database/sqlite_options.hpp"

#include <utility>

#include "adapters/database/option_values.hpp"

namespace parlour::adapters {

const std::vector<OptionDescription>& sqlite_option_descriptions() {
  static const std::vector<OptionDescription> descriptions{
      {"file", ":memory:",
       "the database, in the data folder; ':memory:' is a copy of its own",
       false},
      {"schema", "", "SQL that makes the tables of a missing file", false},
      {"seed", "", "SQL that fills the tables of a missing file", false},
      {"busy-timeout", "2s", "how long to wait for others to finish writing",
       false},
      {"transaction-timeout", "30s",
       "after which an open transaction is rolled back", false},
      {"max-rows", "10000", "the most rows that a query returns", false},
      {"max-bytes", "4194304", "the most bytes that a query returns", false},
  };
  return descriptions;
}

Expected<SQLiteOptions>
read_sqlite_options(const Options& options, const std::string& data_folder,
                    const std::string& application_folder) {
  SQLiteOptions made;
  const OptionValues values(options, sqlite_option_descriptions());
  const auto file = values.text("file");
  if (file.empty())
    return fail(ErrorKind::settings, "option 'file' is empty");
  const auto of_file = file == ":memory:"
                           ? Expected<void>()
                           : values.read("file", data_folder, made.file);
  for (auto&& read :
       {of_file, values.read("schema", application_folder, made.schema),
        values.read("seed", application_folder, made.seed),
        values.read("busy-timeout", made.busy_timeout),
        values.read("transaction-timeout", made.transaction_timeout),
        values.read("max-rows", made.limits.rows),
        values.read("max-bytes", made.limits.bytes)})
    if (!read)
      return tl::make_unexpected(read.error());
  return made;
}

} // namespace parlour::adapters
