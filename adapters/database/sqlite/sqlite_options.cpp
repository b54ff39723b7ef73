#include "adapters/database/sqlite/sqlite_options.hpp"

#include <utility>

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
    return fail(ErrorKind::settings, "option 'file' is empty");
  const auto values = OptionValues::of(options, sqlite_option_descriptions());
  if (!values)
    return tl::make_unexpected(values.error());
  SQLiteOptions made;
  const auto of_file = values->text("file") == ":memory:"
                           ? Expected<void>()
                           : values->read("file", data_folder, made.file);
  for (auto&& read :
       {of_file, read_database_options(*values, application_folder, made)})
    if (!read)
      return tl::make_unexpected(read.error());
  return made;
}

} // namespace parlour::adapters
