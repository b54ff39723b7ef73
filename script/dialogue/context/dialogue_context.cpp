#include "script/dialogue/context/dialogue_context.hpp"

#include <utility>

namespace parlour::dialogue {

DialogueContext::DialogueContext(
    const script::Interpreter& interpreter,
    std::shared_ptr<const script::Program> the_program,
    ConversationOptions the_options, Port& the_port)
    : program(std::move(the_program)), options(std::move(the_options)),
      port(the_port), privacy(*program, interpreter, port) {}

// A seat that the settings no longer name is as any other.
Milliseconds DialogueContext::closes_after() const {
  const auto& settings = program->settings;
  const auto* seat = find_seat(settings.seats, options.seat);
  return seat && seat->closes_after ? *seat->closes_after
                                    : settings.sessions.closes_after;
}

// The port must know what is private before it is shown a text that may hold
// it.
void DialogueContext::inspect(InspectionKind kind, std::string subject,
                              std::string detail) {
  privacy.note_variables(now);
  if (port.inspected() || kind == InspectionKind::error ||
      kind == InspectionKind::log)
    port.inspect({.kind = kind,
                  .session = options.session,
                  .subject = std::move(subject),
                  .detail = std::move(detail)});
}

void DialogueContext::tell_reached(script::Position position) {
  const auto place = program->place(position);
  inspect(InspectionKind::branch, place.file + ":" + std::to_string(place.line),
          "");
}

} // namespace parlour::dialogue
