// MemoryJournal: a journal for tests. It keeps records in memory, and writes
// them when the test says so.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "runtime/base/outside/journal.hpp"

namespace parlour::test {

class MemoryJournal : public Journal {
public:
  std::vector<std::string> records;
  bool writes_at_once = true;
  bool is_full = false; // what comes is lost

  // All that was appended.
  void write() {
    written_ = records.size();
    auto waiting = std::exchange(waiting_, {});
    for (auto& [record, done] : waiting)
      if (record <= written_)
        done();
      else
        waiting_.emplace_back(record, std::move(done));
  }
  // What comes stands in another part.
  void begin_part() {
    part_ = std::make_shared<const Part>(Part{part_->number + 1});
  }
  bool is_held(std::uint64_t part) const {
    return part_->number == part && part_.use_count() > 1;
  }
  std::size_t waiting() const {
    return waiting_.size();
  }

  Place append(std::string record) override {
    if (is_full)
      return {0, part_->number};
    records.push_back(std::move(record));
    if (writes_at_once)
      written_ = records.size();
    return {records.size(), part_->number};
  }
  void when_written(std::uint64_t record, std::function<void()> done) override {
    if (record <= written_)
      return done();
    waiting_.emplace_back(record, std::move(done));
  }
  void forget_who_waits() override {
    waiting_.clear();
  }
  std::shared_ptr<const Part> hold() override {
    return part_;
  }

private:
  std::uint64_t written_ = 0;
  std::vector<std::pair<std::uint64_t, std::function<void()>>> waiting_;
  std::shared_ptr<const Part> part_ = std::make_shared<const Part>(Part{1});
};

} // namespace parlour::test
