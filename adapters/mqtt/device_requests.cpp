#include "adapters/mqtt/device_requests.hpp"

#include <algorithm>
#include <utility>

#include "adapters/mqtt/device_commands.hpp"

namespace parlour::adapters::mqtt {

namespace {

std::string text_param(const Message& message, std::size_t index) {
  return index < message.params.size() && !message.params[index].is_unknown()
             ? message.params[index].text()
             : std::string();
}

// Of several devices, one that is on or open tells more than the others.
bool stands_out(const Value& state) {
  return state == Value("on") || state == Value("open");
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names)
    text += (text.empty() ? "" : ", ") + name;
  return text;
}

// "There is no 'fan' in 'kitchen'; there is: lamp, heating."
std::string not_there(const Spoken& what, const DeviceTable& table) {
  const auto others = table.in_room(what.room);
  return "There is no '" + what.device + "' in '" + what.room + "'" +
         (others.empty() ? "." : "; there is: " + listed(others) + ".");
}

std::string silent(const Spoken& what) {
  return subject(what) + " does not answer.";
}

} // namespace

// -- the life of a request ----------------------------------------------------

// Answers a request and forgets it wherever `ends` returns true.
template <class Ends>
void DeviceRequests::end_those(Ends ends) {
  for (auto next = requests_.begin(); next != requests_.end();) {
    const auto one = next++;
    if (one->answered || ends(*one))
      requests_.erase(one);
  }
}

void DeviceRequests::add(const Message& message, Moment now) {
  Request made{message,
               message.command == "Set",
               {text_param(message, 0), text_param(message, 1)},
               message.params.size() > 2 ? message.params[2] : Value(),
               now + patience_,
               true,
               {},
               false};
  if (!made.sets && message.command != "Ask")
    fail(made, "There is no command '" + message.command + "' here.");
  else if (made.what.device.empty() || made.what.room.empty())
    fail(made, message.command + " needs a device and a room.");
  else if (requests_.size() >= max_pending)
    fail(made, "Too many wait for the devices.");
  else
    requests_.push_back(std::move(made));
}

void DeviceRequests::begin(Moment now) {
  end_those([&](Request& request) {
    return std::exchange(request.held, false) && begin(request, now);
  });
}

// Devices that say they are away are left out, if others of the name are there.
bool DeviceRequests::begin(Request& request, Moment now) {
  auto found = table_.find(request.what.device, request.what.room);
  if (found.empty()) {
    fail(request, not_there(request.what, table_));
    return true;
  }
  std::erase_if(found, [](const Device* one) { return !one->is_available(); });
  if (found.empty()) {
    fail(request, silent(request.what));
    return true;
  }
  return request.sets ? begin_set(request, std::move(found))
                      : begin_ask(request, found, now);
}

// A device that has told its state is not asked again: MQTT has no way to ask.
// The request waits for one that has said nothing yet.
bool DeviceRequests::begin_ask(Request& request,
                               const std::vector<Device*>& found, Moment now) {
  Value best;
  for (const auto* one : found) {
    const auto state = one->state_at(now);
    if (best.is_unknown() || stands_out(state))
      best = state;
    request.awaited.push_back({one->entity.id, {}, 0, 0, {}, false});
  }
  if (best.is_unknown())
    return false;
  answer_state(request, best);
  return true;
}

// Two lamps of a room are switched together. Two locks are not opened together:
// the user may mean only one of them.
bool DeviceRequests::begin_set(Request& request, std::vector<Device*> found) {
  const bool locks = std::ranges::any_of(
      found, [](const Device* one) { return one->entity.is_lock; });
  if (locks && found.size() > 1) {
    std::vector<std::string> names;
    for (const auto* one : found)
      names.push_back(one->entity.name.empty() ? one->entity.device
                                               : one->entity.name);
    fail(request, "There are several in the " + request.what.room + ": " +
                      listed(names) + ".");
    return true;
  }
  return publish(request, found);
}

// Nothing is published unless all of them take the value.
bool DeviceRequests::publish(Request& request,
                             const std::vector<Device*>& found) {
  Deeds orders;
  auto ticket = last_ticket_;
  for (const auto* one : found) {
    const auto& entity = one->entity;
    auto command = command_for(*one, request.what, request.value);
    if (!command) {
      fail(request, command.error().message);
      return true;
    }
    ++ticket;
    orders.emplace_back(Publish{ticket, std::move(command->topic),
                                std::move(command->payload),
                                entity.retains_commands});
    request.awaited.push_back({entity.id, std::move(command->shown_by),
                               entity.is_optimistic ? ticket : 0, ticket,
                               Value(), false});
  }
  last_ticket_ = ticket;
  supersede(request);
  for (auto& order : orders)
    deeds_.push_back(std::move(order));
  return false;
}

