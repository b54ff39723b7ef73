// JournalFolder: a journal as a folder of parts (journal_format.hpp). A thread
// of its own writes what has come every few milliseconds, or sooner where much
// has come; begins a new part when one is large; and removes parts that are old
// and that no open session needs.
//
// Where the disk is full or gone, it says so once, tries again each second, and
// meanwhile keeps a bounded number of records; those beyond are lost, counted
// and told. Nobody waits for it.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "adapters/journal/journal_part.hpp"
#include "runtime/base/outside/descriptor.hpp"
#include "runtime/base/outside/journal.hpp"

namespace parlour::adapters {

class JournalFolder : public Journal {
public:
  struct Options {
    // Called from the journal's thread, one at a time.
    std::function<void(const std::string&)> log;
    JournalSync sync = JournalSync::with_system;
    std::size_t part_bytes = std::size_t{64} << 20; // then a new one begins
    std::chrono::seconds keep = std::chrono::hours(24 * 7);
  };

  // Makes the folder, or goes on in it with a new part; parts that are there
  // are not touched but by their age. Errors of kind File: it cannot be
  // written, or is another process's.
  static Expected<std::unique_ptr<JournalFolder>>
  open(const std::filesystem::path& folder, Options options);
  // Writes what is left; gives up where that fails.
  ~JournalFolder() override;

  Place append(std::string record) override;
  void when_written(std::uint64_t record, std::function<void()> done) override;
  void forget_who_waits() override;
  std::shared_ptr<const Part> hold() override;
  Metrics metrics() const override;

  // Everything that was appended before is written, or has failed, on return.
  void flush();
  // Records that could not be kept.
  std::uint64_t lost() const;

private:
  JournalFolder(std::filesystem::path folder, Options options, Descriptor lock);

  void run();
  // Of a batch and of the part that it is for, without the lock.
  Expected<void> write(std::string_view bytes, std::uint64_t number);
  Expected<void> begin_part(std::uint64_t number);
  void remove_old_parts(std::uint64_t needed);
  // At the end nothing more can be tried.
  void lose(std::size_t bytes, const std::string& why);
  // The oldest part that somebody holds, if it is below; with the lock.
  std::uint64_t oldest_held(std::uint64_t below);

  const std::filesystem::path folder_;
  const Options options_;
  const Descriptor lock_; // nobody else writes here
  // The oldest part that the sessions of the run before need: they write to the
  // first part of this run when they go on.
  std::uint64_t carried_ = 0;
  // The thread's, once it runs.
  std::unique_ptr<JournalPart> part_;
  std::uint64_t part_number_ = 0;

  mutable std::mutex mutex_; // guards what follows
  std::condition_variable changed_;
  std::string waiting_; // framed records
  std::shared_ptr<const Part> current_;
  std::map<std::uint64_t, std::weak_ptr<const Part>> held_;
  std::uint64_t appended_ = 0;
  std::uint64_t done_ = 0; // of those appended: written
  std::uint64_t lost_ = 0;
  std::deque<std::pair<std::uint64_t, std::function<void()>>> told_when_;
  bool tells_ = false; // who waits is being called
  bool fails_ = false;
  bool hurries_ = false;
  bool ends_ = false;
  // What was written.
  Counter groups_;
  Counter bytes_;
  Histogram write_time_;
  std::thread thread_;
};

} // namespace parlour::adapters
