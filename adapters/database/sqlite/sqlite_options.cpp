#include "adapters/database/sqlite/sqlite_options.hpp"

namespace parlour::adapters {

const std::vector<OptionDescription>& sqlite_option_descriptions() {
  static const auto descriptions = with_database_options(
      {{"file", ":memory:",
        "the database, in the data folder; ':memory:' is a copy of its own",
        false}});
  return descriptions;
}

Expected<SQLiteOptions>
read_sqlite_options(const Options& options, const std::string& data_folder,
                    const std::string& application_folder) {
  // An empty name is refused: it is more likely a mistake than the wish to keep
  // the data in memory and lose it at the end.
  if (const auto file = options.find("file");
      file != options.end() && file->second.empty())
    return fail(ErrorKind::settings, "the option 'file' is empty");
  OptionReader read(options, sqlite_option_descriptions());
  SQLiteOptions made;
  if (read.text("file") != ":memory:")
    made.file = read.file("file", data_folder);
  read_database_options(read, application_folder, made);
  if (const auto outcome = read.outcome(); !outcome)
    return tl::make_unexpected(outcome.error());
  return made;
}

} // namespace parlour::adapters
