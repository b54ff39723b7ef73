#include "adapters/agents/client/reconnection.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace parlour::adapters::agents {

namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds first_pause = 200ms;
constexpr std::chrono::milliseconds longest_pause = 5s;

} // namespace

Reconnection::Reconnection(Loop& loop, std::unique_ptr<PlatformDialler> dialler,
                           std::string address, Retry retry, Note note)
    : dialler_(std::move(dialler)), address_(std::move(address)),
      note_(std::move(note)), alarm_(std::in_place, loop, std::move(retry)),
      pause_(first_pause) {}

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
  alarm_->set(std::chrono::steady_clock::now() + pause_);
  pause_ = std::min(2 * pause_, longest_pause);
}

void Reconnection::succeeded() {
  pause_ = first_pause;
  loss_is_noted_ = false;
}

void Reconnection::stop() {
  dialler_->cancel();
  alarm_.reset();
}

} // namespace parlour::adapters::agents
