#include "adapters/agents/client/agent_host.hpp"

#include <atomic>
#include <random>
#include <utility>

#include <asio.hpp>

#include "adapters/agents/wire/parameters.hpp"

namespace parlour::adapters::agents {

namespace {

// Of 47 bits, so that every language has it exactly.
std::uint64_t any_number() {
  std::random_device device;
  return (std::uint64_t{device()} << 32 | device()) >> 17;
}

} // namespace

// The delays of the plug-in. Its thread alone touches the map.
struct AgentHost::Timers {
  std::atomic<DelayId> last = 0;
  std::map<DelayId, std::unique_ptr<asio::steady_timer>> running;
};

AgentHost::AgentHost(std::string name, std::string data_folder,
                     asio::io_context& context, Outside outside)
    : name_(std::move(name)), data_folder_(std::move(data_folder)),
      context_(context), outside_(std::move(outside)),
      timers_(std::make_unique<Timers>()), last_request_(any_number()) {}

AgentHost::~AgentHost() = default;

// -- what the plug-in says ----------------------------------------------------

void AgentHost::say(Message message) {
  message.source = name_;
  auto made = message_for_agent(message, true);
  if (!made)
    outside_.log(message.command + " is not sent: " + made.error().sentence);
  else if (!outside_.send(std::move(*made)))
    outside_.log(message.command + " is not sent: too much waits already");
}

void AgentHost::fire_event(Message event) {
  event.sinks.clear();
  say(std::move(event));
}

void AgentHost::send_message(Message message) {
  message.correlation = 0;
  say(std::move(message));
}

void AgentHost::ask(Message request, Milliseconds patience, Reaction reaction) {
  request.source = name_;
  auto made = message_for_agent(request, true, patience);
  std::unique_lock lock(mutex_);
  const auto number = ++last_request_;
  reactions_.emplace(number, std::move(reaction));
  lock.unlock();
  after(patience, [this, number] {
    end_request(number, fail(ErrorKind::timeout,
                             "the platform did not answer in time"));
  });
  if (made)
    made->correlation = number;
  if (!made || !outside_.send(std::move(*made)))
    after(Milliseconds::zero(), [this, number] {
      end_request(number, fail(ErrorKind::limit, "it could not be sent"));
    });
}

// Once: by the answer, or by the time that it may take.
void AgentHost::end_request(std::uint64_t number, Expected<Message> outcome) {
  std::unique_lock lock(mutex_);
  const auto found = reactions_.extract(number);
  lock.unlock();
  if (found)
    found.mapped()(std::move(outcome));
}

void AgentHost::end_requests() {
  std::unique_lock lock(mutex_);
  const auto reactions = std::exchange(reactions_, {});
  lock.unlock();
  for (const auto& [number, reaction] : reactions)
    reaction(fail(ErrorKind::offline, "the platform is not there"));
}

bool AgentHost::take_answer(const AgentMessage& message) {
  if (!message.sinks.empty() || !message.correlation)
    return false;
  const auto number = *message.correlation;
  if (message.kind == MessageKind::error) {
    end_request(number,
                fail(ErrorKind::refused, message.parameters.empty()
                                             ? message.command
                                             : message.parameters.front()));
    return true;
  }
  auto made = message_from_agent(message, true);
  if (!made)
    end_request(number, fail(ErrorKind::network, made.error().sentence));
  else if (made->source == "Parlour" && made->command == "Failed")
    end_request(number,
                fail(ErrorKind::refused,
                     made->params.empty() ? "" : made->params[0].text()));
  else
    end_request(number, std::move(*made));
  return true;
}

// -- its delays ---------------------------------------------------------------

PluginHost::DelayId AgentHost::after(Milliseconds delay,
                                     std::function<void()> action) {
  const auto id = ++timers_->last;
  asio::post(context_, [this, id, delay, action = std::move(action)] {
    auto& timer = timers_->running[id];
    timer = std::make_unique<asio::steady_timer>(context_, delay);
    timer->async_wait([this, id, action](asio::error_code error) {
      const bool is_due = timers_->running.erase(id) != 0;
      if (is_due && !error)
        action();
    });
  });
  return id;
}

// In the order of the calls: what was begun before is there by then.
void AgentHost::cancel(DelayId delay) {
  asio::post(context_, [this, delay] { timers_->running.erase(delay); });
}

// -- the rest -----------------------------------------------------------------

void AgentHost::failed(const std::string& reason) {
  outside_.failed(reason);
}

void AgentHost::available(bool is_available) {
  outside_.available(is_available);
}

const Clock& AgentHost::clock() const {
  return clock_;
}

void AgentHost::log(const std::string& text) {
  outside_.log(text);
}

std::shared_ptr<const UnderstandingModel> AgentHost::understanding() const {
  return nullptr;
}

std::shared_ptr<const PhraseEvaluator> AgentHost::phrases() const {
  return nullptr;
}

Expected<std::vector<std::string>>
AgentHost::column(const std::string& name) const {
  return fail(ErrorKind::database,
              "a remote agent cannot read the column " + name);
}

std::string AgentHost::data_folder() const {
  return data_folder_;
}

std::string AgentHost::application_folder() const {
  return data_folder_;
}

} // namespace parlour::adapters::agents
