// Compiles such elements:
//
//   <relay source="ASR" command="RecognitionResult" to="LogRobot" as="Heard"/>
//   <filter source="ASR" command="RecognitionResult" if="_LPARAM2 lt 0.3"
//           drop="true"/>
//   <open source="Devices" command="State" if="_LPARAM1 == 'door'"/>

#include "script/compiler/route_compiler.hpp"

#include "script/compiler/reaction_compiler.hpp"

namespace parlour::script {

namespace {

// Routes have a body compiler of their own, which knows fewer names: the
// message centre has no session.
class RouteCompiler {
public:
  explicit RouteCompiler(Compilation& compilation)
      : compilation_(compilation), names_(without_variables(compilation)),
        bodies_(compilation.program, names_, compilation.findings) {
    context_.handles_message = true;
    context_.name = "routes";
  }

  void compile(const Element& element);

private:
  EventName event_of(const Element& element);
  CodeId condition_of(const Element& element);
  void compile_params(const Element& element, Route& route);
  void compile_route(const Element& element);
  void compile_opening(const Element& element);

  Compilation& compilation_;
  Names names_;
  BodyCompiler bodies_;
  BodyContext context_;
};

// Without any parameter the message keeps its own; `param=""` removes them.
void RouteCompiler::compile_params(const Element& element, Route& route) {
  if (const auto* param = element.attribute("param")) {
    route.has_params = true;
    if (!param->value.empty())
      route.params.push_back(bodies_.text_or_expression(*param, context_));
  }
  for (const auto& child : element.children) {
    if (!child.is("param"))
      continue;
    route.has_params = true;
    route.params.push_back(
        bodies_.expression(*child.attribute("expr"), context_));
  }
}

EventName RouteCompiler::event_of(const Element& element) {
  const auto& source = *element.attribute("source");
  const auto& command = *element.attribute("command");
  return checked_event({source.value, command.value}, source.value_position,
                       command.value_position, compilation_);
}

CodeId RouteCompiler::condition_of(const Element& element) {
  const auto* condition = element.attribute("if");
  return condition ? bodies_.expression(*condition, context_) : no_code;
}

void RouteCompiler::compile_route(const Element& element) {
  auto name = event_of(element);
  Route route;
  route.is_filter = element.is("filter");
  route.source = std::move(name.source);
  route.command = std::move(name.event);
  route.condition = condition_of(element);
  route.drop = element.value("drop") == "true";
  route.to = split_names(element.value("to"));
  route.as = element.value("as");
  compile_params(element, route);
  route.position = element.position;
  compilation_.program.routes.push_back(std::move(route));
}

void RouteCompiler::compile_opening(const Element& element) {
  auto name = event_of(element);
  compilation_.program.openings.push_back(
      {std::move(name.source), std::move(name.event), condition_of(element),
       std::string(element.value("seat")), element.position});
}

void RouteCompiler::compile(const Element& element) {
  if (element.is("open"))
    compile_opening(element);
  else
    compile_route(element);
}

} // namespace

void compile_routes(const Element& routes, Compilation& compilation) {
  RouteCompiler compiler(compilation);
  for (const auto& route : routes.children)
    compiler.compile(route);
}

} // namespace parlour::script
