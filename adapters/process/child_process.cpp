#include "adapters/process/child_process.hpp"

#include <cerrno>
#include <iterator>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

namespace parlour::adapters {

namespace {

// Our end does not block, and no other child inherits it.
bool make_pipe(int (&ends)[2]) {
  return pipe2(ends, O_CLOEXEC) == 0 &&
         fcntl(ends[0], F_SETFL, O_NONBLOCK) == 0;
}

tl::unexpected<Error> not_started(const std::filesystem::path& program) {
  return fail(ErrorKind::settings, program.string() + " does not start: " +
                                       std::generic_category().message(errno));
}

} // namespace

Expected<std::unique_ptr<ChildProcess>>
ChildProcess::spawn(const std::filesystem::path& program,
                    const std::vector<std::string>& arguments) {
  int ends[2];
  int output[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    return not_started(program);
  if (!make_pipe(output)) {
    auto error = not_started(program);
    for (const auto end : ends)
      ::close(end);
    return error;
  }
  const int given[] = {-1, output[1], output[1], ends[1]};
  static_assert(std::size(given) == component_socket + 1);
  auto process = StartedProcess::start(program, arguments, given);
  // The child has its own copies, so our copies of its ends are closed in
  // either case: only then is a closed socket noticed.
  for (const auto theirs : {ends[1], output[1]})
    ::close(theirs);
  if (process)
    return std::unique_ptr<ChildProcess>(
        new ChildProcess(std::move(*process), ends[0], output[0]));
  for (const auto ours : {ends[0], output[0]})
    ::close(ours);
  return tl::make_unexpected(process.error());
}

ChildProcess::ChildProcess(std::unique_ptr<StartedProcess> process, int socket,
                           int output)
    : process_(std::move(process)), output_(output), socket_(socket) {}

ChildProcess::~ChildProcess() {
  if (output_ >= 0)
    ::close(output_);
}

std::string ChildProcess::read_output() {
  std::string bytes(1 << 16, '\0');
  const auto got =
      output_ < 0 ? 0 : ::read(output_, bytes.data(), bytes.size());
  if (got == 0 && output_ >= 0)
    // A pipe at its end would be readable for ever, and wait() would not block.
    ::close(std::exchange(output_, -1));
  bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  return bytes;
}

} // namespace parlour::adapters
