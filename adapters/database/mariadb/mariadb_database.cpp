// The plug-in around MariaDBPool: it checks messages, hands them to the pool as
// orders, and turns outcomes into answers.
#include "adapters/database/mariadb/mariadb_database.hpp"

#include <random>
#include <utility>

#include "adapters/database/mariadb/mariadb_pool.hpp"
#include "adapters/database/mariadb/mariadb_watch.hpp"

namespace parlour::adapters {

namespace {

// A random name for a copy. With the 48 characters that an option allows it
// stays below MariaDB's limit of 64.
std::string own_name(const std::string& database) {
  std::random_device random;
  return database + "_" + std::to_string(random()) +
         std::to_string(random() % 1000);
}

} // namespace

MySQLDatabase::MySQLDatabase() = default;

MySQLDatabase::~MySQLDatabase() = default;

Expected<void> MySQLDatabase::on_start(const Options& options) {
  auto read = read_mariadb_options(options, host().application_folder());
  if (!read)
    return tl::make_unexpected(read.error());
  options_ = std::move(*read);
  if (options_.copy)
    options_.database = own_name(options_.database);
  auto loop =
      Loop::start([this](const std::string& what) { host().failed(what); });
  if (!loop)
    return tl::make_unexpected(loop.error());
  pool_ = std::make_unique<MariaDBPool>(
      options_, std::move(*loop),
      [this](const Message& message, StatementOutcome outcome) {
        tell(message, std::move(outcome));
      },
      [this](const std::string& text) { host().log(text); });
  auto first = pool_->first_connection();
  if (first) {
    watch_values();
    return {};
  }
  // A copy is made for a test, which must not begin without its database.
  if (!options_.copy && (first.error().kind == ErrorKind::offline ||
                         first.error().kind == ErrorKind::timeout)) {
    host().log("The server cannot be reached yet: " + first.error().message);
    watch_values();
    return {};
  }
  pool_.reset();
  return first;
}

// In virtual time it looks when something was written, and only then.
void MySQLDatabase::watch_values() {
  if (options_.columns.empty() ||
      (options_.watch == Milliseconds::zero() && !options_.one_by_one))
    return;
  auto watch =
      MariaDBWatch::start(options_, [this](const ValueWatch::News& news) {
        for (const auto& error : news.errors)
          host().log("A column cannot be read, so its values stay as they "
                     "are: " +
                     error.message);
        for (const auto& [column, values] : news.changed)
          host().fire_event(values_changed(column, values));
      });
  if (!watch)
    return host().log("New values of columns are not noticed: " +
                      watch.error().message);
  watch_ = std::move(*watch);
  watch_->look_now();
}

void MySQLDatabase::stop() {
  watch_.reset();
  pool_.reset();
}

void MySQLDatabase::on_message(const Message& message) {
  const auto command = command_of(message);
  // The component has not been started, or has been stopped.
  if (!pool_)
    return fail_with(message, database_closed());
  if (!command)
    return fail_with(message, command.error());
  if (*command == DatabaseCommand::connect &&
      !is_this_database(param(message, 0)))
    return fail_with(message,
                     {ErrorKind::refused,
                      "This component's database is '" + options_.database +
                          "'; for another the settings need a component of "
                          "its own.",
                      {}});
  const bool writes = *command == DatabaseCommand::query && is_write(message);
  submit({*command, without_its_way(message), writes});
  if (watch_ && options_.one_by_one &&
      (writes || *command == DatabaseCommand::commit))
    watch_->look_now();
}

void MySQLDatabase::submit(DatabaseOrder order) {
  open_.open();
  pool_->submit(std::move(order));
  if (options_.one_by_one)
    open_.wait_for_all();
}

// A component has exactly one database, which its settings name, not the
// script.
bool MySQLDatabase::is_this_database(const Value& wanted) const {
  const auto name = (wanted.if_map() ? wanted["database"] : wanted).text();
  return !wanted || name == "unknown" || name == options_.database;
}

void MySQLDatabase::tell(const Message& message, StatementOutcome outcome) {
  const OpenMessages::Closing closing(open_);
  if (outcome)
    answer(message, "Result", result_params(message, std::move(*outcome)));
  else
    fail_with(message, outcome.error());
}

void MySQLDatabase::fail_with(const Message& message, const Error& error) {
  answer(message, "Error", error_params(error));
}

PluginFactory mysql_database_factory() {
  PluginDescription description;
  description.name = "MySQLDatabase";
  description.roles = {"Database"};
  description.sentence = "a database of a MariaDB server";
  description.options = mariadb_option_descriptions();
  // Connecting at the start, and closing, wait for the server.
  description.blocks = true;
  return {description, [] { return std::make_unique<MySQLDatabase>(); }};
}

} // namespace parlour::adapters
