#include "actors/node/node_questions.hpp"

#include "actors/components/departures.hpp"

namespace parlour::actors {

namespace {

// How long to wait before looking whether somebody has interrupted meanwhile.
constexpr Milliseconds glance{20};

} // namespace

Expected<void>
NodeQuestions::wait(const std::function<bool(Milliseconds)>& answered) const {
  const bool is_virtual = !scheduler_->detaches();
  if (is_virtual)
    scheduler_->run_until_answered([&] { return answered(Milliseconds(0)); },
                                   Departures::drain_time);
  while (!time_->work.interrupted()) {
    if (answered(is_virtual ? Milliseconds(0) : glance))
      return {};
    if (is_virtual)
      return fail(ErrorKind::timeout, "there is no answer");
  }
  return fail(ErrorKind::cancelled, "interrupted");
}

} // namespace parlour::actors
