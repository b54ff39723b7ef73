// Compiles such elements:
//
//   <slot name="Time" type="Functional" question="When?">
//     <cardinality type="time"/>
//     <help><value>Say a time such as three pm.</value></help>
//     <nomatch count="2">…</nomatch>
//   </slot>

#include "script/compiler/slot_compiler.hpp"

#include <map>

#include <re2/re2.h>

#include "runtime/text/sql_check.hpp"
#include "script/xml/attribute_check.hpp"

namespace parlour::script {

namespace {

// Compiles one <slot>; the members follow its attributes and children.
class SlotCompiler {
public:
  SlotCompiler(const Element& element, Slot& slot, const BodyContext& context,
               Compilation& compilation)
      : element_(element), slot_(slot), context_(context),
        compilation_(compilation) {}

  void compile() {
    read_words();
    read_part();
    compile_texts();
    compile_bodies();
    if (const auto* cardinality = element_.child("cardinality"))
      compile_cardinality(*cardinality);
  }

private:
  void read_words();
  void read_part();
  void compile_texts();
  void compile_bodies();
  void compile_cardinality(const Element& cardinality);
  void check_values(const Element& cardinality);
  void check_pattern(const Attribute& pattern);
  void check_source(const Attribute& source);
  CodeId optional(const Element& element, const char* name);
  std::vector<CountedBody> counted(const char* name);

  const Element& element_;
  Slot& slot_;
  BodyContext context_;
  Compilation& compilation_;
};

// The topic that fills the slot, and what it has from the start.
void SlotCompiler::read_part() {
  const auto* part = element_.attribute("topic");
  if (part) {
    slot_.part = compilation_.program.topic(part->value);
    if (slot_.part == no_id)
      compilation_.findings.error(
          part->value_position,
          "there is no topic '" + part->value + "'" +
              did_you_mean(part->value, keys_of(compilation_.names.topics)));
  }
  const auto* with = element_.attribute("with");
  if (with && !part)
    compilation_.findings.error(with->position,
                                "'with' is for the topic that fills the slot; "
                                "name it by 'topic'");
  slot_.with = optional(element_, "with");
}

// Attributes that are words: type, private, confirm, match, grammar.
void SlotCompiler::read_words() {
  slot_.functional = element_.value("type") == "Functional";
  slot_.is_private = element_.value("private") == "true";
  slot_.commits = element_.value("commit") == "true";
  slot_.confirm = choice_of<ConfirmPolicy>(
      element_, "confirm", {"auto", "explicit", "implicit", "never"});
  slot_.match = match_of(element_);
  slot_.many = element_.value("many") == "true";
  if (const auto* more = element_.attribute("more"); more && !slot_.many)
    compilation_.findings.error(more->position,
                                "'more' is asked for further values; write "
                                "many=\"true\" as well");
  slot_.grammar = element_.value("grammar");
  check_grammar(element_, compilation_);
}

CodeId SlotCompiler::optional(const Element& element, const char* name) {
  const auto* attribute = element.attribute(name);
  return attribute ? compilation_.bodies.expression(*attribute, context_)
                   : no_code;
}

// The initial value, the question, its further wordings and explanations.
void SlotCompiler::compile_texts() {
  slot_.initial = optional(element_, "expr");
  slot_.condition = optional(element_, "if");
  slot_.offer = optional(element_, "offer");
  if (const auto* label = element_.attribute("label"))
    slot_.label = compilation_.bodies.text_or_expression(*label, context_);
  if (const auto* question = element_.attribute("question"))
    slot_.question =
        compilation_.bodies.text_or_expression(*question, context_);
  if (const auto* more = element_.attribute("more"))
    slot_.more = compilation_.bodies.text_or_expression(*more, context_);
  slot_.help = compile_values(element_.child("help"), context_, compilation_);
  slot_.explain =
      compile_values(element_.child("explain"), context_, compilation_);
}

// <noinput> and <nomatch>: one body for each count.
std::vector<CountedBody> SlotCompiler::counted(const char* name) {
  std::vector<CountedBody> bodies;
  std::map<std::uint64_t, std::uint32_t> lines;
  for (const auto& child : element_.children) {
    if (!child.is(name))
      continue;
    auto inside = context_;
    inside.name += " <" + child.name + ">";
    const auto count = parse_count(child.value("count")).value_or(1);
    const auto [first, is_first] = lines.emplace(count, child.position.line);
    if (!is_first)
      compilation_.findings.error(
          child.position,
          "a second <" + child.name + " count=\"" + std::to_string(count) +
              "\">, after the one in line " + std::to_string(first->second) +
              "; put both into one");
    bodies.push_back({static_cast<std::uint32_t>(count),
                      compilation_.bodies.body(child, inside)});
  }
  return bodies;
}

// What runs when a value is accepted, refused or ambiguous, and when nothing
// was said or understood.
void SlotCompiler::compile_bodies() {
  auto child = [&](const char* name) {
    return compile_child(element_, name, context_, compilation_);
  };
  slot_.filled = child("filled");
  slot_.invalid = child("invalid");
  slot_.ambiguous = child("ambiguous");
  slot_.no_input = counted("noinput");
  slot_.no_match = counted("nomatch");
}

// Only type="set" has values, and it must have some.
void SlotCompiler::check_values(const Element& cardinality) {
  const auto& values = cardinality.children;
  if (cardinality.value("type") == "set") {
    if (values.empty())
      compilation_.findings.error(
          cardinality.position,
          "<cardinality type=\"set\"> needs at least one <value>");
  } else if (!values.empty()) {
    compilation_.findings.error(values.front().position,
                                "<cardinality type=\"" +
                                    cardinality.value("type") +
                                    "\"> has no <value>; that belongs to "
                                    "type=\"set\"");
  }
}

// Compiled once here only to check it; matching compiles it again.
void SlotCompiler::check_pattern(const Attribute& pattern) {
  const re2::RE2 compiled(pattern.value, re2::RE2::Quiet);
  if (!compiled.ok())
    compilation_.findings.error(pattern.value_position,
                                "this is no regular expression: " +
                                    compiled.error());
}

void SlotCompiler::check_source(const Attribute& source) {
  if (!is_column_source(source.value))
    compilation_.findings.error(source.value_position,
                                "'" + source.value +
                                    "' is not a column; "
                                    "expected db:table.column");
}

// <cardinality>: the kind of values and its limits. Which attributes belong to
// which type was checked by the forms of the element table.
void SlotCompiler::compile_cardinality(const Element& cardinality) {
  auto& target = slot_.cardinality;
  target.type = cardinality.value("type");
  target.position = cardinality.position;
  check_values(cardinality);
  if (const auto* pattern = cardinality.attribute("pattern"))
    check_pattern(*pattern);
  if (const auto* source = cardinality.attribute("source"))
    check_source(*source);
  target.values = compile_values(&cardinality, context_, compilation_);
  target.minimum = optional(cardinality, "from");
  target.maximum = optional(cardinality, "to");
  target.pattern = cardinality.value("pattern");
  target.source = cardinality.value("source");
}

} // namespace

Match match_of(const Element& element) {
  return choice_of<Match>(element, "match", {"equal", "prefix", "contains"});
}

void compile_slot(const Element& element, Slot& slot,
                  const BodyContext& context, Compilation& compilation) {
  SlotCompiler(element, slot, context, compilation).compile();
}

} // namespace parlour::script
