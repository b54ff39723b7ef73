#include "adapters/process/remote_host.hpp"

#include <stdexcept>
#include <utility>

#include "adapters/process/frame_values.hpp"

namespace parlour::adapters {

// Words come from the platform's own process: an expression in a phrase may be
// any of the script language.
class RemoteHost::Phrases : public PhraseEvaluator {
public:
  explicit Phrases(const RemoteHost& host) : host_(host) {}

  Rendering render(const Value& say) const override {
    const auto rendering = host_.inquire(FrameKind::phrase, say);
    return rendering ? rendering_from(*rendering) : Rendering{};
  }

private:
  const RemoteHost& host_;
};

Timestamp RemoteHost::ToldClock::now() const {
  return host_.real_time_ ? SystemClock().now() : host_.told_.load();
}

Expected<Options> RemoteHost::begin(const Frame& start) {
  real_time_ = static_cast<bool>(start.at(1));
  data_folder_ = start.at(3).text();
  application_folder_ = start.at(4).text();
  auto understanding = understanding_from(start.at(5));
  if (!understanding)
    return tl::make_unexpected(understanding.error());
  understanding_ = std::move(*understanding);
  if (start.at(6))
    phrases_ = std::make_shared<Phrases>(*this);
  return options_from(start.at(2));
}

void RemoteHost::say(const Frame& frame) {
  const auto sent = socket_.send(frame);
  if (!sent && sent.error().kind == ErrorKind::limit)
    throw std::length_error(sent.error().message);
}

// -- delays -------------------------------------------------------------------

PluginHost::DelayId RemoteHost::after(Milliseconds delay,
                                      std::function<void()> action) {
  DelayId id = 0;
  {
    std::lock_guard lock(mutex_);
    id = static_cast<DelayId>(++last_);
    delays_[id] = std::move(action);
  }
  say({FrameKind::after,
       {static_cast<std::int64_t>(id),
        static_cast<std::int64_t>(delay.count())}});
  return id;
}

void RemoteHost::cancel(DelayId delay) {
  {
    std::lock_guard lock(mutex_);
    if (delays_.erase(delay) == 0)
      return;
  }
  say({FrameKind::cancel, {static_cast<std::int64_t>(delay)}});
}

void RemoteHost::run(std::int64_t delay) {
  std::unique_lock lock(mutex_);
  const auto found = delays_.extract(static_cast<DelayId>(delay));
  lock.unlock();
  if (found)
    found.mapped()();
}

// -- questions ----------------------------------------------------------------

Expected<Value> RemoteHost::inquire(FrameKind kind, Value what) const {
  std::unique_lock lock(mutex_);
  const auto id = ++last_;
  auto answer = questions_[id].get_future();
  lock.unlock();
  auto asked = socket_.send({kind, {id, std::move(what)}});
  if (asked)
    return answer.get();
  lock.lock();
  questions_.erase(id);
  return tl::make_unexpected(asked.error());
}

void RemoteHost::answered(const Frame& reply) {
  std::unique_lock lock(mutex_);
  auto question = questions_.extract(reply.at(0).integer_or(0));
  lock.unlock();
  if (!question)
    return;
  if (reply.at(1).is_unknown())
    question.mapped().set_value(reply.at(2));
  else
    question.mapped().set_value(tl::make_unexpected(error_from(reply.at(1))));
}

Expected<std::vector<std::string>>
RemoteHost::column(const std::string& name) const {
  return inquire(FrameKind::column, name).and_then(texts_from);
}

// -- other components ---------------------------------------------------------

void RemoteHost::ask(Message request, Milliseconds patience,
                     Reaction reaction) {
  std::unique_lock lock(mutex_);
  const auto id = ++last_;
  reactions_[id] = std::move(reaction);
  lock.unlock();
  say({FrameKind::ask,
       {id, to_value(request), static_cast<std::int64_t>(patience.count())}});
}

void RemoteHost::react(const Frame& answer) {
  std::unique_lock lock(mutex_);
  const auto found = reactions_.extract(answer.at(1).integer_or(0));
  lock.unlock();
  if (!found)
    return;
  if (answer.at(2).is_unknown())
    found.mapped()(message_from(answer.at(3)));
  else
    found.mapped()(tl::make_unexpected(error_from(answer.at(2))));
}

// -- what it says -------------------------------------------------------------

void RemoteHost::fire_event(Message event) {
  say({FrameKind::fire, {to_value(event)}});
}

void RemoteHost::send_message(Message message) {
  say({FrameKind::send, {to_value(message)}});
}

void RemoteHost::failed(const std::string& reason) {
  say({FrameKind::failed, {reason}});
}

void RemoteHost::log(const std::string& text) {
  say({FrameKind::log, {text}});
}

} // namespace parlour::adapters
