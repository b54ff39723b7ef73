// Coverage compares two sets of names: all that the program contains, and those
// that inspections report. Branches, transitions and handlers have no names, so
// their place "file:line" stands for them.
#include "tools/parlour/conversation_test/coverage.hpp"

#include <algorithm>
#include <ostream>
#include <utility>

#include "runtime/base/text/names.hpp"
#include "runtime/base/text/paths.hpp"
#include "script/program/host.hpp"
#include "script/program/instruction.hpp"

namespace parlour::tools {

namespace {

using script::EffectKind;
using script::Instruction;
using script::Operation;
using script::Program;

// "Topic.Slot", as inspections name slots.
std::vector<std::string> slot_names(const Program& program) {
  std::vector<std::string> names;
  for (const auto& topic : program.topics)
    for (const auto& slot : topic.slots)
      names.push_back(topic.name + "." + slot.name);
  return names;
}

// The name under which a place is reported and compared.
std::string place_name(const SourceLocation& place) {
  return place.file + ":" + std::to_string(place.line);
}

// The places of all instructions for which `wanted` is true, sorted, one for
// each line. Only the application's own files count: it need not reach
// everything in the platform's libraries.
template <class Predicate>
std::vector<std::string> places_of(const Program& program, Predicate wanted) {
  std::set<std::pair<std::string, std::uint32_t>> places;
  for (const auto& code : program.code)
    for (std::size_t i = 0; i < code.instructions.size(); ++i)
      if (wanted(code, code.instructions[i])) {
        const auto place = program.place(code.positions[i]);
        if (is_below(place.file, program.settings.folder))
          places.emplace(place.file, place.line);
      }
  std::vector<std::string> names;
  for (const auto& [file, line] : places)
    names.push_back(place_name({file, line, 0}));
  return names;
}

// Instructions store their operation as a byte.
bool is(const Instruction& instruction, Operation operation) {
  return instruction.operation == static_cast<std::uint8_t>(operation);
}

// The compiler emits the instruction `reached` at the start of a branch.
std::vector<std::string> branch_names(const Program& program) {
  return places_of(program, [](const auto&, const Instruction& instruction) {
    return is(instruction, Operation::reached);
  });
}

// Each <transit> and <push>: their effects are instructions.
std::vector<std::string> transition_names(const Program& program) {
  return places_of(program, [](const script::Code& code,
                               const Instruction& instruction) {
    if (!is(instruction, Operation::effect))
      return false;
    const auto kind = static_cast<EffectKind>(code.effects[instruction.c].kind);
    return kind == EffectKind::transit || kind == EffectKind::push;
  });
}

// For each handler's reaction, its name "Turn (ASR.RecognitionResult)" and the
// place that is reported when it runs.
using NamedPlaces = std::vector<std::pair<std::string, std::string>>;

NamedPlaces reactions_of(const Program& program) {
  NamedPlaces found;
  for (const auto& handler : program.handlers)
    for (const auto& reaction : handler.reactions)
      found.emplace_back(handler.name + " (" + reaction.source + "." +
                             reaction.event + ")",
                         place_name(program.place(reaction.position)));
  return found;
}

} // namespace

Coverage::Coverage(const Program& program) : program_(&program) {}

// Inspections report a branch, handler or transition by its place.
void Coverage::note(const Inspection& inspection) {
  switch (inspection.kind) {
  case InspectionKind::transition:
    states_.insert(inspection.subject);
    break;
  case InspectionKind::topic:
    topics_.insert(inspection.subject);
    break;
  case InspectionKind::slot:
    slots_.insert(inspection.subject);
    break;
  case InspectionKind::branch:
    places_.insert(inspection.subject);
    break;
  default:
    break;
  }
}

void Coverage::add(const Coverage& other) {
  states_.insert(other.states_.begin(), other.states_.end());
  topics_.insert(other.topics_.begin(), other.topics_.end());
  slots_.insert(other.slots_.begin(), other.slots_.end());
  places_.insert(other.places_.begin(), other.places_.end());
}

std::vector<Coverage::Part> Coverage::parts() const {
  return {part("states", names_of(program_->states), states_),
          part("transitions", transition_names(*program_), places_),
          part("topics", names_of(program_->topics), topics_),
          part("slots", slot_names(*program_), slots_),
          handlers(),
          part("branches", branch_names(*program_), places_)};
}

// A handler is shown by its name but compared by its place.
Coverage::Part Coverage::handlers() const {
  const auto all = reactions_of(*program_);
  Part made{"handlers", all.size(), {}};
  for (const auto& [name, place] : all)
    if (places_.count(place) == 0)
      made.missing.push_back(name);
  return made;
}

Coverage::Part Coverage::part(const char* name,
                              const std::vector<std::string>& all,
                              const std::set<std::string>& reached) const {
  Part made{name, all.size(), {}};
  for (const auto& one : all)
    if (reached.count(one) == 0)
      made.missing.push_back(one);
  return made;
}

void print(std::ostream& out, const Coverage& coverage, const Places& places) {
  out << "coverage:\n";
  for (const auto& part : coverage.parts()) {
    out << "  " << part.name << ' ' << part.all - part.missing.size() << " of "
        << part.all << '\n';
    for (const auto& missing : part.missing)
      out << "    not reached: " << shown_path(places, missing) << '\n';
  }
}

} // namespace parlour::tools
