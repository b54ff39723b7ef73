#include "actors/services.hpp"

#include <utility>

#include <caf/send.hpp>

namespace parlour::actors {

void Services::publish(std::vector<Message> messages) {
  auto send = [this, messages = std::move(messages), piece = work.begin()] {
    if (centre)
      caf::anon_send(centre, actors::publish{messages, piece});
  };
  gate.enter(std::move(send));
}

void Services::unhandled(const Message& message, const std::string& why) {
  ++counters->unhandled;
  if (!inspect) {
    log(to_string(message) + ": " + why);
    return;
  }
  Inspection inspection;
  inspection.kind = InspectionKind::unhandled;
  inspection.session = message.session;
  inspection.subject = message.source + "." + message.command;
  inspection.detail = why;
  inspection.message = std::make_shared<const Message>(message);
  inspect(std::move(inspection));
}

Tap inspection_tap(Services& services) {
  return [&services](const Message& message, const std::string& way) {
    Inspection inspection;
    inspection.kind = InspectionKind::message;
    inspection.session = message.session;
    inspection.subject = message.source + "." + message.command;
    inspection.detail = to_string(message);
    inspection.message = std::make_shared<const Message>(message);
    inspection.way = way;
    services.inspect(std::move(inspection));
  };
}

} // namespace parlour::actors
