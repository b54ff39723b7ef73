#include "adapters/journal/journal_folder.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include "adapters/journal/journal_format.hpp"

namespace parlour::adapters {

namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

constexpr auto gather_time = 5ms;
constexpr std::size_t soon_bytes = 64 << 10;
// Kept while nothing can be written.
constexpr std::size_t max_waiting_bytes = std::size_t{64} << 20;
constexpr auto retry_time = 1s;

tl::unexpected<Error> failed(const fs::path& path, const std::string& what) {
  return fail(ErrorKind::file, path.string() + ": " + what);
}

} // namespace

Expected<std::unique_ptr<JournalFolder>>
JournalFolder::open(const fs::path& folder, Options options) {
  std::error_code error;
  fs::create_directories(folder, error);
  const int descriptor =
      error ? -1 : ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0)
    return failed(folder, "the journal's folder cannot be opened: " +
                              (error ? error.message()
                                     : std::string(std::strerror(errno))));
  Descriptor lock(descriptor);
  if (flock(descriptor, LOCK_EX | LOCK_NB) != 0)
    return failed(folder, "another run keeps its journal there");
  const auto parts = parts_of(folder);
  if (!parts)
    return tl::make_unexpected(parts.error());
  std::unique_ptr<JournalFolder> journal(
      new JournalFolder(folder, std::move(options), std::move(lock)));
  const auto number = parts->empty() ? 1 : parts->rbegin()->first + 1;
  journal->current_ = std::make_shared<const Part>(Part{number});
  journal->carried_ = parts->empty() ? number : first_needed(*parts);
  if (auto begun = journal->begin_part(number); !begun)
    return failed(folder,
                  "the journal cannot be written: " + begun.error().message);
  journal->thread_ = std::thread([raw = journal.get()] { raw->run(); });
  return journal;
}

JournalFolder::JournalFolder(fs::path folder, Options options, Descriptor lock)
    : folder_(std::move(folder)), options_(std::move(options)),
      lock_(std::move(lock)) {}

