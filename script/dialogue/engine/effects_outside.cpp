// What scripts want of databases, files, the network and whoever keeps the
// components. Each waits, holding no
// thread; the outcome comes back by answered().
#include <utility>

#include "script/dialogue/engine/effect_handler.hpp"
#include "script/dialogue/engine/effect_operands.hpp"

namespace parlour::dialogue {

bool EffectHandler::answered(QueryId id, Expected<Value> outcome) {
  const auto found = queries_.find(id);
  if (found == queries_.end())
    return false;
  const auto query = found->second;
  queries_.erase(found);
  if (query.rollback)
    outcome = Value();
  waits_.resume(query.wait, std::move(outcome));
  return true;
}

// -- databases ----------------------------------------------------------------

// One with a name is asked by it. One without is asked by all queries that name
// none, from now on; it may be written to by the activation that says so, so
// that no other writes unawares.
script::Performed
EffectHandler::connect_database(script::Activation& activation, Call effect) {
  auto component =
      effect.operand(1).is_unknown() ? std::string() : effect.text(1);
  if (!context_.port.reachable(component.empty() ? "Database" : component))
    return Error{ErrorKind::offline,
                 "no database component '" + component + "' is there",
                 {}};
  const bool write{effect.operand(2)};
  if (effect.operand(0).is_unknown()) {
    current_ = std::move(component);
    activation.let_write(write);
  } else {
    connections_[effect.text(0)] = {std::move(component), write};
  }
  return Value(true);
}

// `named`: a connection, or a component, which is read only.
script::Performed EffectHandler::ask_database(Context context,
                                              QueryRequest request,
                                              const Value& named) {
  const auto connection =
      named.is_unknown() ? connections_.end() : connections_.find(named.text());
  if (named.is_unknown()) {
    request.database = current_;
    request.write = context.writes;
  } else if (connection != connections_.end()) {
    request.database = connection->second.component;
    request.write = connection->second.write;
  } else if (context_.port.reachable(named.text())) {
    request.database = named.text();
  } else {
    return missing("database", named);
  }
  request.id = context_.next_id();
  queries_[request.id] = {begin_wait(ActivationRunner::WaitFor::answer),
                          request.kind == QueryRequest::Kind::rollback};
  context_.port.query(std::move(request));
  return script::Waits{};
}

script::Performed EffectHandler::query_database(Context context, Call effect) {
  QueryRequest request;
  request.sql = effect.text(0);
  request.values = list_of(effect.operand(1));
  return ask_database(context, std::move(request), effect.operand(2));
}

script::Performed EffectHandler::transaction(Context context, Call effect,
                                             QueryRequest::Kind kind) {
  QueryRequest request;
  request.kind = kind;
  return ask_database(context, std::move(request), effect.operand(0));
}

// -- files, sockets -----------------------------------------------------------

script::Performed EffectHandler::file(FileRequest request) {
  const auto id = context_.next_id();
  const auto wait = begin_wait(ActivationRunner::WaitFor::answer);
  queries_[id] = {wait, false};
  // A disk may hang: a share of the network, for one.
  context_.timers.start(
      context_.program->settings.sessions.request_timeout,
      {.purpose = Timer::Purpose::wait, .wait = wait, .correlation = id});
  context_.port.file(id, std::move(request));
  return script::Waits{};
}

// No time-out: whoever keeps the components sees to it that one comes up or
// goes in time, and what was begun is not to end unheard.
script::Performed EffectHandler::change_component(Call effect) {
  ComponentRequest request;
  request.id = context_.next_id();
  request.load = effect.kind == script::EffectKind::load;
  if (request.load)
    request.plugin = effect.text(0);
  request.name = text_or(effect.operand(request.load ? 1 : 0), "");
  queries_[request.id] = {begin_wait(ActivationRunner::WaitFor::answer), false};
  context_.port.component(std::move(request));
  return script::Waits{};
}

script::Performed EffectHandler::open_socket(Call effect) {
  if (auto may = sockets_.may_open(effect.text(0)); !may)
    return may.error();
  sockets_.open(effect, begin_wait(ActivationRunner::WaitFor::answer));
  return script::Waits{};
}

} // namespace parlour::dialogue
