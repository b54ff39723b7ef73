// The second pass over all documents. Each kind of declaration has a file of
// its own (topic_compiler, state_compiler …); here is the order in which they
// are called, and what has no file: variables, the ladder, the start.

#include "script/compiler/declaration_compiler.hpp"

#include "script/compiler/compilation.hpp"
#include "script/compiler/knowledge_compiler.hpp"
#include "script/compiler/name_collector.hpp"
#include "script/compiler/phrase_compiler.hpp"
#include "script/compiler/reaction_compiler.hpp"
#include "script/compiler/repair_compiler.hpp"
#include "script/compiler/route_compiler.hpp"
#include "script/compiler/seat_compiler.hpp"
#include "script/compiler/state_compiler.hpp"
#include "script/compiler/topic_compiler.hpp"
#include "script/compiler/understanding_builder.hpp"

namespace parlour::script {

namespace {

// The constructor runs the first pass (collect_names); compile() runs the
// second.
class DeclarationCompiler {
public:
  DeclarationCompiler(const std::vector<Document>& documents, Program& program,
                      Findings& findings)
      : documents_(documents), program_(program),
        collected_(collect_names(documents, program, findings)),
        bodies_(program, collected_.names, findings),
        compilation_{program, collected_.names, findings, bodies_, {}, {}} {}

  void compile(SettingsSource settings);

private:
  // Additional functions that the bodies of a document see. A library of the
  // platform keeps its own functions even if the application has one of the
  // same name.
  const FunctionNames* functions_of(std::size_t document) const {
    return documents_[document].platform ? &collected_.functions[document]
                                         : nullptr;
  }
  void prepare();
  void compile_document(std::size_t document);
  void compile_declaration(const Element& element,
                           const FunctionNames* functions);
  void compile_all_facts(const Element& holder, TopicId topic);
  void compile_variable(const Element& element);
  void compile_all_phrases();
  void compile_all_repairs();
  void compile_ladder(const Element& ladder);
  void check_start(const Element& settings);

  // The declaration that the first pass made of this element; null for a
  // duplicate, which has been reported.
  template <class T>
  T* declared(std::vector<T>& all, const Element& element) {
    for (auto& one : all)
      if (one.position == element.position)
        return &one;
    return nullptr;
  }

  const std::vector<Document>& documents_;
  Program& program_;
  Collected collected_;
  BodyCompiler bodies_;
  Compilation compilation_;
};

// What bodies and queries refer to must be complete before these are compiled:
// sources, events, grammars, facts and the reserved functions.
void DeclarationCompiler::prepare() {
  compilation_.sources = known_sources(program_);
  for (const auto& document : documents_) {
    add_names_made(document.root, compilation_.sources);
    add_events_raised(document.root, compilation_.raised);
    collect_grammars(document.root, compilation_.grammars,
                     compilation_.findings);
  }
  for (const auto& document : documents_)
    compile_all_facts(document.root, no_id);
  for (const auto& [name, function] : collected_.names.functions)
    program_.functions.emplace(name, function.code);
}

void DeclarationCompiler::compile_all_facts(const Element& holder,
                                            TopicId topic) {
  for (const auto& child : holder.children)
    if (child.is("facts"))
      compile_facts(child, topic, compilation_);
    else if (child.is("topic") && declared(program_.topics, child))
      compile_all_facts(child, program_.topic(child.value("name")));
}

// A duplicate is skipped: the first one has its initial value already.
void DeclarationCompiler::compile_variable(const Element& element) {
  const auto found = collected_.names.variables.find(element.value("name"));
  const auto* expression = element.attribute("expr");
  auto& variable = program_.variables[found->second];
  if (!expression || variable.initial != no_code)
    return;
  BodyContext context;
  context.name = "variable " + variable.name;
  variable.initial = bodies_.expression(*expression, context);
}

// Elements without code, such as <facts> and <include>, were dealt with before.
void DeclarationCompiler::compile_declaration(const Element& element,
                                              const FunctionNames* functions) {
  if (element.is("var") || element.is("const"))
    compile_variable(element);
  else if (element.is("routes"))
    compile_routes(element, compilation_);
  else if (element.is("handler")) {
    if (auto* handler = declared(program_.handlers, element))
      compile_handler(element, *handler, functions, compilation_);
  } else if (element.is("state")) {
    if (auto* state = declared(program_.states, element))
      compile_state(element, *state, functions, compilation_);
  } else if (element.is("topic")) {
    if (auto* topic = declared(program_.topics, element))
      compile_topic(element, *topic, functions, compilation_);
  }
}

// Functions first, as their bodies are the largest part of most scripts.
void DeclarationCompiler::compile_document(std::size_t document) {
  const auto& root = documents_[document].root;
  const auto* functions = functions_of(document);
  BodyContext context;
  context.functions = functions;
  compile_functions(root, collected_.functions[document], context,
                    compilation_);
  for (const auto& child : root.children)
    compile_declaration(child, functions);
}

// The application's phrases come first, as the first that applies is used.
void DeclarationCompiler::compile_all_phrases() {
  for (const bool platform : {false, true})
    for (std::size_t i = 0; i < documents_.size(); ++i)
      for (const auto& child : documents_[i].root.children)
        if (documents_[i].platform == platform && child.is("phrases")) {
          const auto first = program_.phrases.size();
          compile_phrases(child, functions_of(i), compilation_);
          for (auto at = first; at < program_.phrases.size(); ++at)
            program_.phrases[at].of_platform = platform;
        }
}

// In the same order as phrases, and for the same reason.
void DeclarationCompiler::compile_all_repairs() {
  for (const bool platform : {false, true})
    for (std::size_t i = 0; i < documents_.size(); ++i)
      for (const auto& child : documents_[i].root.children)
        if (documents_[i].platform == platform && child.is("repair"))
          compile_repair(child, platform, functions_of(i), compilation_);
}

// The steps of <ladder> in the settings (engine rule 5.10).
void DeclarationCompiler::compile_ladder(const Element& ladder) {
  BodyContext context;
  context.name = "ladder";
  for (const auto& step : ladder.children)
    program_.ladder.push_back(bodies_.body(step, context));
}

// `start` names a state or a topic; without it engine rule 4.6 decides.
void DeclarationCompiler::check_start(const Element& settings) {
  const auto* start = settings.attribute("start");
  const auto& names = collected_.names;
  if (!start || start->value.empty() || names.states.count(start->value) ||
      names.topics.count(start->value))
    return;
  auto known = keys_of(names.states);
  for (auto& topic : keys_of(names.topics))
    known.push_back(std::move(topic));
  compilation_.findings.error(start->value_position,
                              "there is no state or topic '" + start->value +
                                  "' to start with" +
                                  did_you_mean(start->value, known));
}

// The checks at the end need all bodies.
void DeclarationCompiler::compile(SettingsSource settings) {
  prepare();
  for (std::size_t i = 0; i < documents_.size(); ++i)
    compile_document(i);
  compile_all_phrases();
  compile_all_repairs();
  check_needs(compilation_);
  check_ways_out(compilation_);
  if (!settings.root)
    return;
  check_start(*settings.root);
  if (const auto* ladder = settings.root->child("ladder"))
    compile_ladder(*ladder);
  compile_seats(*settings.root, compilation_);
}

} // namespace

void compile_declarations(const std::vector<Document>& documents,
                          SettingsSource settings,
                          const ApplicationLoader& loader, Program& program,
                          Findings& findings) {
  DeclarationCompiler(documents, program, findings).compile(settings);
  program.understanding =
      build_understanding(documents, program, loader, findings);
}

} // namespace parlour::script
