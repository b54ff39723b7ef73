#include "adapters/asr/moonshine_program.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace parlour::adapters::moonshine {

namespace {

using Steady = std::chrono::steady_clock;

// How long a program that has closed its output may take to exit.
constexpr Milliseconds last_breath{500};

Timestamp milliseconds_now() {
  return std::chrono::duration_cast<Milliseconds>(
             Steady::now().time_since_epoch())
      .count();
}

std::string system_message() {
  return std::generic_category().message(errno);
}

} // namespace

// The process and our ends: one socket for its standard input and output, and a
// pipe for its errors.
// Exists as long as the program may be talked to; end() takes it away.
//
//   ours                          theirs
//   socket_, read and written     standard input and output
//   errors_, read                 standard error
class MoonshineProgram::Connection {
public:
  static Expected<std::unique_ptr<Connection>> open(const ProgramOrder& order) {
    auto made = std::unique_ptr<Connection>(new Connection);
    std::array<int, 2> socket{};
    std::array<int, 2> errors{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, socket.data()) != 0)
      return fail(ErrorKind::limit, "no socket: " + system_message());
    made->socket_ = socket[0];
    made->theirs_[0] = socket[1];
    if (pipe2(errors.data(), O_CLOEXEC) != 0)
      return fail(ErrorKind::limit, "no pipe: " + system_message());
    made->errors_ = errors[0];
    made->theirs_[1] = errors[1];
    return made->run(order).map([&] { return std::move(made); });
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  ~Connection() {
    close_theirs();
    for (const auto ours : {socket_, errors_})
      if (ours >= 0)
        ::close(ours);
  }

  int socket() const {
    return socket_;
  }
  int errors() const {
    return errors_;
  }
  void kill() {
    process_->kill();
  }
  std::string bury(Milliseconds patience) {
    return process_->bury(patience);
  }

private:
  Connection() = default;

  Expected<void> run(const ProgramOrder& order) {
    for (const auto ours : {socket_, errors_})
      fcntl(ours, F_SETFL, O_NONBLOCK);
    const std::array given = {theirs_[0], theirs_[0], theirs_[1]};
    auto process = StartedProcess::start(order.program, order.arguments, given);
    // Only then is the end of the process noticed.
    close_theirs();
    if (!process)
      return tl::make_unexpected(process.error());
    process_ = std::move(*process);
    return {};
  }

  void close_theirs() {
    for (auto& theirs : theirs_)
      if (const auto one = std::exchange(theirs, -1); one >= 0)
        ::close(one);
  }

  int socket_ = -1;
  int errors_ = -1;
  std::array<int, 2> theirs_{-1, -1};
  std::unique_ptr<StartedProcess> process_;
};

// The loop exists before its owner does: it learns of it by a shared pointer.
Expected<std::unique_ptr<MoonshineProgram>>
MoonshineProgram::start(const ProgramOrder& order, ProgramCalls calls) {
  const auto owner = std::make_shared<MoonshineProgram*>();
  auto loop = Loop::start([owner](const std::string& what) {
    (*owner)->end("what it says could not be passed on: " + what);
  });
  if (!loop)
    return tl::make_unexpected(loop.error());
  auto connection = Connection::open(order);
  if (!connection)
    return tl::make_unexpected(connection.error());
  std::unique_ptr<MoonshineProgram> program(new MoonshineProgram(
      order, std::move(calls), std::move(*loop), std::move(*connection)));
  *owner = program.get();
  program->loop_->post([owner] { (*owner)->listen(); });
  return program;
}

MoonshineProgram::MoonshineProgram(const ProgramOrder& order,
                                   ProgramCalls calls,
                                   std::unique_ptr<Loop> loop,
                                   std::unique_ptr<Connection> connection)
    : order_(order), calls_(std::move(calls)), loop_(std::move(loop)),
      connection_(std::move(connection)), errors_(calls_.print),
      started_(Steady::now()), input_(*loop_, [this](short) { write(); }),
      output_(*loop_, [this](short) { read(); }),
      error_output_(*loop_, [this](short) { read_errors(); }),
      alarm_(*loop_, [this] { look_at_clock(); }) {}

// What still happens on the loop finds no connection.
MoonshineProgram::~MoonshineProgram() {
  loop_->post([this] {
    for (auto* const watch : {&input_, &output_, &error_output_})
      watch->stop();
    connection_.reset();
  });
  loop_->stop();
}

void MoonshineProgram::send(std::string frame) {
  loop_->post([this, frame = std::move(frame)] {
    if (!connection_)
      return;
    unsent_ += frame;
    if (unsent_.size() > order_.most_unsent)
      return end("it does not read what it is sent");
    write();
  });
}

