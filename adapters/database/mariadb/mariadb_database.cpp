#include "adapters/database/mariadb/mariadb_database.hpp"

#include <random>
#include <utility>

#include "adapters/database/mariadb/mariadb_pool.hpp"

namespace parlour::adapters {

namespace {

// Nobody else makes one of that name.
std::string own_name(const std::string& database) {
  std::random_device chance;
  return database + "_" + std::to_string(chance()) +
         std::to_string(chance() % 1000);
}

// What is asked, and what the answer has to say; all else has done its work.
Message without_its_way(const Message& message) {
  Message kept;
  kept.command = message.command;
  kept.params = message.params;
  kept.session = message.session;
  kept.correlation = message.correlation;
  return kept;
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
  pool_ = std::make_unique<MariaDBPool>(
      options_,
      [this](const Message& message, StatementOutcome outcome) {
        tell(message, std::move(outcome));
      },
      [this](const std::string& text) { host().log(text); });
  auto first = pool_->first_connection();
  if (first)
    return {};
  if (!options_.copy && (first.error().kind == ErrorKind::offline ||
                         first.error().kind == ErrorKind::timeout)) {
    host().log("The server cannot be reached yet: " + first.error().message);
    return {};
  }
  pool_.reset();
  return first;
}

void MySQLDatabase::stop() {
  pool_.reset();
}

void MySQLDatabase::on_message(const Message& message) {
  const auto command = command_of(message);
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
  submit({*command, without_its_way(message),
          *command == DatabaseCommand::query && is_write(message)});
}

void MySQLDatabase::submit(DatabaseOrder order) {
  std::unique_lock lock(mutex_);
  ++untold_;
  lock.unlock();
  pool_->submit(std::move(order));
  if (!options_.one_by_one)
    return;
  lock.lock();
  told_.wait(lock, [this] { return untold_ == 0; });
}

// One component is one database: its settings, not a script, say which.
bool MySQLDatabase::is_this_database(const Value& wanted) const {
  const auto name = (wanted.if_map() ? wanted["database"] : wanted).text();
  return !wanted || name == "unknown" || name == options_.database;
}

void MySQLDatabase::tell(const Message& message, StatementOutcome outcome) {
  if (outcome)
    answer(message, "Result", result_params(message, std::move(*outcome)));
  else
    fail_with(message, outcome.error());
  const std::lock_guard lock(mutex_);
  --untold_;
  told_.notify_all();
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
  // Connecting, at its start, and closing.
  description.blocks = true;
  return {description, [] { return std::make_unique<MySQLDatabase>(); }};
}

} // namespace parlour::adapters
