#include "adapters/agents/client/reconnection.hpp"

#include <chrono>
#include <utility>

#include <fmt/format.h>

namespace parlour::adapters::agents {

namespace {

constexpr Milliseconds first_pause{200};
constexpr Milliseconds longest_pause{5'000};

} // namespace

Reconnection::Reconnection(Loop& loop, std::unique_ptr<PlatformDialler> dialler,
                           std::string address, Retry retry, Note note)
    : dialler_(std::move(dialler)), address_(std::move(address)),
      note_(std::move(note)), alarm_(std::in_place, loop, std::move(retry)),
      backoff_(first_pause, longest_pause) {}

void Reconnection::dial(PeerConnection::Owner& owner,
                        PlatformDialler::Done done) {
  if (!alarm_ || std::exchange(is_dialling_, true))
    return;
  alarm_->set(Alarm::never);
  dialler_->dial(++last_id_, owner,
                 [this, done = std::move(done)](auto connection) {
                   is_dialling_ = false;
                   done(std::move(connection));
                 });
}

// One line for each loss, not for each attempt.
void Reconnection::try_later(const std::string& reason) {
  if (!alarm_)
    return;
  if (!std::exchange(loss_is_noted_, true))
    note_(fmt::format("not connected to {}: {}", address_, reason));
  alarm_->set(std::chrono::steady_clock::now() + backoff_.after_failure());
}

void Reconnection::succeeded() {
  backoff_.reset();
  loss_is_noted_ = false;
}

void Reconnection::stop() {
  dialler_->cancel();
  alarm_.reset();
}

} // namespace parlour::adapters::agents
