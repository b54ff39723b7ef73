// Statements that are no more than an effect, with operands in the order of
// effects.def.
#include "script/compiler/code/statements/effect_statements.hpp"

#include <array>

#include "script/source/by_name.hpp"

namespace parlour::script {

namespace {

// An attribute and how it is written.
struct OperandShape {
  const char* attribute = nullptr;
  OperandForm form = OperandForm::text;
};

// Effects that are no more than their operands: a row is all they need.
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

// <register>, <unregister> and <cancel> each make one of two effects.
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

} // namespace

void EffectStatements::effect(const Element& element) {
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

} // namespace parlour::script
