#include "adapters/database/sqlite_database.hpp"

#include <array>
#include <utility>

#include "adapters/database/sqlite_image.hpp"
#include "adapters/database/sqlite_open.hpp"

namespace parlour::adapters {

namespace {

const Value& param(const Message& message, std::size_t index) {
  static const Value unknown;
  return index < message.params.size() ? message.params[index] : unknown;
}

bool is_write(const Message& message) {
  return static_cast<bool>(param(message, 2));
}

Error no_transaction(const Message& message, bool lost) {
  return {ErrorKind::database,
          message.command + ": " +
              (lost ? "the transaction was rolled back, as it took too long or "
                      "failed."
                    : "this conversation has no transaction."),
          {}};
}

} // namespace

Expected<void> SQLiteDatabase::on_start(const Options& options) {
  auto read = read_sqlite_options(options, host().data_folder(),
                                  host().application_folder());
  if (!read)
    return tl::make_unexpected(read.error());
  options_ = std::move(*read);
  return options_.in_memory() ? open_memory_copy() : open();
}

Expected<void> SQLiteDatabase::open_memory_copy() {
  auto image = sqlite_image(options_.schema, options_.seed);
  if (!image)
    return tl::make_unexpected(image.error());
  auto handle = open_image(*image);
  if (!handle)
    return tl::make_unexpected(handle.error());
  writer_ = std::make_unique<SQLiteConnection>(
      std::move(*handle), options_.limits, options_.busy_timeout);
  return {};
}

Expected<void> SQLiteDatabase::open() {
  if (!std::filesystem::exists(options_.file))
    if (auto created = create_missing(); !created)
      return created;
  if (auto sound = check_sound(options_.file); !sound)
    return sound;
  auto writer = connect();
  if (!writer)
    return tl::make_unexpected(writer.error());
  auto reader = connect();
  if (!reader)
    return tl::make_unexpected(reader.error());
  writer_ = std::move(*writer);
  reader_ = std::move(*reader);
  return {};
}

Expected<void> SQLiteDatabase::create_missing() const {
  if (options_.schema.empty())
    return fail(ErrorKind::settings,
                "There is no such database, and no option 'schema' says how "
                "to make it.",
                {options_.file.string(), 0, 0});
  auto image = sqlite_image(options_.schema, options_.seed);
  if (!image)
    return tl::make_unexpected(image.error());
  return write_image(*image, options_.file);
}

Expected<std::unique_ptr<SQLiteConnection>> SQLiteDatabase::connect() const {
  auto handle = open_file(options_.file, Missing::refuse);
  if (!handle)
    return tl::make_unexpected(handle.error());
  if (auto allowed = allow_writing(handle->get(), options_.file); !allowed)
    return tl::make_unexpected(allowed.error());
  return std::make_unique<SQLiteConnection>(std::move(*handle), options_.limits,
                                            options_.busy_timeout);
}

void SQLiteDatabase::stop() {
  if (transactions_.held() && writer_)
    (void)writer_->rollback();
  for (const auto& [ticket, delay] : std::exchange(delays_, {}))
    host().cancel(delay);
  while (auto waiting = transactions_.next())
    fail_with(waiting->message,
              {ErrorKind::offline, "The database was closed.", {}});
  transactions_ = {};
  reader_.reset();
  writer_.reset();
}

void SQLiteDatabase::on_message(const Message& message) {
  if (!writer_)
    fail_with(message, {ErrorKind::offline, "The database is closed.", {}});
  else if (must_wait(message))
    wait(message);
  else
    handle(message);
}

void SQLiteDatabase::handle(const Message& message) {
  using Handler = void (SQLiteDatabase::*)(const Message&);
  constexpr std::array<std::pair<std::string_view, Handler>, 5> handlers{
      {{"Connect", &SQLiteDatabase::check_connection},
       {"Query", &SQLiteDatabase::query},
       {"Begin", &SQLiteDatabase::begin},
       {"Commit", &SQLiteDatabase::end},
       {"Rollback", &SQLiteDatabase::end}}};
  for (const auto& [command, handler] : handlers)
    if (message.command == command)
      return (this->*handler)(message);
  fail_with(message,
            {ErrorKind::refused,
             "A database does not know the command '" + message.command + "'.",
             {}});
}

bool SQLiteDatabase::must_wait(const Message& message) const {
  if (!transactions_.held() || transactions_.held_by(message.session))
    return false;
  return message.command == "Begin" ||
         (message.command == "Query" && (is_write(message) || !reader_));
}

void SQLiteDatabase::wait(const Message& message) {
  const auto ticket = transactions_.wait(message);
  if (!ticket)
    return fail_with(message,
                     {ErrorKind::limit, "Too many wait for the database.", {}});
  give_time(*ticket, options_.busy_timeout, &SQLiteDatabase::give_up_waiting);
}

void SQLiteDatabase::give_up_waiting(Ticket ticket) {
  if (auto waiting = transactions_.leave(ticket))
    fail_with(*waiting, {ErrorKind::timeout,
                         "Another conversation's transaction holds the "
                         "database.",
                         {}});
}

void SQLiteDatabase::give_time(Ticket ticket, Milliseconds time,
                               TimeIsUp time_is_up) {
  delays_[ticket] = host().after(time, [this, ticket, time_is_up] {
    delays_.erase(ticket);
    (this->*time_is_up)(ticket);
  });
}

void SQLiteDatabase::no_longer_timed(Ticket ticket) {
  if (auto delay = delays_.extract(ticket))
    host().cancel(delay.mapped());
}

void SQLiteDatabase::let_others_on() {
  while (!transactions_.held()) {
    const auto waiting = transactions_.next();
    if (!waiting)
      return;
    no_longer_timed(waiting->ticket);
    handle(waiting->message);
  }
}

// One component is one database: its settings, not a script, say which file.
void SQLiteDatabase::check_connection(const Message& message) {
  const auto& wanted = param(message, 0);
  const auto name = (wanted.if_map() ? wanted["file"] : wanted).text();
  const auto file = options_.file.filename().string();
  if (!wanted || name == "unknown" || name == file ||
      (options_.in_memory() && name == ":memory:"))
    return answer(message, "Result", {ResultSet{}});
  fail_with(message, {ErrorKind::refused,
                      "This component's database is '" +
                          (file.empty() ? ":memory:" : file) + "'; for '" +
                          name + "' the settings need a component of its own.",
                      {}});
}

void SQLiteDatabase::query(const Message& message) {
  const auto* sql = param(message, 0).if_string();
  if (!sql)
    return fail_with(
        message,
        {ErrorKind::type, "Query needs SQL as its first parameter.", {}});
  if (transactions_.lost_by(message.session))
    return fail_with(message, no_transaction(message, true));
  const bool write = is_write(message);
  auto& connection =
      reader_ && !write && !transactions_.held_by(message.session) ? *reader_
                                                                   : *writer_;
  auto result = connection.run(*sql, param(message, 1),
                               write ? Access::write : Access::read);
  if (!result) {
    fail_with(message, result.error());
    return notice_lost_transaction(message.session);
  }
  std::vector<Value> params{std::move(result->rows)};
  if (write)
    params.emplace_back(result->changes);
  answer(message, "Result", std::move(params));
}

// SQLite itself rolls back after some failures, such as a full disk.
void SQLiteDatabase::notice_lost_transaction(const SessionId& session) {
  if (!transactions_.held_by(session) || writer_->in_transaction())
    return;
  no_longer_timed(transactions_.ticket());
  transactions_.take_away();
  let_others_on();
}

void SQLiteDatabase::begin(const Message& message) {
  if (transactions_.held_by(message.session))
    return fail_with(message, {ErrorKind::database,
                               "Begin: this conversation is in a transaction "
                               "already.",
                               {}});
  if (auto begun = writer_->begin(); !begun)
    return fail_with(message, begun.error());
  transactions_.forget_loss(message.session);
  const auto ticket = transactions_.hold(message.session);
  give_time(ticket, options_.transaction_timeout, &SQLiteDatabase::take_away);
  answer(message, "Result", {ResultSet{}});
}

void SQLiteDatabase::end(const Message& message) {
  if (!transactions_.held_by(message.session)) {
    const bool lost = transactions_.lost_by(message.session);
    transactions_.forget_loss(message.session);
    return fail_with(message, no_transaction(message, lost));
  }
  auto ended =
      message.command == "Commit" ? writer_->commit() : writer_->rollback();
  if (!ended && message.command == "Commit")
    (void)writer_->rollback();
  no_longer_timed(transactions_.ticket());
  transactions_.release();
  if (ended)
    answer(message, "Result", {ResultSet{}});
  else
    fail_with(message, ended.error());
  let_others_on();
}

void SQLiteDatabase::take_away(Ticket ticket) {
  if (!writer_ || !transactions_.holds(ticket))
    return;
  (void)writer_->rollback();
  transactions_.take_away();
  host().log("A transaction was open for too long and was rolled back.");
  let_others_on();
}

void SQLiteDatabase::fail_with(const Message& message, const Error& error) {
  answer(message, "Error", {name_of(error.kind), error.message});
}

PluginFactory sqlite_database_factory() {
  PluginDescription description;
  description.name = "SQLiteDatabase";
  description.roles = {"Database"};
  description.sentence = "an SQLite database, in a file or in memory";
  description.options = sqlite_option_descriptions();
  description.blocks = true;
  return {description, [] { return std::make_unique<SQLiteDatabase>(); }};
}

} // namespace parlour::adapters
