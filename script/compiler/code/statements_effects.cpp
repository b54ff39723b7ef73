// Statements that leave the script: each becomes an Effect whose operands
// stand as effects.def lists them.
#include <array>

#include "runtime/base/clock.hpp"
#include "runtime/base/roles.hpp"
#include "script/compiler/code/statements.hpp"

namespace parlour::script {

namespace {

struct OperandShape {
  const char* attribute = nullptr;
  OperandForm form = OperandForm::text;
};

// Those that are no more than their operands.
struct PlainEffect {
  EffectKind kind;
  std::array<OperandShape, 4> operands = {};
};

using F = OperandForm;
using K = EffectKind;

const ByName<PlainEffect>& plain_effects() {
  static const ByName<PlainEffect> effects{
      {"speak", {K::speak, {{{"param", F::either}, {"interrupt", F::value}}}}},
      {"send",
       {K::send,
        {{{"agent", F::text}, {"command", F::text}, {"param", F::params}}}}},
      {"load", {K::load, {{{"plugin", F::text}, {"name", F::new_source}}}}},
      {"unload", {K::unload, {{{"name", F::text}}}}},
      {"reload", {K::reload, {{{"sessions", F::text}}}}},
      {"subscribe",
       {K::subscribe, {{{"source", F::source}, {"command", F::text}}}}},
      {"unsubscribe",
       {K::unsubscribe, {{{"source", F::text}, {"command", F::text}}}}},
      {"say",
       {K::say,
        {{{"act", F::text},
          {"topic", F::topic},
          {"slot", F::text},
          {"data", F::value}}}}},
      {"repeat", {K::repeat}},
      {"restart", {K::restart}},
      {"consume", {K::consume}},
      {"end", {K::end}},
      {"push", {K::push, {{{"state", F::state}}}}},
      {"pop", {K::pop}},
      {"activate", {K::activate, {{{"topic", F::topic}, {"keep", F::value}}}}},
      {"reset", {K::reset_topic, {{{"topic", F::topic}}}}},
      {"complete", {K::complete}},
      {"ask", {K::ask, {{{"slot", F::slot}, {"wording", F::text}}}}},
      {"clear", {K::clear, {{{"slot", F::slot}}}}},
      {"cancel", {K::cancel, {{{"timer", F::text}}}}},
      {"wait", {K::wait, {{{"for", F::duration}}}}},
      {"connectdb",
       {K::connectdb,
        {{{"name", F::text}, {"param", F::either}, {"write", F::value}}}}},
      {"readfile", {K::read_file, {{{"name", F::text}}}}},
      {"writefile",
       {K::write_file, {{{"name", F::text}, {"param", F::either}}}}},
      {"appendfile",
       {K::append_file, {{{"name", F::text}, {"param", F::either}}}}},
      {"deletefile", {K::delete_file, {{{"name", F::text}}}}},
      {"listfiles", {K::list_files, {{{"name", F::text}}}}},
      {"socket",
       {K::open_socket,
        {{{"name", F::new_source},
          {"connect", F::text},
          {"lines", F::value}}}}},
      {"sendsocket",
       {K::send_socket, {{{"name", F::text}, {"param", F::either}}}}},
      {"closesocket", {K::close_socket, {{{"name", F::text}}}}},
      {"log", {K::log, {{{"param", F::either}, {"level", F::text}}}}},
      {"print", {K::print, {{{"param", F::either}}}}},
  };
  return effects;
}

const PlainEffect* plain_effect(const Element& element) {
  static const PlainEffect add_handler{K::register_handler,
                                       {{{"handler", F::handler}}}};
  static const PlainEffect add_topic{K::register_topic,
                                     {{{"topic", F::topic}}}};
  static const PlainEffect drop_handler{K::unregister_handler,
                                        {{{"handler", F::handler}}}};
  static const PlainEffect drop_topic{K::unregister_topic,
                                      {{{"topic", F::topic}}}};
  static const PlainEffect cancel_topic{
      K::cancel_topic, {{{"topic", F::topic}, {"all", F::value}}}};
  if (element.is("cancel") && !element.attribute("timer"))
    return &cancel_topic;
  const bool of_topic = element.attribute("topic");
  if (element.is("register"))
    return of_topic ? &add_topic : &add_handler;
  if (element.is("unregister"))
    return of_topic ? &drop_topic : &drop_handler;
  const auto there = plain_effects().find(element.name);
  return there == plain_effects().end() ? nullptr : &there->second;
}

bool means_own_topic(const PlainEffect& effect, const Element& element) {
  return effect.kind == K::complete ||
         (effect.kind == K::reset_topic && !element.attribute("topic"));
}

bool is_computed(const std::string& text) {
  return text.find('{') != std::string::npos;
}

std::vector<std::string> keys(const auto& map) {
  std::vector<std::string> all;
  for (const auto& [name, value] : map)
    all.push_back(name);
  return all;
}

bool mentioned(const std::string& name, const Element& element) {
  for (const auto& attribute : element.attributes)
    if (attribute.value.find(name) != std::string::npos)
      return true;
  for (const auto& child : element.children)
    if (mentioned(name, child))
      return true;
  return false;
}

} // namespace

void StatementCompiler::perform(EffectKind kind, Register result, Register base,
                                std::size_t operands, EffectShape others) {
  others.kind = static_cast<std::uint8_t>(kind);
  others.operands = static_cast<std::uint16_t>(operands);
  b_.emit(Operation::effect, result, base, b_.shape(others));
}

void StatementCompiler::effect(const Element& element) {
  const auto* plain = plain_effect(element);
  if (!plain)
    return error(element.position, "<" + element.name + "> is not a statement");
  if (means_own_topic(*plain, element) && !b_.context.topic)
    return error(element.position,
                 "<" + element.name + "> has a meaning in a topic only");
  std::size_t count = 0;
  while (count < plain->operands.size() && plain->operands[count].attribute)
    ++count;
  const auto base = b_.allocate(count + 1);
  for (std::size_t i = 0; i < count; ++i)
    operand(element, plain->operands[i].attribute, plain->operands[i].form,
            static_cast<Register>(base + i));
  b_.at(element.position);
  const auto& first = plain->operands.front();
  const auto* name =
      first.attribute ? element.attribute(first.attribute) : nullptr;
  perform(plain->kind, base, base, count,
          {.target = meaning(name, first.form)});
  store_result(element.attribute("return"), base);
}

void StatementCompiler::operand(const Element& element, const char* attribute,
                                OperandForm form, Register target) {
  if (form == OperandForm::params)
    return params(element, target, false);
  const auto* given = element.attribute(attribute);
  if (!given)
    return b_.load(target, Box());
  const auto source = source_of(*given);
  switch (form) {
  case OperandForm::either:
    return expressions_.text_or_expression(source, target);
  case OperandForm::value:
    return expressions_.expression(source, target);
  case OperandForm::duration:
    return duration(*given, target);
  case OperandForm::text:
    return expressions_.text(source, target);
  default:
    return checked_name(*given, form, target);
  }
}

void StatementCompiler::duration(const Attribute& attribute, Register target) {
  if (is_computed(attribute.value)) {
    expressions_.text(source_of(attribute), target);
    b_.emit(Operation::milliseconds, target, target);
    return;
  }
  const auto parsed = parse_duration(attribute.value);
  if (!parsed)
    return error(attribute.value_position, parsed.error().message);
  b_.load(target, b_.program.pool->integer(parsed->count()));
}

// Names of states, topics, handlers and slots are literal and checked here,
// unless they are computed (language rules 7.8 and 12.1).
void StatementCompiler::checked_name(const Attribute& attribute,
                                     OperandForm form, Register target) {
  expressions_.text(source_of(attribute), target);
  const auto& name = attribute.value;
  if (is_computed(name))
    return;
  if (form == OperandForm::source)
    return check_source(attribute);
  if (form == OperandForm::new_source)
    return check_new_source(attribute);
  std::vector<std::string> known;
  const char* what = "slot";
  if (form == OperandForm::slot) {
    if (!b_.context.topic)
      return error(attribute.position, "a slot has a meaning in a topic only");
    for (const auto& slot : b_.context.topic->slots)
      known.push_back(slot.name);
  } else if (form == OperandForm::state) {
    what = "state";
    known = keys(b_.names.states);
  } else if (form == OperandForm::topic) {
    what = "topic";
    known = keys(b_.names.topics);
  } else {
    what = "handler";
    known = keys(b_.names.handlers);
  }
  for (const auto& each : known)
    if (each == name)
      return;
  error(attribute.value_position, std::string("there is no ") + what + " '" +
                                      name + "'" + did_you_mean(name, known));
}

// The platform's own events need no <subscribe>.
void StatementCompiler::check_source(const Attribute& attribute) {
  const auto* role = find_role(attribute.value);
  if (role && role->reserved)
    error(attribute.value_position,
          "events of '" + role->name +
              "' come without <subscribe> to whoever takes them in <messages>");
}

void StatementCompiler::check_new_source(const Attribute& attribute) {
  if (auto fault = wrong_source_name(attribute.value); !fault.empty())
    error(attribute.value_position, std::move(fault));
}

// What a name that stands in the script is found by when it comes to that.
std::uint32_t StatementCompiler::meaning(const Attribute* name,
                                         OperandForm form) const {
  if (!name || is_computed(name->value))
    return no_id;
  switch (form) {
  case OperandForm::state:
    return b_.program.state(name->value);
  case OperandForm::topic:
    return b_.program.topic(name->value);
  default:
    return no_id;
  }
}

// -- messages -----------------------------------------------------------------

// `param=""` is none; without any, a <post> forwards those of the message.
void StatementCompiler::params(const Element& element, Register target,
                               bool forwards) {
  std::vector<const Attribute*> given;
  for (const auto& child : element.children)
    if (child.is("param"))
      given.push_back(child.attribute("expr"));
  const auto* single = element.attribute("param");
  if (given.empty() && !single && forwards) {
    b_.emit(Operation::load_message_parameters, target);
    return;
  }
  const bool has_single = single && !single->value.empty();
  const auto count = given.size() + has_single;
  const auto base = b_.allocate(count);
  if (has_single)
    expressions_.text_or_expression(source_of(*single), base);
  for (std::size_t i = 0; i < given.size(); ++i)
    if (given[i])
      expressions_.expression(source_of(*given[i]),
                              static_cast<Register>(base + has_single + i));
  b_.emit(Operation::new_list, target, base, count);
  b_.release(base);
}

void StatementCompiler::post(const Element& element) {
  const auto base = b_.allocate(4);
  operand(element, "module", F::text, base);
  operand(element, "command", F::text, static_cast<Register>(base + 1));
  params(element, static_cast<Register>(base + 2), true);
  operand(element, "to-session", F::text, static_cast<Register>(base + 3));
  b_.at(element.position);
  perform(K::post, base, base, 4);
  b_.release(base);
}

void StatementCompiler::request(const Element& element) {
  const auto from = b_.here();
  const auto base = b_.allocate(4);
  operand(element, "module", F::text, base);
  operand(element, "command", F::text, static_cast<Register>(base + 1));
  params(element, static_cast<Register>(base + 2), false);
  operand(element, "timeout", F::duration, static_cast<Register>(base + 3));
  b_.at(element.position);
  perform(K::request, base, base, 4);
  store_result(element.attribute("return"), base);
  if (const auto* handler = element.child("catch"))
    catch_errors(from, handler);
}

void StatementCompiler::fire(const Element& element) {
  const auto base = b_.allocate(2);
  if (element.attribute("event")) {
    operand(element, "event", F::text, base);
    params(element, static_cast<Register>(base + 1), false);
    b_.at(element.position);
    perform(K::fire_event, base, base, 2);
  } else {
    operand(element, "param", F::either, base);
    b_.at(element.position);
    perform(K::fire_frames, base, base, 1);
  }
  b_.release(base);
}

// -- bodies that run elsewhere
// --------------------------------------------------

// The element's statements as code of their own; the visible locals that they
// mention become its parameters.
CodeId StatementCompiler::detached(const Element& element, bool in_timer,
                                   std::vector<const Local*>& captured) {
  for (const auto& local : b_.locals())
    if (!local.name.starts_with(' ') &&
        b_.find(local.name).local == &local // not hidden
        && mentioned(local.name, element))
      captured.push_back(&local);
  auto context = b_.context;
  context.in_timer |= in_timer;
  context.name = (in_timer ? "timer in " : "transit in ") + b_.code.name;
  CodeBuilder builder(b_.program, b_.names, b_.findings, context);
  builder.at(element.position);
  for (const auto* local : captured) {
    builder.adopt(local->name, local->is_constant);
    builder.code.parameter_names.push_back(local->name);
  }
  builder.code.parameter_count = static_cast<std::uint16_t>(captured.size());
  StatementCompiler(builder).block(element);
  b_.program.code.push_back(builder.finish());
  return static_cast<CodeId>(b_.program.code.size() - 1);
}

// Copies the captured locals behind an effect's operands.
Register StatementCompiler::capture(const std::vector<const Local*>& captured) {
  const auto base = b_.allocate(captured.size());
  for (std::size_t i = 0; i < captured.size(); ++i)
    b_.emit(Operation::load_parameter, base + i, captured[i]->reg);
  return base;
}

void StatementCompiler::timer(const Element& element) {
  const auto base = b_.allocate(5);
  operand(element, "name", F::text, base);
  operand(element, "after", F::duration, static_cast<Register>(base + 1));
  operand(element, "repeat", F::value, static_cast<Register>(base + 2));
  operand(element, "keeps-open", F::value, static_cast<Register>(base + 3));
  operand(element, "ends-with", F::text, static_cast<Register>(base + 4));
  std::vector<const Local*> captured;
  const auto body = detached(element, true, captured);
  capture(captured);
  b_.at(element.position);
  perform(
      K::timer, base, base, 5,
      {.body = body, .captured = static_cast<std::uint16_t>(captured.size())});
  b_.release(base);
}

void StatementCompiler::transit(const Element& element) {
  const auto base = b_.allocate();
  operand(element, "state", F::state, base);
  std::vector<const Local*> captured;
  const auto body =
      element.children.empty() ? no_code : detached(element, false, captured);
  capture(captured);
  b_.at(element.position);
  perform(K::transit, base, base, 1,
          {.body = body,
           .captured = static_cast<std::uint16_t>(captured.size()),
           .target = meaning(element.attribute("state"), F::state)});
  b_.release(base);
}

} // namespace parlour::script
