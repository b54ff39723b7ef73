#include "script/compiler/seat_compiler.hpp"

#include "runtime/message/roles.hpp"

namespace parlour::script {

namespace {

// A role's event as the table of roles spells it.
std::string spelt(const std::string& source, const std::string& event) {
  if (const auto* role = find_role(source))
    for (const auto& known : role->events)
      if (same_name(known.name, event))
        return known.name;
  return event;
}

void compile_event(const std::string& text, const Element& seat,
                   Compilation& compilation) {
  const auto& position = seat.attribute("opens")->value_position;
  const auto dot = text.find('.');
  if (dot == 0 || dot == std::string::npos || dot + 1 == text.size())
    return compilation.findings.error(
        position, "'" + text +
                      "' is no event: expected who fires it and what, such as "
                      "VAD.SpeechStarted; several are separated by commas");
  const auto source = text.substr(0, dot);
  compilation.program.openings.push_back(
      {source, spelt(source, text.substr(dot + 1)), no_code, seat.value("name"),
       position});
}

} // namespace

void compile_seats(const Element& settings, Compilation& compilation) {
  for (const auto& child : settings.children)
    if (child.is("seat"))
      for (const auto& event : split_names(child.value("opens")))
        compile_event(event, child, compilation);
}

} // namespace parlour::script
