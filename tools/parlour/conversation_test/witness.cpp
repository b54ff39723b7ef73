// The parent holds the write end of a pipe, and the child reads from it. When
// the parent ends, in whatever way, the kernel closes the pipe, and the child
// wakes up.
#include "tools/parlour/conversation_test/witness.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tools/parlour/console/exit_code.hpp"

namespace parlour::tools {

namespace {

// Conversations that run now; the exit handler looks at it.
std::atomic<int> held_now = 0;

// A plug-in that calls exit() in the middle of a test must not make the program
// end with status 0. exit() runs this handler, which fails instead.
void refuse_exit() {
  if (held_now > 0)
    _exit(exit_code::wrong);
}

// No stream: the child may use only async-signal-safe functions.
void print(std::string_view text) {
  (void)!write(STDERR_FILENO, text.data(), text.size());
}

} // namespace

Witness::Witness() {
  // Registers the handler once per process.
  static const bool once = std::atexit(&refuse_exit) == 0;
  (void)once;
  int ends[2];
  void* shared = mmap(nullptr, sizeof(Names), PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED)
    return;
  names_ = static_cast<Names*>(shared);
  if (pipe2(ends, O_CLOEXEC) != 0)
    return;
  process_ = fork();
  if (process_ == 0) {
    close(ends[1]);
    watch(ends[0]);
  }
  close(ends[0]);
  end_ = ends[1];
}

// Closing the pipe ends the child. By now every Held is gone, so it finds no
// names.
Witness::~Witness() {
  if (end_ >= 0)
    close(end_);
  while (process_ > 0 && waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
  if (names_)
    munmap(names_, sizeof(Names));
}

// Runs in the child. It was forked from a process that may have had threads, so
// it must not take locks or allocate memory. It ignores the signals that Ctrl-C
// and a closing terminal send to the whole process group.
void Witness::watch(int end) {
  for (const auto number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE})
    signal(number, SIG_IGN);
  close(STDIN_FILENO);
  close(STDOUT_FILENO);
  char nothing;
  while (::read(end, &nothing, 1) < 0 && errno == EINTR) {
  }
  tell();
  _exit(0);
}

void Witness::tell() {
  bool is_first = true;
  for (const auto& name : *names_) {
    if (!*name)
      continue;
    print(is_first ? "error: the program ended while these were held: " : ", ");
    print({name, strnlen(name, longest)});
    is_first = false;
  }
  if (!is_first)
    print("; parlour test APP FILE holds one alone\n");
}

// Takes the first free place and writes the name into it.
Witness::Held::Held(Witness& witness, const std::string& name)
    : place_(nullptr) {
  ++held_now;
  std::lock_guard lock(witness.mutex_);
  if (!witness.names_)
    return;
  const auto free =
      std::find_if(std::begin(*witness.names_), std::end(*witness.names_),
                   [](const auto& taken) { return !*taken; });
  if (free == std::end(*witness.names_))
    return;
  place_ = *free;
  std::strncpy(place_, name.c_str(), longest - 1);
}

// The child may read at any moment; one byte is enough to free a place.
Witness::Held::~Held() {
  --held_now;
  if (place_)
    *place_ = '\0';
}

} // namespace parlour::tools
