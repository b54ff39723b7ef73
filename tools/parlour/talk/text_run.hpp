// A conversation by lines: pipes, and `--text` (docs/running.md, "By lines").
#pragma once

#include <atomic>
#include <functional>

#include "actors/node/node.hpp"
#include "tools/parlour/console/row_reader.hpp"

namespace parlour::tools {

// How far an empty line lets time pass at most, to what is due next.
inline constexpr Milliseconds longest_step = std::chrono::hours(24 * 366);
// Through what components do by themselves, such as a sensor without end.
inline constexpr Milliseconds longest_pause = std::chrono::minutes(1);

// Who is talked with: a node's seat, or a test's notes.
class Partner {
public:
  virtual ~Partner() = default;
  virtual void enter(const std::vector<std::string>& turns) = 0;
  virtual void run_until_quiet() = 0;
  // Until something is said or a timer of the conversation is due.
  virtual void let_time_pass() = 0;
  // Whether nothing happens but inside these calls.
  virtual bool is_virtual() const = 0;
};

// At a seat of its own, where a conversation begins at once.
class NodePartner : public Partner {
public:
  // `say` is called as SeatCallbacks are, until the node has stopped.
  NodePartner(actors::Node& node, bool is_virtual,
              std::function<void(const std::string&)> say);

  void enter(const std::vector<std::string>& turns) override {
    node_.enter(seat_, turns);
  }
  void run_until_quiet() override {
    node_.run_until_quiet();
  }
  void let_time_pass() override;
  bool is_virtual() const override {
    return virtual_;
  }

private:
  actors::Node& node_;
  bool virtual_;
  std::atomic<std::uint64_t> said_ = 0;
  actors::SeatId seat_;
};

// Talks until the input ends; all is quiet then. False where a signal ended
// it.
bool talk_by_rows(Partner& partner, RowReader& rows);

} // namespace parlour::tools
