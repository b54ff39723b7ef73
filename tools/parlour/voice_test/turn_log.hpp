// TurnLog: what a node's inspections tell of turns: where the user's turns
// begin and end, what was heard and understood, what the robot says and how
// much of it is played, and how long it takes.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/message/inspection.hpp"

namespace parlour::tools {

// How long a turn took, from the last sound of the user to the first of the
// robot.
struct Latency {
  // Until the turn was held to be over, and on from there, by the clock of the
  // conversation: what is waited for.
  Milliseconds pause{0};
  Milliseconds waiting{0};
  // Real time between the decision and the first sound: what is computed, while
  // a virtual clock stands still.
  Milliseconds computing{0};

  Milliseconds all() const {
    return pause + waiting + computing;
  }
};

// For one thread at a time.
class TurnLog {
public:
  using RealTime = std::chrono::steady_clock::time_point;

  // Forgets what was heard, understood and said before.
  void begin_row();
  // The user's line ended now.
  void line_ended(Timestamp now);
  // Takes an inspection of any kind.
  void note(const Inspection& seen,
            RealTime real = std::chrono::steady_clock::now());
  // An output of the robot was released.
  void released(std::uint64_t id, std::string text);

  // A turn of the user is open, or is not recognised yet.
  bool in_turn() const {
    return begun_ > ended_ || ended_ > recognised_;
  }
  // Turns that were recognised or rejected since begin_row().
  std::size_t recognised() const {
    return recognised_;
  }
  // The robot has more to say, or says it.
  bool robot_speaks() const {
    return !speaking_.empty();
  }
  bool robot_sounds() const {
    return !sounding_.empty();
  }
  // How many words of the output that sounds now have been said.
  std::size_t words_said(Timestamp now) const;

  // The results of the recogniser; "" where it rejected a turn.
  const std::vector<std::string>& heard() const {
    return heard_;
  }
  const std::vector<std::string>& understood() const {
    return understood_;
  }
  // Without what was interrupted.
  std::vector<std::string> answers() const;
  const std::vector<Latency>& latencies() const {
    return latencies_;
  }

private:
  struct Answer {
    std::uint64_t id;
    std::string text;
  };

  void note_message(const Message& message, RealTime real);
  void note_speaker(const Message& message, RealTime real);
  void first_sound(Timestamp now, RealTime real);

  std::size_t begun_ = 0;
  std::size_t ended_ = 0;
  std::size_t recognised_ = 0;
  std::set<std::uint64_t> speaking_; // released, not finished
  std::set<std::uint64_t> sounding_; // started, not finished
  std::set<std::uint64_t> interrupted_;
  // Where the words of each utterance begin, in ms, and since when the one
  // plays that began last.
  std::map<std::uint64_t, std::vector<std::int64_t>> marks_;
  std::uint64_t playing_ = 0;
  Timestamp started_ = 0;
  std::vector<Answer> answers_;
  std::vector<std::string> heard_;
  std::vector<std::string> understood_;
  std::vector<Latency> latencies_;
  std::optional<Timestamp> line_end_;
  // When the last turn was held to be over; nothing once the robot answers, or
  // where the turn was rejected.
  std::optional<Timestamp> decided_;
  RealTime decided_real_;
};

} // namespace parlour::tools
