// Prepares the SQL of scripts on a database in memory.
#include "tools/parlour/application/sql/sql_lint.hpp"

#include <algorithm>
#include <cctype>

#include "adapters/database/sqlite/sqlite_options.hpp"
#include "adapters/database/sqlite/sqlite_prepare.hpp"
#include "runtime/plugin/folder.hpp"
#include "script/dialogue/knowledge/sql_text.hpp"
#include "tools/parlour/application/plugins/shipped_plugin.hpp"
#include "tools/parlour/application/sql/sql_statements.hpp"

namespace parlour::tools {

namespace {

using adapters::SQLitePreparer;
using adapters::SQLiteProblem;

// The database of the application, made in memory.
// Made once for all statements of an application.
struct Database {
  SQLitePreparer prepared;
  // MariaDB's statements are prepared with SQLite, too. It knows another
  // dialect, so only missing tables and columns are reported for them.
  bool is_sqlite;
};

// The files of schema and seed of a component, for either product.
adapters::SQLiteOptions files_of(const ChosenComponent& component,
                                 const std::filesystem::path& application) {
  adapters::SQLiteOptions options;
  for (auto [name, file] :
       {std::pair("schema", &options.schema), std::pair("seed", &options.seed)})
    if (const auto said = component.options.find(name);
        said != component.options.end())
      *file = inside(application, said->second, name).value_or("");
  return options;
}

// Empty if the application has no such database or its SQL fails.
// MariaDB's schema is tried with SQLite, too: where that fails there is no
// lint.
std::optional<Database> database_of(const Composition& composition,
                                    const std::filesystem::path& application) {
  const auto* component = first_of_role(composition, "Database");
  if (!component || component->options.count("schema") == 0)
    return {};
  const auto& plugin = shipped_plugin(component->factory.description.name);
  if (!plugin.columns)
    return {};
  const auto options = files_of(*component, application);
  const auto image = adapters::sqlite_image(options.schema, options.seed);
  if (!image)
    return {};
  auto opened = SQLitePreparer::open(*image);
  if (!opened)
    return {};
  return Database{std::move(*opened), plugin.speaks_sqlite};
}

// "no such column: f.nme" gives "nme"; other messages give "".
std::string missing_name(const std::string& message) {
  const auto colon =
      message.find("no such ") == 0 ? message.rfind(": ") : std::string::npos;
  if (colon == std::string::npos)
    return {};
  const auto point = message.rfind('.');
  return message.substr(
      point != std::string::npos && point > colon ? point + 1 : colon + 2);
}

// The length of the word at an offset of the statement, to be underlined.
std::size_t word_length(const std::string& sql, std::size_t at) {
  auto end = at;
  while (end < sql.size() &&
         (std::isalnum(static_cast<unsigned char>(sql[end])) ||
          sql[end] == '_' || sql[end] == '.'))
    ++end;
  return std::max<std::size_t>(end - at, 1);
}

// Prepares statements one by one and reports what the database says.
class SqlLint {
public:
  SqlLint(const Database& database, script::Findings& findings)
      : database_(database), names_(database.prepared.names()),
        findings_(findings) {}

  // Warns of what is wrong with one statement: at most one mistake in its own
  // text, otherwise one for each column of a <by>.
  void look_at(const SqlStatement& statement);

private:
  std::optional<SQLiteProblem> problem_of(const std::string& sql) const;
  // Adds a warning with what the database says, and a similar name if one is
  // missing.
  void warn(script::Spot spot, const std::string& message);

  const Database& database_;
  std::vector<std::string> names_;
  script::Findings& findings_;
};

// What SQLite says about a statement, unless it is only a matter of dialect.
std::optional<SQLiteProblem> SqlLint::problem_of(const std::string& sql) const {
  auto problem = database_.prepared.problem_of(sql);
  if (problem && !database_.is_sqlite &&
      (missing_name(problem->message).empty() ||
       problem->message.starts_with("no such function")))
    return {};
  return problem;
}

void SqlLint::warn(script::Spot spot, const std::string& message) {
  findings_.add({script::Severity::warning, spot,
                 "the database says: " + message +
                     script::did_you_mean(missing_name(message), names_),
                 "sql"});
}

// First the statement itself. If it is correct, each column that <by> compares
// is tried as a condition of it.
void SqlLint::look_at(const SqlStatement& statement) {
  if (const auto problem = problem_of(statement.sql)) {
    const auto at = problem->offset.value_or(0);
    return warn(statement.spot(at, problem->offset
                                       ? word_length(statement.sql, at)
                                       : statement.sql.size()),
                problem->message);
  }
  for (const auto& [column, position] : statement.columns)
    if (const auto problem = problem_of(
            dialogue::with_condition(statement.sql, column + " = ?", "")))
      warn({position}, problem->message);
}

} // namespace

void lint_sql(script::Compiled& compiled, const Composition& composition,
              const std::filesystem::path& application) {
  if (!compiled.program)
    return;
  const auto database = database_of(composition, application);
  if (!database)
    return;
  SqlLint lint(*database, compiled.findings);
  for (const auto& statement : sql_statements(compiled))
    lint.look_at(statement);
}

} // namespace parlour::tools
