// LoadRun: many visitors of a server at a time.
#pragma once

#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tools/parlour/load/visitor.hpp"

namespace parlour::tools {

struct LoadWishes {
  std::size_t visitors = 1; // at a time
  // Conversations that begin in a second (open loop); nothing: each visitor
  // begins another when one is over (closed loop).
  std::optional<double> rate;
  // Until no more begin; without, each visitor plays one.
  std::optional<Milliseconds> duration;
  // Sessions are opened and then left alone for `duration`.
  bool idle = false;
};

class LoadRun {
public:
  // `progress` gets a line from time to time, and may be empty.
  LoadRun(VisitorParts& parts, const std::vector<Played>& conversations,
          LoadWishes wishes, std::function<void(const std::string&)> progress);

  // Blocks until all is over, or interrupt() is called.
  void run();
  // From any thread.
  void interrupt();

  LoadFigures::Duration time() const {
    return end_ - begin_;
  }
  // Of the server: when the first visitor had come, and the most; 0: not known.
  std::uint64_t memory_before() const {
    return parts_.memory_before;
  }
  std::uint64_t memory_most() const {
    return memory_most_;
  }
  std::size_t most_visitors() const {
    return most_visitors_;
  }

private:
  using Moment = LoadFigures::Moment;
  using Visitors = std::list<std::unique_ptr<Visitor>>;

  void begin_all();
  void begin_by_rate();
  void begin_one(Moment due);
  void over(Visitors::iterator visitor);
  void look();
  void note_memory();
  bool may_begin(Moment now) const;
  std::string line() const;

  VisitorParts& parts_;
  const std::vector<Played>& conversations_;
  const LoadWishes wishes_;
  const std::function<void(const std::string&)> progress_;
  Visitors visitors_;
  std::vector<std::unique_ptr<Visitor>> gone_; // destroyed when they return
  std::size_t begun_ = 0;
  Moment begin_{};
  Moment end_{};
  std::uint64_t memory_most_ = 0;
  std::size_t most_visitors_ = 0;
};

} // namespace parlour::tools
