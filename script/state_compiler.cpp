#include "script/state_compiler.hpp"

#include <iterator>

#include "script/name_collector.hpp"
#include "script/reaction_compiler.hpp"

namespace parlour::script {

namespace {

Capture capture_of(const Element& element) {
  const auto word = element.value("capture");
  return word == "all"    ? Capture::all
         : word == "true" ? Capture::acts
                          : Capture::none;
}

// <Online> and <Offline>: statements for any agent, or <agent> children.
void compile_agents(const Element& element, const BodyContext& context,
                    std::vector<Reaction>& reactions,
                    Compilation& compilation) {
  bool for_any = false;
  for (const auto& child : element.children) {
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
  auto leaving = context;
  leaving.in_exit = true;
  state.exit = compile_child(element, "Exit", leaving, compilation);
  for (const auto& child : element.children) {
    if (child.is("Messages"))
      append(state.messages, compile_messages(child, context, compilation));
    else if (child.is("Online"))
      compile_agents(child, context, state.online, compilation);
    else if (child.is("Offline"))
      compile_agents(child, context, state.offline, compilation);
  }
}

} // namespace parlour::script
