#include "adapters/database/mariadb_database.hpp"

#include <array>
#include <optional>
#include <random>
#include <utility>

#include "adapters/database/mariadb_pool.hpp"

namespace parlour::adapters {

namespace {

using Kind = DatabaseOrder::Kind;

const Value& param(const Message& message, std::size_t index) {
  static const Value unknown;
  return index < message.params.size() ? message.params[index] : unknown;
}

std::optional<Kind> order_kind(const std::string& command) {
  constexpr std::array<std::pair<std::string_view, Kind>, 5> kinds{
      {{"Connect", Kind::connect},
       {"Query", Kind::query},
       {"Begin", Kind::begin},
       {"Commit", Kind::commit},
       {"Rollback", Kind::rollback}}};
  for (const auto& [name, kind] : kinds)
    if (command == name)
      return kind;
  return {};
}

// Nobody else makes one of that name.
std::string own_name(const std::string& database) {
  std::random_device chance;
  return database + "_" + std::to_string(chance()) +
         std::to_string(chance() % 1000);
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
      [this](const Message& message, const StatementOutcome& outcome) {
        tell(message, outcome);
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
  const auto kind = order_kind(message.command);
  if (!pool_)
    return fail_with(message,
                     {ErrorKind::offline, "The database is closed.", {}});
  if (!kind)
    return fail_with(message, {ErrorKind::refused,
                               "A database does not know the command '" +
                                   message.command + "'.",
                               {}});
  if (kind == Kind::query && !param(message, 0).if_string())
    return fail_with(
        message,
        {ErrorKind::type, "Query needs SQL as its first parameter.", {}});
  if (kind == Kind::connect && !is_this_database(param(message, 0)))
    return fail_with(message,
                     {ErrorKind::refused,
                      "This component's database is '" + options_.database +
                          "'; for another the settings need a component of "
                          "its own.",
                      {}});
  submit({*kind, message,
          kind == Kind::query && static_cast<bool>(param(message, 2))});
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

void MySQLDatabase::tell(const Message& message,
                         const StatementOutcome& outcome) {
  if (outcome) {
    std::vector<Value> params{outcome->rows};
    if (message.command == "Query" && param(message, 2))
      params.emplace_back(outcome->changes);
    answer(message, "Result", std::move(params));
  } else {
    fail_with(message, outcome.error());
  }
  const std::lock_guard lock(mutex_);
  --untold_;
  told_.notify_all();
}

void MySQLDatabase::fail_with(const Message& message, const Error& error) {
  answer(message, "Error", {name_of(error.kind), error.message});
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