// The debt is noted before the frame is sent, so that no answer comes earlier.
void MoonshineProgram::ask(TurnNumber turn, std::string frame) {
  loop_->post([this, turn] {
    awaited_.emplace(turn, Steady::now());
    look_at_clock();
  });
  send(std::move(frame));
}

// -- on the loop's thread -----------------------------------------------------

void MoonshineProgram::listen() {
  look_at_clock();
  if (!connection_)
    return;
  output_.await(connection_->socket(), POLLIN);
  error_output_.await(connection_->errors(), POLLIN);
}

// One piece, then the loop's other work; end of file means that it has closed
// its output.
void MoonshineProgram::read() {
  if (!connection_)
    return;
  std::array<char, 1 << 14> bytes;
  const auto count = ::read(connection_->socket(), bytes.data(), bytes.size());
  if (count > 0)
    take({bytes.data(), static_cast<std::size_t>(count)});
  else if (count == 0 || (errno != EAGAIN && errno != EINTR))
    return end("");
  if (connection_)
    output_.await(connection_->socket(), POLLIN);
}

void MoonshineProgram::read_errors() {
  if (!connection_)
    return;
  std::array<char, 1 << 12> bytes;
  const auto count = ::read(connection_->errors(), bytes.data(), bytes.size());
  if (count > 0)
    errors_.add({bytes.data(), static_cast<std::size_t>(count)},
                milliseconds_now());
  if (count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR)))
    error_output_.await(connection_->errors(), POLLIN);
}

// Each answer may end the program, and with it the connection.
void MoonshineProgram::take(std::string_view bytes) {
  answers_.add(bytes);
  while (connection_) {
    auto answer = answers_.next();
    if (!answer)
      return end(answer.error().message);
    if (!*answer)
      return;
    take(std::move(**answer));
  }
}

void MoonshineProgram::take(Answer answer) {
  if (answer.kind == AnswerKind::failed)
    return end(answer.text);
  if (answer.kind == AnswerKind::ready)
    return become_ready();
  if (answer.kind != AnswerKind::partial)
    awaited_.erase(answer.turn);
  calls_.answered(std::move(answer));
}

// As much as the socket takes now; the rest when it is ready.
void MoonshineProgram::write() {
  if (!connection_ || unsent_.empty())
    return;
  const auto count = ::send(connection_->socket(), unsent_.data(),
                            unsent_.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  // Where the program has ended, reading notices it.
  if (count > 0)
    unsent_.erase(0, static_cast<std::size_t>(count));
  else if (errno != EAGAIN && errno != EINTR)
    return unsent_.clear();
  if (!unsent_.empty())
    input_.await(connection_->socket(), POLLOUT);
}

// Only now the turns that waited are recognised.
void MoonshineProgram::become_ready() {
  const auto now = Steady::now();
  if (!std::exchange(is_ready_, true))
    calls_.ready(std::chrono::duration_cast<Milliseconds>(now - started_));
  for (auto& [turn, since] : awaited_)
    since = now;
  look_at_clock();
}

std::pair<Loop::Moment, const char*> MoonshineProgram::next_debt() const {
  if (!is_ready_)
    return {started_ + order_.ready_within, "it is not ready in time"};
  const auto next = std::ranges::min_element(
      awaited_, {}, [](const auto& one) { return one.second; });
  return {next == awaited_.end() ? Alarm::never
                                 : next->second + order_.answer_within,
          "it does not answer"};
}

void MoonshineProgram::look_at_clock() {
  if (!connection_)
    return;
  const auto [moment, wrong] = next_debt();
  if (moment <= Steady::now())
    return end(wrong);
  alarm_.set(moment);
}

// `reason` is empty if it ended by itself.
void MoonshineProgram::end(const std::string& reason) {
  if (!connection_)
    return;
  for (auto* const watch : {&input_, &output_, &error_output_})
    watch->stop();
  // Its last words may say why it ended.
  const auto connection = std::move(connection_);
  const auto ending =
      connection->bury(reason.empty() ? last_breath : Milliseconds::zero());
  std::array<char, 1 << 12> bytes;
  for (ssize_t count = 1; count > 0;) {
    count = ::read(connection->errors(), bytes.data(), bytes.size());
    errors_.add(
        {bytes.data(), static_cast<std::size_t>(std::max(count, ssize_t{0}))},
        milliseconds_now());
  }
  errors_.finish();
  calls_.over(reason.empty() ? "it " + ending : reason);
}

} // namespace parlour::adapters::moonshine
