#include "adapters/mqtt/device_policy.hpp"

#include <algorithm>
#include <utility>

#include "runtime/base/text/utf8.hpp"

namespace parlour::adapters::mqtt {

namespace {

// Announcements later than this hold nobody up.
// A hub that announces hundreds of devices, or one that never stops, would hold
// up every request otherwise.
constexpr Milliseconds longest_settling{5'000};
// Longer quotations from messages are cut in the log.
constexpr std::size_t longest_quotation = 100;

// The cut does not go through a character.
std::string in_quotes(const std::string& text) {
  auto end = std::min(text.size(), longest_quotation);
  while (end > 0 && end < text.size() && continues_code_point(text[end]))
    --end;
  return "'" + text.substr(0, end) + (end < text.size() ? "…'" : "'");
}

} // namespace

DevicePolicy::DevicePolicy(PolicySettings settings, DeviceList list)
    : settings_(std::move(settings)), list_(std::move(list)), table_(list_),
      requests_(table_, deeds_, settings_.patience) {}

// -- the connection -----------------------------------------------------------

// Everything is subscribed to anew: the server has forgotten the last
// connection.
void DevicePolicy::connected(Moment now) {
  link_ = Link::connected;
  connected_at_ = now;
  settled_at_ = now + settings_.settle;
  has_counted_ = false;
  table_.changes();
  for (auto& filter : discovery_filters(settings_.prefix))
    deeds_.emplace_back(Subscribe{std::move(filter)});
  for (auto& topic : table_.topics())
    deeds_.emplace_back(Subscribe{std::move(topic)});
}

void DevicePolicy::disconnected(const std::string& reason) {
  link_ = Link::down;
  settled_at_ = Moment::max();
  reason_ = "The devices' server cannot be reached: " + reason + ".";
  requests_.fail_all(reason_);
}

void DevicePolicy::end() {
  disconnected("the component is stopped");
}

// -- messages of the server ---------------------------------------------------

// Several devices may read one topic: each takes its part of the payload by its
// template. A broken JSON is told once, and only if one of them needed it.
void DevicePolicy::received(const std::string& topic, std::string text,
                            bool retained, Moment now) {
  if (text.size() > max_payload)
    return complain(Complaint::size,
                    "a message on " + in_quotes(topic) + " has " +
                        std::to_string(text.size()) + " bytes; it is ignored",
                    now);
  if (find_invalid_utf8(text))
    return complain(Complaint::state,
                    "a message on " + in_quotes(topic) + " is no text in UTF-8",
                    now);
  const Payload payload(std::move(text));
  if (const auto kind = discovered_kind(settings_.prefix, topic))
    return announced(topic, *kind, payload, now);
  for (auto* device : table_.readers(topic)) {
    read_availability(*device, topic, payload);
    if (device->entity.state.topic == topic)
      read_state(*device, payload, retained, now);
  }
  if (payload.is_broken())
    complain(Complaint::state,
             "a message on " + in_quotes(topic) +
                 " is no JSON: " + in_quotes(payload.text()),
             now);
}

// An empty message takes the announcement back.
// Each announcement puts off the moment at which all are known.
void DevicePolicy::announced(const std::string& topic, const std::string& kind,
                             const Payload& payload, Moment now) {
  if (link_ == Link::connected && now - connected_at_ < longest_settling)
    settled_at_ = std::max(settled_at_, now + settings_.settle);
  auto found = payload.text().empty() ? Discovery()
                                      : read_discovery(topic, kind, payload);
  for (const auto& mistake : found.mistakes)
    complain(Complaint::announcement, mistake, now);
  if (!table_.set(topic, std::move(found.entities)))
    complain(Complaint::number,
             "there are more than " + std::to_string(DeviceTable::max_devices) +
                 " devices; ignored is " + in_quotes(topic),
             now);
  follow_table();
}

void DevicePolicy::follow_table() {
  if (link_ != Link::connected)
    return;
  auto [added, removed] = table_.changes();
  for (auto& topic : added)
    deeds_.emplace_back(Subscribe{std::move(topic)});
  for (auto& topic : removed)
    deeds_.emplace_back(Unsubscribe{std::move(topic)});
}

// A text that is neither of the two says nothing.
void DevicePolicy::read_availability(Device& device, const std::string& topic,
                                     const Payload& payload) {
  using State = AvailabilitySource::State;
  const auto& all = device.entity.availability;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].source.topic != topic)
      continue;
    const auto text = all[i].source.value.apply(payload);
    if (!text || (*text != all[i].available && *text != all[i].unavailable))
      continue;
    device.sources[i] =
        *text == all[i].available ? State::available : State::unavailable;
    device.latest_source = i;
  }
}

// What the message does not mention stays as it was.
void DevicePolicy::read_state(Device& device, const Payload& payload,
                              bool retained, Moment now) {
  const auto text = device.entity.state.value.apply(payload);
  if (!text || text->empty())
    return;
  auto state = meaning_of(device.entity, *text);
  if (!state)
    return complain(Complaint::state,
                    in_quotes(*text) + " is no state of " +
                        in_quotes(device.entity.id),
                    now);
  const bool changes = !(device.state == *state);
  device.state = std::move(*state);
  device.told = now;
  const bool was_awaited = requests_.told(device, retained, now);
  if (!retained && !was_awaited && (changes || device.entity.repeats) &&
      !device.state.is_unknown())
    tell(device, now);
}

void DevicePolicy::tell(const Device& device, Moment now) {
  const auto spoken = table_.spoken(device);
  if (!spoken)
    return;
  if (!news_.admit(now))
    return complain(Complaint::news,
                    "devices change too fast; conversations do not hear of " +
                        in_quotes(device.entity.id),
                    now);
  deeds_.emplace_back(News{{spoken->device, spoken->room, device.state}});
}

// -- messages of conversations ------------------------------------------------

// While the link is starting, a request waits; it fails by its own patience if
// no connection comes.
void DevicePolicy::order(const Message& message, Moment now) {
  requests_.add(message, now);
  if (link_ == Link::down)
    requests_.fail_all(reason_);
  else
    decide(now);
}

void DevicePolicy::published(Ticket ticket, Moment now) {
  requests_.published(ticket, now);
}

void DevicePolicy::not_published(Ticket ticket) {
  requests_.not_published(ticket);
}

bool DevicePolicy::is_settled(Moment now) const {
  return link_ == Link::connected && now >= settled_at_;
}

void DevicePolicy::decide(Moment now) {
  if (is_settled(now)) {
    if (!std::exchange(has_counted_, true))
      deeds_.emplace_back(Log{std::to_string(table_.size()) +
                              " devices are known; the application speaks of " +
                              std::to_string(table_.spoken_of())});
    requests_.begin(now);
  }
  requests_.expire(now);
}

Deeds DevicePolicy::deeds() {
  return std::exchange(deeds_, {});
}

// The end of settling matters for the line in the log, or if somebody waits.
Moment DevicePolicy::next_moment() const {
  const bool settles = !has_counted_ || requests_.has_held();
  return std::min(requests_.next_moment(),
                  settles ? settled_at_ : Moment::max());
}

void DevicePolicy::complain(Complaint kind, const std::string& text,
                            Moment now) {
  if (auto line = complaints_.note(kind, text, now))
    deeds_.emplace_back(Log{std::move(*line)});
}

} // namespace parlour::adapters::mqtt