// An earlier order for the same device, which says otherwise, will not be shown
// any more. The caller may iterate: its own request is not touched.
void DeviceRequests::supersede(const Request& by) {
  for (auto next = requests_.begin(); next != requests_.end();) {
    const auto one = next++;
    const bool meets =
        &*one != &by && one->sets && !one->held && !one->answered &&
        !(one->value == by.value) &&
        std::ranges::any_of(one->awaited, [&](const Awaited& each) {
          return std::ranges::find(by.awaited, each.id, &Awaited::id) !=
                 by.awaited.end();
        });
    if (!meets)
      continue;
    fail(*one, "Another order has come in between.");
    one->answered = true;
  }
}

// -- what devices say ---------------------------------------------------------

// One message may answer several requests.
bool DeviceRequests::told(const Device& device, bool retained, Moment now) {
  bool was_awaited = false;
  end_those([&](Request& request) {
    return !request.held && told(request, device, retained, now, was_awaited);
  });
  return was_awaited;
}

bool DeviceRequests::told(Request& request, const Device& device, bool retained,
                          Moment now, bool& was_awaited) {
  const auto found =
      std::ranges::find(request.awaited, device.entity.id, &Awaited::id);
  const auto state = device.state_at(now);
  if (found == request.awaited.end() || state.is_unknown() ||
      (request.sets && retained))
    return false;
  if (!request.sets) {
    was_awaited = true;
    answer_state(request, state);
    return true;
  }
  found->said = state;
  if (state == Value("jammed")) {
    was_awaited = true;
    fail(request, subject(request.what) + " is jammed.");
    return true;
  }
  if (!shows(state, found->shown_by))
    return false;
  was_awaited = true;
  found->done = true;
  return obeyed(request);
}

// Answers if all devices have obeyed. One tells its own state; of several, the
// state is what they were told.
bool DeviceRequests::obeyed(Request& request) {
  if (!std::ranges::all_of(request.awaited, &Awaited::done))
    return false;
  const auto& first = request.awaited.front();
  answer_state(request,
               request.awaited.size() == 1 ? first.said : request.value);
  return true;
}

// Where the device tells nothing, the state is what it was told.
void DeviceRequests::published(Ticket ticket, Moment now) {
  end_those([&](Request& request) {
    const auto found =
        std::ranges::find(request.awaited, ticket, &Awaited::receipt);
    if (ticket == 0 || found == request.awaited.end())
      return false;
    found->done = true;
    found->said = found->shown_by.front();
    if (auto* device = table_.find(found->id)) {
      device->state = found->said;
      device->told = now;
    }
    return obeyed(request);
  });
}

void DeviceRequests::not_published(Ticket ticket) {
  end_those([&](Request& request) {
    if (std::ranges::find(request.awaited, ticket, &Awaited::ticket) ==
        request.awaited.end())
      return false;
    fail(request, silent(request.what));
    return true;
  });
}

// -- the end ------------------------------------------------------------------

void DeviceRequests::expire(Moment now) {
  end_those([&](Request& request) {
    if (now < request.deadline)
      return false;
    late(request);
    return true;
  });
}

// A device that was in the wanted state before and says nothing counts as
// obedient, as some tell only what changes. A lock must say so.
// The answer quotes what it said last, if it said anything: "The door in the
// hall says 'open'."
void DeviceRequests::late(Request& request) {
  if (request.held)
    return fail(request, "The devices' server does not answer.");
  if (!request.sets)
    return fail(request, subject(request.what) + " has not said anything yet.");
  Value said;
  for (auto& one : request.awaited) {
    const auto* device = table_.find(one.id);
    if (!one.done && device && !device->entity.is_lock &&
        shows(device->state, one.shown_by)) {
      one.done = true;
      one.said = device->state;
    }
    if (!one.done)
      said = one.said;
  }
  if (obeyed(request))
    return;
  fail(request, said.is_unknown()
                    ? silent(request.what)
                    : subject(request.what) + " says '" + said.text() + "'.");
}

void DeviceRequests::fail_all(const std::string& reason) {
  for (const auto& request : std::exchange(requests_, {}))
    if (!request.answered)
      fail(request, reason);
}

void DeviceRequests::answer_state(const Request& request, const Value& value) {
  deeds_.emplace_back(Answer{request.message,
                             "State",
                             {request.what.device, request.what.room, value}});
}

void DeviceRequests::fail(const Request& request, const std::string& reason) {
  deeds_.emplace_back(Answer{request.message, "Failed", {reason}});
}

bool DeviceRequests::has_held() const {
  return std::ranges::any_of(requests_, &Request::held);
}

Moment DeviceRequests::next_moment() const {
  auto next = Moment::max();
  for (const auto& request : requests_)
    next = std::min(next, request.deadline);
  return next;
}

} // namespace parlour::adapters::mqtt
