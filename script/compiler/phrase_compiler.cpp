// Compiles such elements:
//
//   <phrase act="confirm" topic="Taxi" if="data.value">A taxi at
//     {data.value}?</phrase>
//
// into code with the parameters act, topic, slot and data.

#include "script/compiler/phrase_compiler.hpp"

#include <algorithm>

#include "script/expression/brace_mistakes.hpp"
#include "script/expression/plain_brace.hpp"

namespace parlour::script {

namespace {

const std::vector<std::string> parameters{"act", "topic", "slot", "data"};

// An application may have acts of its own, so only a similar name is a mistake.
void check_act(const Attribute& act, Findings& findings) {
  const auto& known = say_acts();
  if (std::find(known.begin(), known.end(), act.value) != known.end())
    return;
  const auto hint = did_you_mean(act.value, known);
  if (!hint.empty())
    findings.add({Severity::warning,
                  {act.value_position},
                  "the engine says no act '" + act.value + "'" + hint,
                  "unknown-act"});
}

void check_topic(const Element& phrase, const Compilation& compilation) {
  const auto* name = phrase.attribute("topic");
  const auto& topics = compilation.names.topics;
  if (name && !topics.count(name->value))
    compilation.findings.error(name->value_position,
                               "there is no topic '" + name->value + "'" +
                                   did_you_mean(name->value, keys_of(topics)));
}

// Without a topic any topic's slot will do. An unknown topic was reported
// before.
void check_slot_of_any(const Attribute& name, const Element& phrase,
                       const Compilation& compilation) {
  std::vector<std::string> known;
  for (const auto& topic : compilation.program.topics)
    for (const auto& slot : topic.slots)
      known.push_back(slot.name);
  if (phrase.attribute("topic") || known.empty() ||
      std::find(known.begin(), known.end(), name.value) != known.end())
    return;
  compilation.findings.error(name.value_position,
                             "no topic has a slot '" + name.value + "'" +
                                 did_you_mean(name.value, known));
}

// With a topic the slot must be one of that topic.
void check_slot(const Element& phrase, const Compilation& compilation) {
  const auto* name = phrase.attribute("slot");
  const auto topic = compilation.program.topic(phrase.value("topic"));
  if (!name)
    return;
  if (topic == no_id)
    return check_slot_of_any(*name, phrase, compilation);
  const auto known = names_of(compilation.program.topics[topic].slots);
  if (std::find(known.begin(), known.end(), name->value) == known.end())
    compilation.findings.error(name->value_position,
                               "topic '" + phrase.value("topic") +
                                   "' has no slot '" + name->value + "'" +
                                   did_you_mean(name->value, known));
}

// Such braces are text elsewhere (language rule 4.4), but a phrase would be
// spoken with them (language rule 12.7).
void check_braces(const Element& phrase, std::string_view text,
                  const Names& names, Findings& findings) {
  const auto at = plain_brace(text);
  if (at == std::string_view::npos)
    return;
  const KnownNames known{
      [&](const auto& name) {
        return std::ranges::count(parameters, name) > 0 ||
               names.variables.count(name) > 0;
      },
      [&](const auto& name) { return names.functions.count(name) > 0; }};
  const auto mistake =
      text[at] == '{' ? explain_brace(text, at, known, true) : std::nullopt;
  findings.add(
      {Severity::error,
       {phrase.text_position, at, mistake ? mistake->length : 1, true},
       mistake ? "this brace would be said aloud, as what is inside is no "
                 "expression: " +
                     mistake->message
               : "this brace would be said aloud, as it embeds no expression; "
                 "for a brace that is said write '{{' or '}}'",
       "expression"});
}

} // namespace

const std::vector<std::string>& say_acts() {
  static const std::vector<std::string> acts = {
#define X(name, sentence) #name,
      PARLOUR_SAY_ACTS(X)
#undef X
  };
  return acts;
}

void compile_phrases(const Element& phrases, const FunctionNames* functions,
                     Compilation& compilation) {
  const auto names = without_variables(compilation);
  BodyCompiler bodies(compilation.program, names, compilation.findings);
  for (const auto& element : phrases.children) {
    check_act(*element.attribute("act"), compilation.findings);
    check_topic(element, compilation);
    check_slot(element, compilation);
    BodyContext context;
    context.functions = functions;
    context.name = "phrase " + element.value("act");
    Phrase phrase;
    phrase.act = element.value("act");
    phrase.topic = element.value("topic");
    phrase.slot = element.value("slot");
    if (const auto* condition = element.attribute("if"))
      phrase.condition = bodies.expression(*condition, context, parameters);
    const auto words = collapsed(element.text);
    check_braces(element, words, names, compilation.findings);
    phrase.text =
        bodies.text(words, element.text_position, context, parameters);
    phrase.position = element.position;
    compilation.program.phrases.push_back(std::move(phrase));
  }
}

} // namespace parlour::script
