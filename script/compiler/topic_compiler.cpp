// Compiles such elements:
//
//   <topic name="Taxi">
//     <examples><value>I need a taxi at [three](Time)</value></examples>
//     <slot name="Time" …/>
//     <constraint cond="this.Time ge '06:00'" message="We open at six."/>
//     <filled><confirm question="A taxi at {this.Time}?"/></filled>
//     <completed>…</completed>
//   </topic>

#include "script/compiler/topic_compiler.hpp"

#include <algorithm>
#include <functional>

#include "script/compiler/knowledge_compiler.hpp"
#include "script/compiler/slot_compiler.hpp"
#include "script/compiler/state_compiler.hpp"

namespace parlour::script {

namespace {

// Whether an element of this name is anywhere below.
bool holds(const Element& element, std::string_view name) {
  return std::any_of(element.children.begin(), element.children.end(),
                     [&](const Element& child) {
                       return child.is(name) || holds(child, name);
                     });
}

// Compiles one <topic>. Its bodies see its slots by `this`.
class TopicCompiler {
public:
  TopicCompiler(const Element& element, Topic& topic, Compilation& compilation)
      : element_(element), topic_(topic), compilation_(compilation) {
    context_.topic = &topic;
    context_.name = "topic " + topic.name;
  }

  void compile(const FunctionNames* functions);

private:
  void read_words();
  void read_summary();
  void compile_children();
  void compile_child_of(const Element& child);
  void compile_own_slot(const Element& element);
  void add_constraint(const Element& element);
  void add_rule(const Element& element);
  void compile_bodies();
  CodeId summarised_body();
  void check_examples(const Element& examples);
  void check_marks(const Element& example);
  void warn_of_enquiry();
  void warn(Position position, const char* lint, std::string message);

