// Compiles such elements:
//
//   <state name="Welcome" capture="true">
//     <Entrance>…</Entrance>
//     <Messages><component><Door><Opens>…</Opens></Door></component></Messages>
//     <Online><agent name="Robot2">…</agent></Online>
//     <Exit>…</Exit>
//   </state>

#include "script/compiler/state_compiler.hpp"

#include <iterator>

#include "script/compiler/name_collector.hpp"
#include "script/compiler/reaction_compiler.hpp"
#include "script/program/effect_names.hpp"
#include "script/program/effect_search.hpp"

namespace parlour::script {

namespace {

Capture capture_of(const Element& element) {
  const auto word = element.value("capture");
  return word == "all"    ? Capture::all
         : word == "true" ? Capture::acts
                          : Capture::none;
}

// An agent can have one entry only.
void check_first(const Element& agent, const Element& holder,
                 Compilation& compilation) {
  // Only the children before this one can be its predecessors.
  for (const auto& other : holder.children) {
    if (&other == &agent)
      return;
    if (agent.is("agent") && other.is("agent") &&
        other.value("name") == agent.value("name"))
      return compilation.findings.error(
          agent.position,
          "a second <agent name=\"" + agent.value("name") + "\"> in <" +
              holder.name + ">, after the one in line " +
              std::to_string(other.position.line) + "; put both into one");
  }
}

// <Online> and <Offline> hold statements for any agent, or <agent> children for
// a particular one.
void compile_agents(const Element& element, const BodyContext& context,
                    std::vector<Reaction>& reactions,
                    Compilation& compilation) {
  bool for_any = false;
  for (const auto& child : element.children) {
    check_first(child, element, compilation);
    if (child.is("agent"))
      reactions.push_back({child.value("name"), element.name,
                           compilation.bodies.body(child, context),
                           child.position});
    else
      for_any = true;
  }
  if (for_any)
    reactions.push_back(
        {"*", element.name,
         compilation.bodies.body(element, context, {}, {"agent"}),
         element.position});
}

void append(std::vector<Reaction>& all, std::vector<Reaction> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()),
             std::make_move_iterator(more.end()));
}

} // namespace

// insert() keeps existing entries, so inner functions hide outer ones.
FunctionNames local_functions(const Element& holder,
                              const FunctionNames* around,
                              Compilation& compilation) {
  auto functions =
      collect_functions(holder, compilation.program, compilation.findings);
  if (around)
    functions.insert(around->begin(), around->end());
  return functions;
}

void compile_handler(const Element& element, Handler& handler,
                     const FunctionNames* functions, Compilation& compilation) {
  BodyContext context;
  context.functions = functions;
  context.name = "handler " + handler.name;
  for (const auto& child : element.children)
    append(handler.reactions, compile_messages(child, context, compilation));
}

// The functions of the state come first, so that its other parts can call them.
void compile_state(const Element& element, State& state,
                   const FunctionNames* functions, Compilation& compilation) {
  const auto local = local_functions(element, functions, compilation);
  BodyContext context;
  context.functions = &local;
  compile_functions(element, local, context, compilation);
  context.name = "state " + state.name;
  state.capture = capture_of(element);
  state.grammar = element.value("grammar");
  check_grammar(element, compilation);
  state.entrance = compile_child(element, "Entrance", context, compilation);
  state.exit = compile_child(element, "Exit", context, compilation);
  for (const auto& child : element.children) {
    if (child.is("Messages"))
      append(state.messages, compile_messages(child, context, compilation));
    else if (child.is("Online"))
      compile_agents(child, context, state.online, compilation);
    else if (child.is("Offline"))
      compile_agents(child, context, state.offline, compilation);
  }
}

namespace {

// The line of another place, with its file if that is a different one.
std::string place_text(Position there, Position here,
                       const Findings& findings) {
  const auto place = findings.place(there);
  const auto slash = place.file.rfind('/') + 1; // npos + 1 is 0
  return "line " + std::to_string(place.line) +
         (there.file == here.file ? "" : " of " + place.file.substr(slash));
}

// `what` is the code in words, such as "an Exit".
void check_way_out(CodeId code, const char* what, Compilation& compilation) {
  auto& findings = compilation.findings;
  const auto found = find_effect(compilation.program, code, leads_elsewhere);
  if (!found)
    return;
  const auto element = "<" + element_of(found->kind) + ">";
  const std::string reason = ": the state is being left already";
  if (found->is_called)
    findings.error(found->call,
                   "this leads to the " + element + " in " +
                       place_text(found->position, found->call, findings) +
                       ", and " + what + " cannot have one" + reason);
  else
    findings.error(found->position,
                   "a " + element + " cannot stand in " + what + reason);
}

} // namespace

// Searches the compiled code, because the effect may be in a function.
void check_ways_out(Compilation& compilation) {
  const auto& program = compilation.program;
  for (const auto& state : program.states)
    check_way_out(state.exit, "an Exit", compilation);
  for (const auto& code : program.code)
    for (const auto& effect : code.effects)
      if (static_cast<EffectKind>(effect.kind) == EffectKind::transit)
        check_way_out(effect.body, "a <transit>", compilation);
}

} // namespace parlour::script
