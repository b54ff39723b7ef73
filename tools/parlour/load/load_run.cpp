#include "tools/parlour/load/load_run.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace parlour::tools {

namespace {

using Clock = std::chrono::steady_clock;

constexpr Milliseconds between_looks{500};
// That connect at once; the others follow in steps.
constexpr std::size_t at_once = 100;
constexpr Milliseconds between_steps{20};

} // namespace

LoadRun::LoadRun(VisitorParts& parts, const std::vector<Played>& conversations,
                 LoadWishes wishes,
                 std::function<void(const std::string&)> progress)
    : parts_(parts), conversations_(conversations), wishes_(wishes),
      progress_(std::move(progress)) {}

void LoadRun::run() {
  begin_ = Clock::now();
  if (wishes_.rate)
    begin_by_rate();
  else
    begin_all();
  parts_.clients.at(begin_ + between_looks, [this] { look(); });
  parts_.clients.run();
  end_ = Clock::now();
  note_memory();
}

void LoadRun::interrupt() {
  parts_.clients.stop();
}

bool LoadRun::may_begin(Moment now) const {
  return wishes_.duration ? now - begin_ < *wishes_.duration
                          : begun_ < wishes_.visitors;
}

// A closed loop: as many visitors as are wished, from the beginning on.
void LoadRun::begin_all() {
  const auto now = Clock::now();
  for (std::size_t i = 0; i < at_once && visitors_.size() < wishes_.visitors;
       ++i) {
    if (wishes_.duration ? begun_ >= wishes_.visitors : !may_begin(now))
      return;
    begin_one(now);
  }
  if (visitors_.size() < wishes_.visitors && begun_ < wishes_.visitors)
    parts_.clients.at(now + between_steps, [this] { begin_all(); });
}

// An open loop: who is late does not keep the next one waiting, and counts from
// when it was due.
void LoadRun::begin_by_rate() {
  const auto now = Clock::now();
  auto due = [this] {
    return begin_ + std::chrono::duration_cast<Clock::duration>(
                        std::chrono::duration<double>(
                            static_cast<double>(begun_) / *wishes_.rate));
  };
  while (may_begin(now) && due() <= now) {
    if (visitors_.size() >= wishes_.visitors) {
      parts_.figures.failed("more visitors would be there than --visitors: the "
                            "server is slower than --rate");
      ++begun_;
      continue;
    }
    begin_one(due());
  }
  if (may_begin(now))
    parts_.clients.at(due(), [this] { begin_by_rate(); });
}

void LoadRun::begin_one(Moment due) {
  const auto& conversation = conversations_[begun_++ % conversations_.size()];
  const auto place = visitors_.emplace(visitors_.end());
  *place = std::make_unique<Visitor>(parts_, conversation, due,
                                     [this, place] { over(place); });
  most_visitors_ = std::max(most_visitors_, visitors_.size());
}

// It is still at work: it is destroyed at the next look.
void LoadRun::over(Visitors::iterator visitor) {
  gone_.push_back(std::move(*visitor));
  visitors_.erase(visitor);
  const auto now = Clock::now();
  parts_.clients.at(now, [this, now] {
    gone_.clear();
    if (!wishes_.rate && wishes_.duration && may_begin(now))
      begin_one(now);
    else if (visitors_.empty() && !may_begin(now))
      parts_.clients.stop();
  });
}

void LoadRun::note_memory() {
  if (parts_.server == 0)
    return;
  memory_most_ = std::max(memory_most_, memory_of(parts_.server));
}

void LoadRun::look() {
  const auto now = Clock::now();
  note_memory();
  bool all_idle = true;
  for (auto at = visitors_.begin(); at != visitors_.end();) {
    auto& visitor = **at++; // it may go
    all_idle &= visitor.is_idle();
    visitor.look(now);
  }
  if (progress_)
    progress_(line());
  const bool idle_over =
      wishes_.idle && all_idle && begun_ >= wishes_.visitors &&
      (!wishes_.duration || now - begin_ > *wishes_.duration);
  if (idle_over || (visitors_.empty() && !may_begin(now)))
    return parts_.clients.stop();
  parts_.clients.at(now + between_looks, [this] { look(); });
}

std::string LoadRun::line() const {
  const auto& figures = parts_.figures;
  const auto time =
      std::chrono::duration<double>(Clock::now() - begin_).count();
  return fmt::format(
      "{:.0f} s: {} visitors, {} conversations, {} turns ({:.0f} "
      "turns/s), {} wrong, {} errors",
      time, visitors_.size(), figures.conversations(), figures.turns(),
      static_cast<double>(figures.turns()) / time, figures.wrong_answers(),
      figures.errors());
}

} // namespace parlour::tools
