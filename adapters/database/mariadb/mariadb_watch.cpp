#include "adapters/database/mariadb/mariadb_watch.hpp"

#include <algorithm>
#include <utility>

#include "adapters/database/column_reference.hpp"
#include "adapters/database/mariadb/mariadb_columns.hpp"

namespace parlour::adapters {

namespace {

using Steady = std::chrono::steady_clock;

// The plug-in must not wait longer when it stops.
constexpr Milliseconds patience{1'000};

std::shared_ptr<const MariaDBOptions> of_columns(MariaDBOptions options) {
  options = with_room_for_a_column(std::move(options));
  options.connect_timeout = std::min(options.connect_timeout, patience);
  return std::make_shared<const MariaDBOptions>(std::move(options));
}

// A query whose answer changes with the values. Both names are plain.
std::string signature_of(const ColumnReference& place) {
  return "select count(*), sum(crc32(\"" + place.column + "\")) from \"" +
         place.table + "\"";
}

} // namespace

std::chrono::steady_clock::duration
pause_after_look(std::chrono::steady_clock::duration took, Milliseconds watch) {
  return std::max<Steady::duration>(watch, 10 * took);
}

Expected<std::unique_ptr<MariaDBWatch>>
MariaDBWatch::start(const MariaDBOptions& options,
                    std::function<void(const ValueWatch::News&)> told) {
  auto loop = Loop::start([](const std::string&) {});
  if (!loop)
    return tl::make_unexpected(loop.error());
  return std::unique_ptr<MariaDBWatch>(
      new MariaDBWatch(options, std::move(*loop), std::move(told)));
}

MariaDBWatch::MariaDBWatch(const MariaDBOptions& options,
                           std::unique_ptr<Loop> loop,
                           std::function<void(const ValueWatch::News&)> told)
    : options_(of_columns(options)), loop_(std::move(loop)),
      told_(std::move(told)), values_(options.columns),
      alarm_(*loop_, [this] { look(); }) {
  loop_->post([this] { look(); });
}

MariaDBWatch::~MariaDBWatch() {
  loop_->stop();
}

void MariaDBWatch::look_now() {
  std::promise<void> done;
  loop_->post([&] {
    look();
    done.set_value();
  });
  done.get_future().wait();
}

// An attempt to connect counts for nothing: it is no work for the server.
void MariaDBWatch::look() {
  auto took = Steady::duration::zero();
  if (is_connected()) {
    const auto begun = Steady::now();
    compare();
    took = Steady::now() - begun;
  }
  if (options_->watch != Milliseconds::zero())
    alarm_.set(Steady::now() + pause_after_look(took, options_->watch));
}

void MariaDBWatch::compare() {
  auto now = signature();
  if (!now || *now == last_)
    return;
  const auto news =
      values_.look([this](const std::string& column) { return read(column); });
  if (news.errors.empty())
    last_ = std::move(*now);
  if (!news.changed.empty() || !news.errors.empty())
    told_(news);
}

// The components's own connections tell why there is none.
bool MariaDBWatch::is_connected() {
  if (connection_ && !connection_->state().lost())
    return true;
  connection_ = std::make_unique<MariaDBConnection>(options_);
  connection_->give_time(patience);
  return carry_out(*connection_,
                   connection_->open(MariaDBConnection::To::database))
      .has_value();
}

std::optional<std::string> MariaDBWatch::signature() {
  std::string all;
  for (const auto& column : options_->columns) {
    const auto place = parse_column(within_database(column));
    if (!place)
      continue;
    connection_->give_time(patience);
    const auto answer = carry_out(
        *connection_, connection_->run(signature_of(*place), {}, Access::read));
    if (connection_->state().lost())
      return {};
    // A table that is missing is one that differs, and reading it says so.
    all += answer ? to_string(Value(List(answer->rows.cells.begin(),
                                         answer->rows.cells.end())))
                  : answer.error().message;
  }
  return all;
}

Expected<ValueWatch::Values> MariaDBWatch::read(const std::string& column) {
  const auto place = parse_column(within_database(column));
  if (!place)
    return tl::make_unexpected(place.error());
  connection_->give_time(options_->query_timeout);
  return read_column(*connection_, *place);
}

} // namespace parlour::adapters
