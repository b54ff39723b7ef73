// Sends a column's name to the reader of its database (adapters/database).
#include "tools/parlour/application/sql/column_reader.hpp"

#include <algorithm>
#include <map>

#include "tools/parlour/application/plugins/shipped_plugin.hpp"

namespace parlour::tools {

namespace {

using Texts = Expected<std::vector<std::string>>;

constexpr std::string_view prefix = "db:";
// In a grammar.
constexpr std::string_view column_mark = "@db:";
constexpr std::string_view name_characters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_.:";

// "db:Archive.robot.name" without the name of the database.
struct Column {
  std::string database;  // empty: the first one
  std::string reference; // "db:robot.name"
};

// A name with one dot belongs to the first database; with two dots, the part
// before the first dot names the database.
Column split(const std::string& name) {
  const auto parts = std::count(name.begin(), name.end(), '.');
  if (parts < 2 || !name.starts_with(prefix))
    return {"", name};
  const auto point = name.find('.');
  return {name.substr(prefix.size(), point - prefix.size()),
          std::string(prefix) + name.substr(point + 1)};
}

// The reader for a component, or null if it is no database that can be read
// without starting the component.
ColumnReader reader_of(const ChosenComponent& component,
                       const std::filesystem::path& application,
                       const std::string& data_folder) {
  const auto columns =
      shipped_plugin(component.factory.description.name).columns;
  return columns ? columns(component.options, application, data_folder)
                 : ColumnReader();
}

// One reader for each database component. Copied into the ColumnReader.
// Made from the composition, not from running components: values are needed
// before anything runs.
class Readers {
public:
  Readers(const Composition& composition,
          const std::filesystem::path& application,
          const std::string& data_folder) {
    for (const auto& component : composition.components)
      if (auto reader = reader_of(component, application, data_folder))
        all_.emplace(component.name, std::move(reader));
    if (const auto* first = first_of_role(composition, "Database"))
      first_ = first->name;
  }

  // Errors name the column as it was asked for, with its database.
  Texts read(const std::string& name) const {
    const auto column = split(name);
    const auto found =
        all_.find(column.database.empty() ? first_ : column.database);
    if (found == all_.end())
      return missing(column, name);
    return found->second(column.reference).map_error([&](Error error) {
      return named(std::move(error), column.reference, name);
    });
  }

private:
  // Puts the full name into the error of a reader that knows only the rest.
  static Error named(Error error, const std::string& reference,
                     const std::string& name) {
    const auto quoted = "'" + reference + "'";
    if (const auto at = error.message.find(quoted); at != std::string::npos)
      error.message.replace(at, quoted.size(), "'" + name + "'");
    return error;
  }

  Texts missing(const Column& column, const std::string& name) const {
    if (column.database.empty())
      return fail(ErrorKind::settings,
                  "the application has no database to "
                  "read the column '" +
                      name +
                      "' from; name one in <Plugins> of "
                      "settings.xml (parlour plugin list)");
    std::vector<std::string> names;
    for (const auto& [database, reader] : all_)
      names.push_back(database);
    return fail(ErrorKind::settings,
                "there is no database '" + column.database +
                    "' to read the column '" + name + "' from" +
                    script::did_you_mean(column.database, names));
  }

  std::map<std::string, ColumnReader> all_; // by the component's name
  // The name of the first component with the role Database.
  std::string first_;
};

} // namespace

ColumnReader column_reader(const Composition& composition,
                           const std::filesystem::path& application,
                           const std::string& data_folder) {
  return [readers = Readers(composition, application, data_folder)](
             const std::string& name) { return readers.read(name); };
}

std::vector<std::string> column_names(const UnderstandingModel& model) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (!name.empty() && !std::ranges::count(names, name))
      names.push_back(name);
  };
  for (const auto& topic : model.topics)
    for (const auto& slot : topic.slots)
      add(slot.source);
  for (const auto& grammar : model.grammars)
    for (auto at = grammar.text.find(column_mark); at != std::string::npos;
         at = grammar.text.find(column_mark, at + 1)) {
      const auto end =
          std::min(grammar.text.find_first_not_of(name_characters, at + 1),
                   grammar.text.size());
      add(grammar.text.substr(at + 1, end - at - 1));
    }
  return names;
}

std::function<std::string(const std::string& component)>
column_owners(const Composition& composition,
              std::vector<std::string> columns) {
  const auto* first = first_of_role(composition, "Database");
  return [first = first ? first->name : std::string(),
          columns = std::move(columns)](const std::string& component) {
    std::string text;
    for (const auto& name : columns) {
      const auto database = split(name).database;
      if ((database.empty() ? first : database) == component)
        text.append(text.empty() ? "" : ", ").append(name);
    }
    return text;
  };
}

} // namespace parlour::tools
