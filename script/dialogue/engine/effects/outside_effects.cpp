#include "script/dialogue/engine/effects/outside_effects.hpp"

#include <utility>

#include "script/dialogue/engine/effects/effect_operands.hpp"
#include "script/program/effect_names.hpp"
#include "script/program/file_effect.hpp"

namespace parlour::dialogue {

namespace {

Error not_yet(const script::Effect& effect) {
  return {ErrorKind::refused,
          "<" + script::element_of(effect.kind) + "> is not available yet",
          {}};
}

} // namespace

// Files first: their effects are told apart by file_request, which also reads
// their operands.
script::Performed OutsideEffects::perform(script::Activation& activation,
                                          Call effect) {
  const bool writes = activation.context().writes;
  using enum script::EffectKind;
  if (auto request = script::file_request(
          effect, context_.program->settings.limits.result))
    return file(std::move(*request));
  switch (effect.kind) {
  case connectdb:
    return connect_database(activation, effect);
  case querydb:
    return query_database(writes, effect);
  case begin:
    return transaction(writes, effect, QueryRequest::Kind::begin);
  case commit:
    return transaction(writes, effect, QueryRequest::Kind::commit);
  case rollback:
    return transaction(writes, effect, QueryRequest::Kind::rollback);
  case open_socket:
    return this->open_socket(effect);
  case send_socket:
    return sockets_.send(effect);
  case close_socket:
    return sockets_.close(effect);
  case subscribe:
    return subscriptions_.add(effect);
  case unsubscribe:
    return subscriptions_.remove(effect);
  case load:
  case unload:
    return change_component(effect);
  default:
    return not_yet(effect);
  }
}

// A rollback runs because of an error. If it failed with an error of its own,
// that one would hide the first from the script.
std::optional<WaitOutcome> OutsideEffects::answered(QueryId id,
                                                    Expected<Value> outcome) {
  const auto found = queries_.find(id);
  if (found == queries_.end())
    return std::nullopt;
  const auto query = found->second;
  queries_.erase(found);
  if (query.rollback)
    outcome = Value();
  return WaitOutcome{query.wait, std::move(outcome)};
}

// -- databases ----------------------------------------------------------------

// One with a name is asked by it. One without is asked by all queries that name
// none, from now on; it may be written to by the activation that says so, so
// that no other writes unawares.
script::Performed
OutsideEffects::connect_database(script::Activation& activation, Call effect) {
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

// `named`: a connection, or a component, which is read only; unknown: the
// database of those without a name. The wait is noted before the port is
// called.
script::Performed OutsideEffects::ask_database(QueryRequest request,
                                               const Value& named) {
  const auto connection =
      named.is_unknown() ? connections_.end() : connections_.find(named.text());
  if (named.is_unknown()) {
    request.database = current_;
  } else if (connection != connections_.end()) {
    request.database = connection->second.component;
    request.write = connection->second.write;
  } else if (context_.port.reachable(named.text())) {
    request.database = named.text();
    request.write = false;
  } else {
    return missing("database", named);
  }
  request.id = context_.next_id();
  queries_[request.id] = {running_.begin_wait(WaitFor::answer),
                          request.kind == QueryRequest::Kind::rollback};
  context_.port.query(std::move(request));
  return script::Waits{};
}

script::Performed OutsideEffects::query_database(bool writes, Call effect) {
  QueryRequest request;
  request.write = writes;
  request.sql = effect.text(0);
  request.values = list_of(effect.operand(1));
  return ask_database(std::move(request), effect.operand(2));
}

// Begin, commit and rollback wait like a statement: the database may make them
// wait for other sessions.
script::Performed OutsideEffects::transaction(bool writes, Call effect,
                                              QueryRequest::Kind kind) {
  QueryRequest request;
  request.write = writes;
  request.kind = kind;
  return ask_database(std::move(request), effect.operand(0));
}

// -- files, sockets -----------------------------------------------------------

script::Performed OutsideEffects::file(FileRequest request) {
  const auto id = context_.next_id();
  const auto wait = running_.begin_wait(WaitFor::answer);
  queries_[id] = {wait, false};
  // A disk may hang: a share of the network, for one.
  const auto& settings = context_.program->settings.sessions;
  timers_.start(
      context_.in(settings.request_timeout),
      {.purpose = Timer::Purpose::wait, .wait = wait, .correlation = id});
  context_.port.file(id, std::move(request));
  return script::Waits{};
}

// No time-out: whoever keeps the components sees to it that one comes up or
// goes in time, and what was begun is not to end unheard.
script::Performed OutsideEffects::change_component(Call effect) {
  ComponentRequest request;
  request.id = context_.next_id();
  request.load = effect.kind == script::EffectKind::load;
  if (request.load)
    request.plugin = effect.text(0);
  request.name = text_or(effect.operand(request.load ? 1 : 0), "");
  queries_[request.id] = {running_.begin_wait(WaitFor::answer), false};
  context_.port.component(std::move(request));
  return script::Waits{};
}

script::Performed OutsideEffects::open_socket(Call effect) {
  if (auto may = sockets_.may_open(effect.text(0)); !may)
    return may.error();
  sockets_.open(effect, running_.begin_wait(WaitFor::answer));
  return script::Waits{};
}

// The port before may have carried out what it was asked for, or not: nothing
// is asked again that might be done twice.
std::vector<WaitOutcome> OutsideEffects::resume() {
  subscriptions_.resume();
  std::vector<WaitOutcome> lost;
  for (const auto& [id, query] : queries_)
    lost.push_back(query.rollback ? WaitOutcome{query.wait, Value()}
                                  : in_doubt(query.wait));
  return lost;
}

void OutsideEffects::forget(WaitId wait) {
  std::erase_if(queries_,
                [&](const auto& entry) { return entry.second.wait == wait; });
  sockets_.forget(wait);
}

} // namespace parlour::dialogue