  const Element& element_;
  Topic& topic_;
  Compilation& compilation_;
  BodyContext context_;
};

// The attributes that are words: kind, initiative, resume, needs.
void TopicCompiler::read_words() {
  topic_.kind = choice_of<TopicKind>(element_, "kind", {"task", "enquiry"});
  topic_.initiative = Initiative::mixed;
  if (element_.attribute("initiative"))
    topic_.initiative = choice_of<Initiative>(element_, "initiative",
                                              {"user", "system", "mixed"});
  topic_.resume =
      choice_of<ResumePolicy>(element_, "resume", {"always", "ask", "never"});
  topic_.is_part = element_.value("part") == "true";
  read_summary();
  topic_.needs = split_names(element_.value("needs"));
  for (const auto& need : topic_.needs)
    if (!compilation_.names.topics.count(need))
      compilation_.findings.error(
          element_.attribute("needs")->value_position,
          "there is no topic '" + need + "'" +
              did_you_mean(need, keys_of(compilation_.names.topics)));
}

// confirm="summary", or commit="true" where certain words are enough. Only a
// task is done, so only a task is confirmed.
void TopicCompiler::read_summary() {
  if (element_.value("confirm") == "summary")
    topic_.summary = Summary::always;
  else if (element_.value("commit") == "true")
    topic_.summary = Summary::unless_certain;
  if (const auto* label = element_.attribute("label"))
    topic_.label = compilation_.bodies.text_or_expression(*label, context_);
  const bool summarises = topic_.summary != Summary::never;
  if (summarises && topic_.kind == TopicKind::enquiry)
    compilation_.findings.error(element_.position,
                                "an enquiry is answered and does nothing that "
                                "could be confirmed; leave out 'confirm' and "
                                "'commit', or kind=\"enquiry\"");
  if (const auto* refused = element_.child("refused"); refused && !summarises)
    compilation_.findings.error(refused->position,
                                "<refused> runs after a no to the summary; "
                                "write confirm=\"summary\" or "
                                "commit=\"true\" on the topic");
}

// The slot exists already, with its name; the element fills it.
void TopicCompiler::compile_own_slot(const Element& element) {
  const auto id = topic_.slot(element.value("name"));
  if (id == no_id || topic_.slots[id].position != element.position)
    return; // a duplicate, reported before
  auto inside = context_;
  inside.name += "." + topic_.slots[id].name;
  compile_slot(element, topic_.slots[id], inside, compilation_);
}

// A <constraint>: a condition, and what is said if it does not hold.
void TopicCompiler::add_constraint(const Element& element) {
  auto& bodies = compilation_.bodies;
  Constraint constraint;
  constraint.condition =
      bodies.expression(*element.attribute("cond"), context_);
  constraint.message =
      bodies.text_or_expression(*element.attribute("message"), context_);
  constraint.position = element.position;
  topic_.constraints.push_back(constraint);
}

// A <rule> runs when slots change and its condition holds.
void TopicCompiler::add_rule(const Element& element) {
  Rule rule;
  rule.condition =
      compilation_.bodies.expression(*element.attribute("if"), context_);
  auto inside = context_;
  inside.name += " <rule>";
  rule.body = compilation_.bodies.body(element, inside);
  rule.position = element.position;
  topic_.rules.push_back(rule);
}

// The marks [words](Slot) of an example must name slots of the topic.
void TopicCompiler::check_marks(const Element& example) {
  const auto& text = example.text;
  const auto known = names_of(topic_.slots);
  if (const auto brace = text.find('{'); brace != std::string::npos)
    compilation_.findings.add({Severity::error,
                               {example.text_position, brace, 1, true},
                               "an example is what people say, and nothing is "
                               "embedded in it; the words of a slot are marked "
                               "as [words](Slot)",
                               "expression"});
  for (auto at = text.find("]("); at != std::string::npos;
       at = text.find("](", at + 2)) {
    const auto end = std::min(text.find(')', at), text.size());
    const auto name = text.substr(at + 2, end - at - 2);
    if (std::find(known.begin(), known.end(), name) == known.end())
      compilation_.findings.error(example.text_position,
                                  "topic '" + topic_.name + "' has no slot '" +
                                      name + "'" + did_you_mean(name, known));
  }
}

// Examples are for understanding and never run, so they must be literal.
void TopicCompiler::check_examples(const Element& examples) {
  for (const auto& example : examples.children) {
    if (example.attribute("expr"))
      compilation_.findings.error(example.position,
                                  "an example is text; it cannot be computed");
    check_marks(example);
  }
}

void TopicCompiler::compile_child_of(const Element& child) {
  if (child.is("slot"))
    compile_own_slot(child);
  else if (child.is("constraint"))
    add_constraint(child);
  else if (child.is("rule"))
    add_rule(child);
  else if (child.is("query"))
    compile_query(child, topic_, compilation_);
  else if (child.is("examples"))
    check_examples(child);
}

// What runs when the topic's status changes.
void TopicCompiler::compile_bodies() {
  auto body = [&](const char* name) {
    return compile_child(element_, name, context_, compilation_);
  };
  topic_.started = body("started");
  topic_.suspended = body("suspended");
  topic_.resumed = body("resumed");
  topic_.filled =
      topic_.summary == Summary::never ? body("filled") : summarised_body();
  topic_.completed = body("completed");
  topic_.cancelled = body("cancelled");
}

// The summary comes before the topic's own <filled>.
CodeId TopicCompiler::summarised_body() {
  auto inside = context_;
  inside.name += " <filled>";
  return compilation_.bodies.after_summary(
      element_, topic_.summary == Summary::unless_certain, inside);
}

// The topic's functions come first, as all its other parts may call them.
void TopicCompiler::compile(const FunctionNames* functions) {
  const auto local = local_functions(element_, functions, compilation_);
  context_.functions = &local;
  compile_functions(element_, local, context_, compilation_);
  read_words();
  for (const auto& child : element_.children)
    compile_child_of(child);
  compile_bodies();
  warn_of_enquiry();
}

// Warns of an enquiry that nothing answers, and of a <completed> that never
// runs (language rule 12.22).
void TopicCompiler::warn_of_enquiry() {
  if (topic_.kind != TopicKind::enquiry)
    return;
  if (topic_.queries.empty() && topic_.filled == no_code)
    warn(topic_.position, "unanswered-enquiry",
         "the enquiry '" + topic_.name +
             "' has no <query> and no <filled>: nothing answers it");
  const auto* completed = element_.child("completed");
  if (completed && !holds(element_, "complete"))
    warn(completed->position, "uncompleted-enquiry",
         "an enquiry is answered and never completed: this never runs; write "
         "<filled>, which runs with each answer, or leave out "
         "kind=\"enquiry\"");
}

void TopicCompiler::warn(Position position, const char* lint,
                         std::string message) {
  compilation_.findings.add(
      {Severity::warning, {position}, std::move(message), lint});
}

} // namespace

void compile_topic(const Element& element, Topic& topic,
                   const FunctionNames* functions, Compilation& compilation) {
  TopicCompiler(element, topic, compilation).compile(functions);
}

// A depth-first search: a topic that is reached again while it is open is part
// of a ring.
void check_needs(Compilation& compilation) {
  const auto& program = compilation.program;
  // `open` marks the topics on the current path.
  enum class Mark { fresh, open, done };
  std::vector<Mark> marks(program.topics.size(), Mark::fresh);
  const std::function<void(TopicId)> visit = [&](TopicId id) {
    if (id >= marks.size() || marks[id] == Mark::done)
      return;
    if (marks[id] == Mark::open)
      return compilation.findings.error(
          program.topics[id].position,
          "topic '" + program.topics[id].name + "' needs itself, by its " +
              (program.topics[id].needs.empty() ? "slot's 'topic'"
                                                : "'needs'"));
    marks[id] = Mark::open;
    for (const auto& need : program.topics[id].needs)
      visit(program.topic(need));
    for (const auto& slot : program.topics[id].slots)
      visit(slot.part);
    marks[id] = Mark::done;
  };
  for (TopicId id = 0; id < marks.size(); ++id)
    visit(id);
}

} // namespace parlour::script
