#include "adapters/process/remote_host.hpp"

#include <stdexcept>
#include <utility>

#include "adapters/process/ipc_values.hpp"

namespace parlour::adapters {

// Phrases may contain any expression of the script language, so the platform's
// process evaluates them.
class RemoteHost::Phrases : public PhraseEvaluator {
public:
  explicit Phrases(const RemoteHost& host) : host_(host) {}

  Rendering render(const Value& say) const override {
    const auto rendering = host_.inquire(IpcKind::phrase, say);
    return rendering ? rendering_from(*rendering) : Rendering{};
  }

private:
  const RemoteHost& host_;
};

Timestamp RemoteHost::ToldClock::now() const {
  return host_.real_time_ ? SystemClock().now() : host_.told_.load();
}

Expected<Options> RemoteHost::begin(const IpcMessage& start) {
  real_time_ = static_cast<bool>(start.at(1));
  data_folder_ = start.at(3).text();
  application_folder_ = start.at(4).text();
  return options_from(start.at(2));
}

void RemoteHost::say(const IpcMessage& message) {
  const auto sent = socket_.send(message);
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
  // The platform measures the time, so that virtual time holds here, too.
  say({IpcKind::after,
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
  say({IpcKind::cancel, {static_cast<std::int64_t>(delay)}});
}

// The action runs without the lock: it may start or cancel timers.
void RemoteHost::run(std::int64_t delay) {
  std::unique_lock lock(mutex_);
  const auto found = delays_.extract(static_cast<DelayId>(delay));
  lock.unlock();
  if (found)
    found.mapped()();
}

// -- questions ----------------------------------------------------------------

// The question is registered before it is sent, since the answer may arrive at
// once on the other thread.
Expected<Value> RemoteHost::inquire(IpcKind kind, Value what) const {
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

void RemoteHost::answered(const IpcMessage& reply) {
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
  return inquire(IpcKind::column, name).and_then(texts_from);
}

const RemoteHost::Language& RemoteHost::language() const {
  std::call_once(has_asked_, [this] { language_ = ask_language(); });
  return language_;
}

RemoteHost::Language RemoteHost::ask_language() const {
  const auto answer = inquire(IpcKind::language, {});
  if (!answer && answer.error().kind == ErrorKind::offline)
    return {};
  auto understanding = answer.and_then(
      [](const Value& told) { return understanding_from(told.at(0)); });
  if (!understanding)
    throw std::runtime_error(understanding.error().message);
  Language language{std::move(*understanding), nullptr};
  if (answer->at(1))
    language.phrases = std::make_shared<Phrases>(*this);
  return language;
}

// -- other components ---------------------------------------------------------

void RemoteHost::ask(Message request, Milliseconds patience,
                     Reaction reaction) {
  std::unique_lock lock(mutex_);
  const auto id = ++last_;
  reactions_[id] = std::move(reaction);
  lock.unlock();
  say({IpcKind::ask,
       {id, to_value(request), static_cast<std::int64_t>(patience.count())}});
}

// The reaction runs without the lock: it may ask again.
void RemoteHost::react(const IpcMessage& answer) {
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
  say({IpcKind::fire, {to_value(event)}});
}

void RemoteHost::send_message(Message message) {
  say({IpcKind::send, {to_value(message)}});
}

void RemoteHost::failed(const std::string& reason) {
  say({IpcKind::failed, {reason}});
}

void RemoteHost::available(bool is_available) {
  say({IpcKind::available, {is_available}});
}

void RemoteHost::log(const std::string& text) {
  say({IpcKind::log, {text}});
}

} // namespace parlour::adapters
