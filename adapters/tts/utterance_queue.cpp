#include "adapters/tts/utterance_queue.hpp"

#include <algorithm>
#include <utility>

namespace parlour::adapters::tts {

UtteranceQueue::UtteranceQueue(PluginHost& host, SpeechEngine& engine,
                               Pace pace, const SpeechCalls& calls)
    : host_(host), engine_(engine), pace_(pace), calls_(calls) {}

UtteranceQueue::~UtteranceQueue() {
  silence();
}

void UtteranceQueue::add(Utterance utterance) {
  waiting_.push_back(std::move(utterance));
  if (waiting_.size() == 1)
    begin();
}

// The engine may wake the queue after it has gone, or after the job has.
void UtteranceQueue::begin() {
  if (waiting_.empty())
    return;
  const auto& first = waiting_.front();
  auto wake = [&host = host_, queue = weak_from_this()] {
    host.after(Milliseconds(0), [queue] {
      if (const auto alive = queue.lock())
        alive->deliver();
    });
  };
  job_ =
      std::make_shared<SpeechJob>(first.text, engine_.piece_length(),
                                  first.settings, pace_.ahead, std::move(wake));
  deliver();
}

std::int64_t UtteranceQueue::due() const {
  const auto heard = begun_ ? host_.clock().now() - *begun_ : 0;
  return heard + pace_.ahead.count();
}

void UtteranceQueue::deliver() {
  if (!job_)
    return;
  host_.cancel(std::exchange(delay_, 0));
  const auto until = due();
  engine_.go_on(job_);
  if (pace_.waits)
    job_->await(until);
  const auto portion = job_->take(until);
  engine_.go_on(job_);
  tell(portion);
  if (portion.is_over)
    return end(portion.trouble);
  if (!portion.will_wake)
    delay_ = host_.after(pace_.ahead / 4, [this] { deliver(); });
}

void UtteranceQueue::tell(const Portion& portion) {
  const auto& first = waiting_.front();
  if (!portion.spoken.empty() && !begun_)
    begun_ = host_.clock().now();
  for (const auto& spoken : portion.spoken)
    if (const auto* word = std::get_if<SpokenWord>(&spoken))
      calls_.mark(first, *word);
    else
      calls_.audio(first, std::get<Value>(spoken));
}

void UtteranceQueue::end(const std::string& trouble) {
  silence();
  const auto first = std::move(waiting_.front());
  waiting_.pop_front();
  if (trouble.empty())
    calls_.finished(first);
  else
    calls_.failed(first, trouble);
  begin();
}

void UtteranceQueue::silence() {
  host_.cancel(std::exchange(delay_, 0));
  if (job_)
    job_->cancel();
  job_.reset();
  begun_.reset();
}

void UtteranceQueue::stop(std::optional<std::int64_t> id) {
  if (waiting_.empty())
    return;
  auto is_meant = [&](const Utterance& one) {
    return id.value_or(one.id) == one.id;
  };
  const bool first = is_meant(waiting_.front());
  if (first)
    silence();
  const auto meant = std::stable_partition(
      waiting_.begin(), waiting_.end(),
      [&](const Utterance& one) { return !is_meant(one); });
  const std::vector<Utterance> stopped(std::make_move_iterator(meant),
                                       std::make_move_iterator(waiting_.end()));
  waiting_.erase(meant, waiting_.end());
  for (const auto& one : stopped)
    calls_.finished(one);
  if (first)
    begin();
}

} // namespace parlour::adapters::tts