JournalFolder::~JournalFolder() {
  if (!thread_.joinable())
    return;
  {
    std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

// -- any thread ---------------------------------------------------------------

Journal::Place JournalFolder::append(std::string record) {
  auto bytes = framed(record);
  std::lock_guard lock(mutex_);
  if (waiting_.size() + bytes.size() > max_waiting_bytes) {
    ++lost_;
    return {0, current_->number};
  }
  waiting_ += bytes;
  if (waiting_.size() == bytes.size() || waiting_.size() >= soon_bytes)
    changed_.notify_all();
  return {++appended_, current_->number};
}

void JournalFolder::when_written(std::uint64_t record,
                                 std::function<void()> done) {
  {
    std::lock_guard lock(mutex_);
    if (record > done_) {
      told_when_.emplace_back(record, std::move(done));
      return;
    }
  }
  done();
}

void JournalFolder::forget_who_waits() {
  std::unique_lock lock(mutex_);
  told_when_.clear();
  changed_.wait(lock, [this] { return !tells_; });
}

std::shared_ptr<const Journal::Part> JournalFolder::hold() {
  std::lock_guard lock(mutex_);
  held_[current_->number] = current_;
  return current_;
}

void JournalFolder::flush() {
  std::unique_lock lock(mutex_);
  hurries_ = true;
  changed_.notify_all();
  changed_.wait(lock, [&, all = appended_] { return done_ >= all || fails_; });
}

std::uint64_t JournalFolder::lost() const {
  std::lock_guard lock(mutex_);
  return lost_;
}

Metrics JournalFolder::metrics() const {
  std::unique_lock lock(mutex_);
  const auto appended = appended_;
  const auto written = done_;
  const auto lost = lost_;
  const auto waiting = waiting_.size();
  const bool fails = fails_;
  lock.unlock();
  using enum MetricKind;
  const auto number = [](auto count) { return static_cast<double>(count); };
  return {metric("parlour_journal_records_total", counter,
                 "Records that were written.", number(written)),
          metric("parlour_journal_bytes_total", counter, "Bytes of them.",
                 number(bytes_.value())),
          metric("parlour_journal_groups_total", counter,
                 "Groups in which they were written.", number(groups_.value())),
          metric("parlour_journal_lost_records_total", counter,
                 "Records that could not be kept.", number(lost)),
          metric("parlour_journal_waiting_records", gauge,
                 "Records that are not written yet.",
                 number(appended - written)),
          metric("parlour_journal_waiting_bytes", gauge,
                 "Bytes that wait for the next group.", number(waiting)),
          metric("parlour_journal_writable", gauge,
                 "0: the last group could not be written.", fails ? 0 : 1),
          metric("parlour_journal_write_seconds",
                 "How long it takes to write a group.", write_time_)};
}

// -- the journal's thread -----------------------------------------------------

// One batch after the other; the lock is not held while the disk works.
void JournalFolder::run() {
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
    const auto number = current_->number;
    // What comes from now on stands in the next part. The batch may be the
    // first of its own, which is begun when it is written.
    const auto before = number == part_number_ ? part_->size() : 0;
    if (before + batch.size() >= options_.part_bytes)
      current_ = std::make_shared<const Part>(Part{number + 1});
    lock.unlock();
    const auto begun = std::chrono::steady_clock::now();
    const auto written = write(batch, number);
    if (written) {
      write_time_.observe((std::chrono::steady_clock::now() - begun) / 1ns);
      groups_.add();
      bytes_.add(batch.size());
    }
    lock.lock();
    const bool failed_before = std::exchange(fails_, !written);
    if (!written) {
      waiting_.insert(0, batch); // it stands in a later part than it was told
      if (!failed_before && options_.log)
        options_.log(folder_.string() + ": the journal cannot be written: " +
                     written.error().message +
                     "; it is tried again each second");
      changed_.notify_all();
      if (ends_)
        return lose(waiting_.size(), written.error().message);
      changed_.wait_for(lock, retry_time, [&] { return ends_; });
      continue;
    }
    if (failed_before && options_.log)
      options_.log(folder_.string() + ": the journal goes on; records lost: " +
                   std::to_string(lost_));
    done_ = until;
    decltype(told_when_) due;
    while (!told_when_.empty() && told_when_.front().first <= done_) {
      due.push_back(std::move(told_when_.front()));
      told_when_.pop_front();
    }
    tells_ = true;
    lock.unlock();
    for (const auto& [record, done] : due)
      done();
    due.clear();
    lock.lock();
    tells_ = false;
    changed_.notify_all();
  }
}

Expected<void> JournalFolder::write(std::string_view bytes,
                                    std::uint64_t number) {
  if (number != part_number_)
    if (auto begun = begin_part(number); !begun)
      return begun;
  return part_->append(bytes);
}

Expected<void> JournalFolder::begin_part(std::uint64_t number) {
  std::uint64_t needed = carried_;
  if (part_) {
    std::lock_guard lock(mutex_);
    needed = oldest_held(number);
  }
  auto part =
      JournalPart::make(part_path(folder_, number), needed, options_.sync);
  if (!part)
    return tl::make_unexpected(std::move(part.error()));
  part_ = std::make_unique<JournalPart>(std::move(*part));
  part_number_ = number;
  remove_old_parts(needed);
  return {};
}

std::uint64_t JournalFolder::oldest_held(std::uint64_t below) {
  std::erase_if(held_, [](const auto& one) { return one.second.expired(); });
  return held_.empty() ? below : std::min(held_.begin()->first, below);
}

// What is written last in a part is younger than it.
void JournalFolder::remove_old_parts(std::uint64_t needed) {
  const auto parts = parts_of(folder_);
  if (!parts)
    return; // it is tried with the next part
  const auto too_old = fs::file_time_type::clock::now() - options_.keep;
  std::error_code error;
  for (const auto& [number, path] : *parts)
    if (number < needed && fs::last_write_time(path, error) < too_old && !error)
      fs::remove(path, error);
}

void JournalFolder::lose(std::size_t bytes, const std::string& why) {
  if (options_.log)
    options_.log(
        folder_.string() + ": the last " + std::to_string(bytes) +
        " bytes are not in the journal: " + why +
        (lost_ > 0 ? "; records lost before: " + std::to_string(lost_) : ""));
}

} // namespace parlour::adapters
