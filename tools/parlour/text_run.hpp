// A conversation by lines: pipes, and `--text` (docs/running.md, "By lines").
#pragma once

#include "actors/node.hpp"
#include "tools/parlour/row_reader.hpp"

namespace parlour::tools {

// How far an empty line lets time pass at most.
inline constexpr Milliseconds longest_step = std::chrono::hours(24 * 366);

// Who is talked with: a node's seat, or a test's notes.
class Partner {
public:
  virtual ~Partner() = default;
  virtual void enter(const std::vector<std::string>& turns) = 0;
  virtual void run_until_quiet() = 0;
  virtual void step_to_next_due() = 0;
  // Whether nothing happens but inside these calls.
  virtual bool is_virtual() const = 0;
};

class NodePartner : public Partner {
public:
  NodePartner(actors::Node& node, actors::SeatId seat, bool is_virtual)
      : node_(node), seat_(std::move(seat)), virtual_(is_virtual) {}

  void enter(const std::vector<std::string>& turns) override {
    node_.enter(seat_, turns);
  }
  void run_until_quiet() override {
    node_.run_until_quiet();
  }
  void step_to_next_due() override {
    node_.step_to_next_due(longest_step);
  }
  bool is_virtual() const override {
    return virtual_;
  }

private:
  actors::Node& node_;
  actors::SeatId seat_;
  bool virtual_;
};

// Talks until the input ends; all is quiet then. False where a signal ended
// it.
bool talk_by_rows(Partner& partner, RowReader& rows);

} // namespace parlour::tools
