#include "adapters/journal/journal_file.hpp"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "adapters/journal/journal_format.hpp"
#include "runtime/base/file_bytes.hpp"

namespace parlour::adapters {

namespace {

using namespace std::chrono_literals;

constexpr auto gather_time = 5ms;
constexpr std::size_t soon_bytes = 64 << 10;
// Kept while nothing can be written.
constexpr std::size_t max_waiting_bytes = std::size_t{64} << 20;
constexpr auto retry_time = 1s;

tl::unexpected<Error> failed(const std::filesystem::path& path,
                             const std::string& what) {
  return fail(ErrorKind::file, path.string() + ": " + what);
}

tl::unexpected<Error> refused_by_system(const std::filesystem::path& path,
                                        const char* what) {
  return failed(path, std::string(what) + ": " + std::strerror(errno));
}

// How much of the file is whole records; an error where it is damaged.
Expected<std::size_t> whole_bytes(const std::filesystem::path& path) {
  const auto bytes = read_file(path, max_journal_bytes);
  if (!bytes)
    return tl::make_unexpected(bytes.error());
  auto reader = JournalReader::over(*bytes);
  if (!reader)
    return failed(path, reader.error().message);
  while (const auto record = reader->next())
    if (!*record)
      return failed(path, record->error().message);
  return reader->position();
}

} // namespace

Expected<std::unique_ptr<JournalFile>>
JournalFile::open(const std::filesystem::path& path, Log log) {
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0)
    return refused_by_system(path, "the journal cannot be opened");
  std::unique_ptr<JournalFile> journal(
      new JournalFile(Descriptor(file), path, std::move(log)));
  if (flock(file, LOCK_EX | LOCK_NB) != 0)
    return failed(path, "another run keeps its journal there");
  struct stat status {};
  if (fstat(file, &status) != 0)
    return refused_by_system(path, "the journal cannot be looked at");
  if (!S_ISREG(status.st_mode))
    return failed(path, "a journal is a file, and this is none");
  // It has what is private, also where somebody else has made the file.
  if (fchmod(file, S_IRUSR | S_IWUSR) != 0)
    return refused_by_system(path, "only you may read a journal");
  std::size_t whole = 0;
  if (status.st_size == 0) {
    if (!journal->write(journal_magic))
      return refused_by_system(path, "the journal cannot be written");
    whole = journal_magic.size();
  } else if (const auto known = whole_bytes(path)) {
    whole = *known;
  } else {
    return tl::make_unexpected(known.error());
  }
  if (const auto size = static_cast<std::size_t>(status.st_size);
      size > whole) {
    if (ftruncate(file, static_cast<off_t>(whole)) != 0)
      return refused_by_system(path, "the journal cannot be written");
    journal->log_(path.string() + ": the last record was not finished; its " +
                  std::to_string(size - whole) + " bytes are cut off");
  }
  lseek(file, 0, SEEK_END);
  journal->thread_ = std::thread([raw = journal.get()] { raw->run(); });
  return journal;
}

JournalFile::JournalFile(Descriptor file, std::filesystem::path path, Log log)
    : file_(std::move(file)), path_(std::move(path)), log_(std::move(log)) {}

JournalFile::~JournalFile() {
  if (!thread_.joinable())
    return;
  {
    std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void JournalFile::append(std::string record) {
  auto bytes = framed(record);
  std::lock_guard lock(mutex_);
  if (waiting_.size() + bytes.size() > max_waiting_bytes) {
    ++lost_;
    return;
  }
  ++appended_;
  waiting_ += bytes;
  if (waiting_.size() == bytes.size() || waiting_.size() >= soon_bytes)
    changed_.notify_all();
}

void JournalFile::flush() {
  std::unique_lock lock(mutex_);
  hurries_ = true;
  changed_.notify_all();
  changed_.wait(lock, [&, all = appended_] { return done_ >= all || fails_; });
}

std::uint64_t JournalFile::lost() const {
  std::lock_guard lock(mutex_);
  return lost_;
}

// One batch after the other; the lock is not held while the disk works.
void JournalFile::run() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [&] { return ends_ || !waiting_.empty(); });
    if (waiting_.empty())
      return;
    const auto is_due = [&] {
      return ends_ || hurries_ || waiting_.size() >= soon_bytes;
    };
    changed_.wait_for(lock, gather_time, is_due);
    hurries_ = false;
    const auto batch = std::exchange(waiting_, {});
    const auto until = appended_;
    lock.unlock();
    const bool written = write(batch);
    const std::string why = written ? "" : std::strerror(errno);
    lock.lock();
    const bool failed_before = std::exchange(fails_, !written);
    if (written) {
      done_ = until;
      if (failed_before)
        log_(path_.string() +
             ": the journal goes on; records lost: " + std::to_string(lost_));
    } else {
      waiting_.insert(0, batch);
      if (!failed_before)
        log_(path_.string() + ": the journal cannot be written: " + why +
             "; it is tried again each second");
    }
    changed_.notify_all();
    if (!written) {
      if (ends_)
        return lose(waiting_.size(), why);
      changed_.wait_for(lock, retry_time, [&] { return ends_; });
    }
  }
}

void JournalFile::lose(std::size_t bytes, const std::string& why) {
  log_(path_.string() + ": the last " + std::to_string(bytes) +
       " bytes are not in the journal: " + why +
       (lost_ > 0 ? "; records lost before: " + std::to_string(lost_) : ""));
}

// All or nothing: what was written of a batch that failed is cut off again.
bool JournalFile::write(std::string_view bytes) {
  const auto begin = lseek(file_.get(), 0, SEEK_END);
  while (!bytes.empty()) {
    const auto written = ::write(file_.get(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR)
      continue;
    if (written < 0) {
      const int why = errno;
      static_cast<void>(ftruncate(file_.get(), begin));
      errno = why;
      return false;
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

} // namespace parlour::adapters
