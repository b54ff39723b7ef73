// The plug-in around two SQLiteConnections. Statements run in the calling
// thread; what must wait for the end of a transaction is queued in
// SQLiteTransactions.
#include "adapters/database/sqlite/sqlite_database.hpp"

#include <utility>

#include "adapters/database/sqlite/sqlite_columns.hpp"
#include "adapters/database/sqlite/sqlite_image.hpp"
#include "adapters/database/sqlite/sqlite_open.hpp"
#include "adapters/database/sqlite/sqlite_origin.hpp"

namespace parlour::adapters {

Expected<void> SQLiteDatabase::on_start(const Options& options) {
  auto read = read_sqlite_options(options, host().data_folder(),
                                  host().application_folder());
  if (!read)
    return tl::make_unexpected(read.error());
  options_ = std::move(*read);
  auto opened = options_.in_memory() ? open_memory_copy() : open();
  if (opened)
    watch_values();
  return opened;
}

Expected<void> SQLiteDatabase::open_memory_copy() {
  auto image = sqlite_image(options_.schema, options_.seed);
  if (!image)
    return tl::make_unexpected(image.error());
  auto handle = open_image(*image);
  if (!handle)
    return tl::make_unexpected(handle.error());
  writer_ = std::make_unique<SQLiteConnection>(
      std::move(*handle), options_.limits(), options_.busy_timeout);
  return {};
}

// Opens the file with one connection for writing and one for reading. A file
// that exists is used as it is, even if schema or seed have changed since.
Expected<void> SQLiteDatabase::open() {
  if (!std::filesystem::exists(options_.file)) {
    if (auto created = create_missing(); !created)
      return created;
  } else if (has_other_origin(options_)) {
    host().log("schema or seed have changed since " + options_.file.string() +
               " was made, which is used as it is. To have it made anew, run "
               "with --fresh, or move it away.");
  }
  if (auto sound = check_sound(options_.file, options_.busy_timeout); !sound)
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

// Creates the file and records, beside it, of which sources it was made.
Expected<void> SQLiteDatabase::create_missing() const {
  if (options_.schema.empty())
    return fail(ErrorKind::settings,
                "There is no such database, and no option 'schema' says how "
                "to make it.",
                {options_.file.string(), 0, 0});
  auto image = sqlite_image(options_.schema, options_.seed);
  if (!image)
    return tl::make_unexpected(image.error());
  return write_image(*image, options_.file).and_then([this] {
    return note_origin(options_);
  });
}

Expected<std::unique_ptr<SQLiteConnection>> SQLiteDatabase::connect() const {
  auto handle = open_file(options_.file, Missing::refuse);
  if (!handle)
    return tl::make_unexpected(handle.error());
  if (auto allowed =
          allow_writing(handle->get(), options_.file, options_.busy_timeout);
      !allowed)
    return tl::make_unexpected(allowed.error());
  return std::make_unique<SQLiteConnection>(
      std::move(*handle), options_.limits(), options_.busy_timeout);
}

// Answers every waiting message, so that no session waits for its time limit.
void SQLiteDatabase::stop() {
  watch_.reset();
  if (transactions_.held() && writer_)
    (void)writer_->rollback();
  for (const auto& [ticket, delay] : std::exchange(delays_, {}))
    host().cancel(delay);
  while (auto waiting = transactions_.next())
    fail_with(waiting->message, database_closed());
  transactions_ = {};
  reader_.reset();
  writer_.reset();
}

// -- the values of columns ----------------------------------------------------

void SQLiteDatabase::watch_values() {
  values_ = ValueWatch(options_.columns);
  look_at_values();
  if (values_.is_idle() || options_.in_memory() ||
      options_.watch == Milliseconds::zero())
    return;
  auto watch = SQLiteWatch::start(options_.file, options_.watch, [this] {
    host().after(Milliseconds::zero(), [this] { look_at_values(); });
  });
  if (watch)
    watch_ = std::move(*watch);
  else
    host().log("What other programs write is not noticed: " +
               watch.error().message);
}

// What is not committed is not there yet.
void SQLiteDatabase::note_written() {
  if (values_.is_idle())
    return;
  written_.merge(writer_->take_written());
  if (transactions_.held())
    return;
  if (values_.concerns(std::exchange(written_, {})))
    look_at_values();
}

void SQLiteDatabase::look_at_values() {
  if (!writer_ || (!reader_ && transactions_.held()))
    return;
  auto& connection = reader_ ? *reader_ : *writer_;
  const auto news = values_.look([&](const std::string& column) {
    return read_column(connection, within_database(column));
  });
  for (const auto& error : news.errors)
    host().log("A column cannot be read, so its values stay as they are: " +
               error.message);
  for (const auto& [column, values] : news.changed)
    host().fire_event(values_changed(column, values));
}

// -- messages -----------------------------------------------------------------

void SQLiteDatabase::on_message(const Message& message) {
  const auto command = command_of(message);
  if (!writer_)
    fail_with(message, database_closed());
  else if (!command)
    fail_with(message, command.error());
  else if (must_wait(*command, message))
    wait(message);
  else
    handle(*command, message);
}

void SQLiteDatabase::handle(DatabaseCommand command, const Message& message) {
  switch (command) {
  case DatabaseCommand::connect:
    return check_connection(message);
  case DatabaseCommand::query:
    return query(message);
  case DatabaseCommand::begin:
    return begin(message);
  case DatabaseCommand::commit:
  case DatabaseCommand::rollback:
    return end(command, message);
  }
}

// Commit and rollback of a session without a transaction are not delayed: they
// fail at once.
bool SQLiteDatabase::must_wait(DatabaseCommand command,
                               const Message& message) const {
  if (!transactions_.held() || transactions_.held_by(message.session))
    return false;
  return command == DatabaseCommand::begin ||
         (command == DatabaseCommand::query && (is_write(message) || !reader_));
}

// Queues the message, with a time limit.
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

// Calls `time_is_up` for the ticket unless no_longer_timed comes first.
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

// A handled message may itself begin a transaction; the loop then ends, and the
// messages behind it go on waiting with their timers.
void SQLiteDatabase::let_others_on() {
  while (!transactions_.held()) {
    const auto waiting = transactions_.next();
    if (!waiting)
      return;
    no_longer_timed(waiting->ticket);
    handle(*command_of(waiting->message), waiting->message);
  }
}

// A component has exactly one database, which its settings name, not the
// script: <connectdb> can only ask for that one.
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

// A read outside of the session's own transaction uses the reader, all else
// uses the writer. After an error the transaction may be gone.
void SQLiteDatabase::query(const Message& message) {
  if (transactions_.lost_by(message.session))
    return fail_with(message, rolled_back(message));
  const auto access = is_write(message) ? Access::write : Access::read;
  auto& connection = reader_ && access == Access::read &&
                             !transactions_.held_by(message.session)
                         ? *reader_
                         : *writer_;
  auto result =
      connection.run(*param(message, 0).if_string(), param(message, 1), access);
  if (result) {
    answer(message, "Result", result_params(message, std::move(*result)));
    return note_written();
  }
  fail_with(message, result.error());
  notice_lost_transaction(message.session);
}

// SQLite rolls a transaction back by itself after some errors, such as a full
// disk. The session learns of it with its next statement.
void SQLiteDatabase::notice_lost_transaction(const SessionId& session) {
  if (!transactions_.held_by(session) || writer_->in_transaction())
    return;
  no_longer_timed(transactions_.ticket());
  transactions_.take_away();
  let_others_on();
}

// The ticket limits the duration of the transaction: a session that never ends
// it must not block all others.
void SQLiteDatabase::begin(const Message& message) {
  if (transactions_.held_by(message.session))
    return fail_with(message, already_begun());
  if (auto begun = writer_->begin(); !begun)
    return fail_with(message, begun.error());
  transactions_.forget_loss(message.session);
  const auto ticket = transactions_.hold(message.session);
  give_time(ticket, options_.transaction_timeout, &SQLiteDatabase::take_away);
  answer(message, "Result", {ResultSet{}});
}

// Commit or Rollback. A commit that fails is followed by a rollback, so that
// the database is free afterwards in every case.
void SQLiteDatabase::end(DatabaseCommand how, const Message& message) {
  if (!transactions_.held_by(message.session)) {
    const bool lost = transactions_.lost_by(message.session);
    transactions_.forget_loss(message.session);
    return fail_with(message, lost ? rolled_back(message) : not_begun(message));
  }
  const bool commits = how == DatabaseCommand::commit;
  auto ended = commits ? writer_->commit() : writer_->rollback();
  if (!ended && commits)
    (void)writer_->rollback();
  no_longer_timed(transactions_.ticket());
  transactions_.release();
  if (ended)
    answer(message, "Result", {ResultSet{}});
  else
    fail_with(message, ended.error());
  note_written();
  let_others_on();
}

// The transaction of this ticket has been open for too long. The ticket is
// compared, since a new transaction may hold the database by now.
void SQLiteDatabase::take_away(Ticket ticket) {
  if (!writer_ || !transactions_.holds(ticket))
    return;
  (void)writer_->rollback();
  transactions_.take_away();
  host().log("A transaction was open for too long and was rolled back.");
  let_others_on();
}

void SQLiteDatabase::fail_with(const Message& message, const Error& error) {
  answer(message, "Error", error_params(error));
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
