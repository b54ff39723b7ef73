// A conversation by lines, for pipes and `--text` (docs/running.md, "By
// lines"). Also the driver that connects it to a node.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <utility>

#include "actors/node/node.hpp"
#include "tools/parlour/console/printer.hpp"
#include "tools/parlour/console/row_reader.hpp"

namespace parlour::tools {

// How far ahead the next due time may be for an empty line to wait for it: a
// year.
inline constexpr Milliseconds longest_step = std::chrono::hours(24 * 366);
// How long a step goes on while only components act, for example a sensor that
// reports for ever.
inline constexpr Milliseconds longest_pause = std::chrono::minutes(1);

// The conversation that input is for: a node's seat (NodeDriver), or a recorder
// in tests. For one thread.
class ConversationDriver {
public:
  virtual ~ConversationDriver() = default;
  // User turns that arrive together, in order.
  virtual void enter(const std::vector<std::string>& turns) = 0;
  // Returns when nothing is left to do without time passing.
  virtual void run_until_quiet() = 0;
  // Lets time pass until something is said or a timer of the conversation is
  // due.
  virtual void let_time_pass() = 0;
  // Whether time stands still outside of these calls.
  virtual bool is_virtual() const = 0;
};

// Drives a node through a seat that it opens. The first conversation begins in
// the constructor.
class NodeDriver : public ConversationDriver {
public:
  // `say` gets each output as one line. It is called like
  // SeatCallbacks::on_output (from threads of the node in real time), until the
  // node has stopped. The node must outlive the driver. With `left` that
  // conversation goes on.
  NodeDriver(actors::Node& node, bool is_virtual,
             std::function<void(const std::string&)> say,
             std::optional<dialogue::SavedSession> left = {});

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
  std::atomic<std::uint64_t> said_ = 0; // outputs so far
  actors::SeatId seat_;
};

// A driver that waits while too many lines are unread. Otherwise a script that
// talks without end would fill the memory when the reader is slow.
class PacedDriver : public NodeDriver {
public:
  PacedDriver(actors::Node& node, bool is_virtual, Printer& printer,
              std::optional<dialogue::SavedSession> left = {})
      : NodeDriver(
            node, is_virtual,
            [&printer](const std::string& text) { printer.out(text); },
            std::move(left)),
        printer_(printer) {}

  void enter(const std::vector<std::string>& turns) override {
    printer_.wait_for_room();
    NodeDriver::enter(turns);
  }
  void let_time_pass() override {
    printer_.wait_for_room();
    NodeDriver::let_time_pass();
  }

private:
  Printer& printer_;
};

// Passes the events of `rows` to the driver. True when the input has ended and
// everything is quiet; false if a signal ended it.
bool talk_by_rows(ConversationDriver& driver, RowReader& rows);

} // namespace parlour::tools
