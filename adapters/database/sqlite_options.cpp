#include "adapters/database/sqlite_options.hpp"

#include <utility>

#include "runtime/plugin/folder.hpp"

namespace parlour::adapters {

namespace {

std::string text_of(const Options& options, const std::string& name) {
  if (auto found = options.find(name); found != options.end())
    return found->second;
  for (const auto& option : sqlite_option_descriptions())
    if (option.name == name)
      return option.fallback;
  return {};
}

// Empty where the option says nothing.
Expected<void> read(const Options& options, const char* name,
                    const std::string& folder, std::filesystem::path& path) {
  const auto text = text_of(options, name);
  if (text.empty())
    return {};
  auto found = inside(folder, text, name);
  if (!found)
    return tl::make_unexpected(found.error());
  path = std::move(*found);
  return {};
}

Expected<void> read(const Options& options, const char* name,
                    Milliseconds& duration) {
  auto read = parse_duration(text_of(options, name));
  if (!read)
    return fail(ErrorKind::settings,
                "option '" + std::string(name) + "': " + read.error().message);
  duration = *read;
  return {};
}

Expected<void> read(const Options& options, const char* name,
                    std::size_t& count) {
  const auto number = parse_number(text_of(options, name));
  if (!number.if_integer() || *number.if_integer() < 1)
    return fail(ErrorKind::settings, "option '" + std::string(name) +
                                         "' is a whole number from 1, not '" +
                                         text_of(options, name) + "'");
  count = static_cast<std::size_t>(*number.if_integer());
  return {};
}

} // namespace

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
  const auto file = text_of(options, "file");
  if (file.empty())
    return fail(ErrorKind::settings, "option 'file' is empty");
  const auto of_file = file == ":memory:"
                           ? Expected<void>()
                           : read(options, "file", data_folder, made.file);
  for (auto&& read :
       {of_file, read(options, "schema", application_folder, made.schema),
        read(options, "seed", application_folder, made.seed),
        read(options, "busy-timeout", made.busy_timeout),
        read(options, "transaction-timeout", made.transaction_timeout),
        read(options, "max-rows", made.limits.rows),
        read(options, "max-bytes", made.limits.bytes)})
    if (!read)
      return tl::make_unexpected(read.error());
  return made;
}

} // namespace parlour::adapters
