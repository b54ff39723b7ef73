// JournalFile: a journal as one file, to which records are only appended. A
// thread of its own writes what has come every few milliseconds, or sooner
// where much has come.
//
// Where the disk is full or gone, it says so once, tries again each second, and
// meanwhile keeps a bounded number of records; those beyond are lost, counted
// and told. A conversation goes on in any case.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "runtime/base/descriptor.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/journal.hpp"

namespace parlour::adapters {

class JournalFile : public Journal {
public:
  // Called from the journal's thread, one at a time.
  using Log = std::function<void(const std::string&)>;

  // Makes the file, or goes on where it ends. What a crash left unfinished at
  // its end is cut off and told. Errors of kind File: it cannot be opened, is
  // no journal, is damaged, or is another process's.
  static Expected<std::unique_ptr<JournalFile>>
  open(const std::filesystem::path& file, Log log);
  // Writes what is left, for at most a second where that fails.
  ~JournalFile() override;

  void append(std::string record) override;
  // Everything that was appended before is written, or has failed, on return.
  void flush();

  // Records that could not be kept.
  std::uint64_t lost() const;

private:
  JournalFile(Descriptor file, std::filesystem::path path, Log log);

  void run();
  // At the end nothing more can be tried.
  void lose(std::size_t bytes, const std::string& why);
  // False: nothing more can be written now.
  bool write(std::string_view bytes);

  const Descriptor file_;
  const std::filesystem::path path_;
  const Log log_;
  mutable std::mutex mutex_; // guards what follows
  std::condition_variable changed_;
  std::string waiting_; // framed records
  std::uint64_t appended_ = 0;
  std::uint64_t done_ = 0; // of those appended: written, or lost
  std::uint64_t lost_ = 0;
  bool fails_ = false;
  bool hurries_ = false;
  bool ends_ = false;
  std::thread thread_;
};

} // namespace parlour::adapters
