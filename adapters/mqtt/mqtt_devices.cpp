#include "adapters/mqtt/mqtt_devices.hpp"

#include <utility>
#include <variant>

#include "adapters/mqtt/device_policy.hpp"
#include "adapters/mqtt/mqtt_link.hpp"

namespace parlour::adapters::mqtt {

namespace {

using Steady = std::chrono::steady_clock;

// How many messages may be without an answer; the policy has a limit for those
// that it has taken in.
constexpr std::size_t max_open = 2 * DeviceRequests::max_pending;

} // namespace

// The policy and the link, on a loop: whatever happens is told to the policy,
// whose deeds are carried out at once.
// Made by the plug-in's thread; everything but order() runs on the loop's.
class MQTTDevices::House {
public:
  House(MQTTDevices& plugin, std::unique_ptr<Loop> loop, DeviceList list)
      : plugin_(plugin), loop_(std::move(loop)),
        policy_(plugin.options_.policy, std::move(list)),
        link_(*loop_, plugin.options_.server, calls()),
        alarm_(*loop_, [this] { turn(); }) {
    loop_->post([this] { link_.start(); });
  }
  House(const House&) = delete;
  House& operator=(const House&) = delete;
  // Answers what is left.
  ~House() {
    loop_->post([this] {
      policy_.end();
      carry_out();
      link_.stop();
    });
    loop_->stop();
  }

  // Thread-safe.
  void order(Message message) {
    loop_->post([this, message = std::move(message)] {
      policy_.order(message, Steady::now());
      turn();
    });
  }

private:
  LinkCalls calls() {
    return {[this] { up(); },
            [this](const std::string& reason) { down(reason); },
            [this](Publication one) {
              policy_.received(one.topic, std::move(one.payload), one.retained,
                               Steady::now());
              turn();
            },
            [this](Ticket ticket) {
              policy_.published(ticket, Steady::now());
              turn();
            }};
  }

  void up() {
    reason_.clear();
    plugin_.host().log("connected to the MQTT server " +
                       plugin_.options_.server.host);
    plugin_.host().available(true);
    policy_.connected(Steady::now());
    turn();
  }

  // The same reason again, attempt by attempt, is no news.
  void down(const std::string& reason) {
    if (std::exchange(reason_, reason) != reason)
      plugin_.host().log("the MQTT server " + plugin_.options_.server.host +
                         " cannot be reached: " + reason);
    policy_.disconnected(reason);
    turn();
    plugin_.host().available(false);
  }

  // After each event: what may be decided now, what follows from it, and when
  // to look again.
  void turn() {
    policy_.decide(Steady::now());
    carry_out();
    alarm_.set(policy_.next_moment());
  }

  // A deed may lead to others: what cannot be published fails.
  void carry_out() {
    for (auto deeds = policy_.deeds(); !deeds.empty(); deeds = policy_.deeds())
      for (auto& deed : deeds)
        std::visit([this](auto& one) { carry_out(one); }, deed);
  }
  void carry_out(Subscribe& deed) {
    link_.subscribe(deed.filter);
  }
  void carry_out(Unsubscribe& deed) {
    link_.unsubscribe(deed.filter);
  }
  void carry_out(Publish& deed) {
    if (!link_.publish(deed))
      policy_.not_published(deed.ticket);
  }
  void carry_out(Answer& deed) {
    plugin_.tell(deed.to, deed.command, std::move(deed.params));
  }
  // An event without session and correlation: nobody has asked for it.
  void carry_out(News& deed) {
    Message event;
    event.command = "State";
    event.params = std::move(deed.params);
    plugin_.host().fire_event(std::move(event));
  }
  void carry_out(Log& deed) {
    plugin_.host().log(deed.text);
  }

  MQTTDevices& plugin_;
  // Outlives what waits on it.
  const std::unique_ptr<Loop> loop_;
  DevicePolicy policy_;
  MQTTLink link_;
  Alarm alarm_;
  // Why there is no connection, as was logged last.
  std::string reason_;
};

MQTTDevices::MQTTDevices() = default;

MQTTDevices::~MQTTDevices() = default;

Expected<void> MQTTDevices::on_start(const Options& options) {
  auto read = read_mqtt_options(options, host().application_folder());
  if (!read)
    return tl::make_unexpected(read.error());
  if (auto built = MQTTClient::is_built_in(); !built)
    return built;
  options_ = std::move(*read);
  DeviceList list;
  if (!options_.devices.empty()) {
    auto found = DeviceList::read(options_.devices);
    if (!found)
      return tl::make_unexpected(found.error());
    list = std::move(*found);
  }
  auto loop =
      Loop::start([this](const std::string& what) { host().failed(what); });
  if (!loop)
    return tl::make_unexpected(loop.error());
  house_ = std::make_unique<House>(*this, std::move(*loop), std::move(list));
  return {};
}

void MQTTDevices::stop() {
  house_.reset();
}

// A message beyond the bound is refused at once, as the loop may be behind.
void MQTTDevices::on_message(const Message& message) {
  if (!house_)
    return fire_event("Failed", {"The component is stopped."});
  if (!open_.open(max_open))
    return fire_event("Failed", {"Too many wait for the devices."});
  house_->order(without_its_way(message));
  if (options_.one_by_one)
    open_.wait_for_all();
}

void MQTTDevices::tell(const Message& to, const std::string& command,
                       std::vector<Value> params) {
  const OpenMessages::Closing closing(open_);
  answer(to, command, std::move(params));
}

} // namespace parlour::adapters::mqtt

namespace parlour::adapters {

PluginFactory mqtt_devices_factory() {
  PluginDescription description;
  description.name = "MQTTDevices";
  description.roles = {"Devices"};
  description.sentence = "the devices of a house, by an MQTT server: Home "
                         "Assistant, Zigbee2MQTT, ESPHome";
  description.options = mqtt::mqtt_option_descriptions();
  return {description, [] { return std::make_unique<mqtt::MQTTDevices>(); }};
}

} // namespace parlour::adapters
