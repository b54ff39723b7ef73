#include "tools/parlour/coverage.hpp"

#include <algorithm>
#include <ostream>

#include "script/instruction.hpp"

namespace parlour::tools {

namespace {

using script::Operation;
using script::Program;

std::vector<std::string> slot_names(const Program& program) {
  std::vector<std::string> names;
  for (const auto& topic : program.topics)
    for (const auto& slot : topic.slots)
      names.push_back(topic.name + "." + slot.name);
  return names;
}

std::string reaction_name(const script::Handler& handler,
                          const script::Reaction& reaction) {
  return handler.name + " (" + reaction.source + "." + reaction.event + ")";
}

std::vector<std::string> reaction_names(const Program& program) {
  std::vector<std::string> names;
  for (const auto& handler : program.handlers)
    for (const auto& reaction : handler.reactions)
      names.push_back(reaction_name(handler, reaction));
  return names;
}

std::string place_name(const Place& place) {
  return place.file + ":" + std::to_string(place.line);
}

// Where the compiler put a mark for coverage, in the order of the files.
std::vector<std::string> branch_names(const Program& program) {
  std::set<std::pair<std::string, std::uint32_t>> places;
  for (const auto& code : program.code)
    for (std::size_t i = 0; i < code.instructions.size(); ++i)
      if (code.instructions[i].operation ==
          static_cast<std::uint8_t>(Operation::reached)) {
        const auto place = program.place(code.positions[i]);
        places.emplace(place.file, place.line);
      }
  std::vector<std::string> names;
  for (const auto& [file, line] : places)
    names.push_back(place_name({file, line, 0}));
  return names;
}

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& all) {
  std::vector<std::string> names;
  for (const auto& one : all)
    names.push_back(one.name);
  return names;
}

} // namespace

Coverage::Coverage(const Program& program, const ModuleNames& names)
    : program_(&program), names_(&names) {}

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
    branches_.insert(inspection.subject);
    break;
  case InspectionKind::message:
    if (inspection.message && inspection.message->sinks.empty())
      note_message(*inspection.message);
    break;
  default:
    break;
  }
}

// A message without a sink goes to the session, whose handlers take it.
void Coverage::note_message(const Message& message) {
  for (const auto& handler : program_->handlers)
    for (const auto& reaction : handler.reactions)
      if ((reaction.event == "*" || reaction.event == message.command) &&
          (reaction.source == "*" ||
           names_->same(reaction.source, message.source)))
        reactions_.insert(reaction_name(handler, reaction));
}

void Coverage::add(const Coverage& other) {
  states_.insert(other.states_.begin(), other.states_.end());
  topics_.insert(other.topics_.begin(), other.topics_.end());
  slots_.insert(other.slots_.begin(), other.slots_.end());
  reactions_.insert(other.reactions_.begin(), other.reactions_.end());
  branches_.insert(other.branches_.begin(), other.branches_.end());
}

std::vector<Coverage::Part> Coverage::parts() const {
  return {part("states", names_of(program_->states), states_),
          part("topics", names_of(program_->topics), topics_),
          part("slots", slot_names(*program_), slots_),
          part("handlers", reaction_names(*program_), reactions_),
          part("branches", branch_names(*program_), branches_)};
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
