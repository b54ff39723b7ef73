// The first pass. It makes an entry for each declaration, so that the second
// pass finds all names and can compare elements with entries by their
// positions.

#include "script/compiler/name_collector.hpp"

#include "script/expression/builtins.hpp"
#include "script/xml/attribute_check.hpp"

namespace parlour::script {

namespace {

std::string quoted(const std::string& name) {
  return "'" + name + "'";
}

// The message about a duplicate, with the place of the first declaration.
std::string there_already(const char* what, const std::string& name,
                          const SourceLocation& first,
                          const SourceLocation& second) {
  const auto slash = first.file.rfind('/') + 1; // npos + 1 is 0
  return std::string("there is a ") + what + " " + quoted(name) +
         " already, in line " + std::to_string(first.line) +
         (first.file == second.file ? "" : " of " + first.file.substr(slash));
}

// The parameters of a <function>. The body compiler checks them.
FunctionName signature_of(const Element& element) {
  FunctionName function;
  for (const auto& child : element.children) {
    if (!child.is("param"))
      continue;
    if (!child.attribute("expr"))
      ++function.required;
    function.parameter_names.push_back(child.value("name"));
    ++function.parameters;
  }
  function.position = element.position;
  return function;
}

class NameCollector {
public:
  NameCollector(Program& program, Findings& findings)
      : program_(program), findings_(findings) {}

  void collect(const Element& root);
  void add_functions(const FunctionNames& functions, bool platform);
  Names take() {
    return std::move(names_);
  }

private:
  void add_variable(const Element& element);
  void add_topic(const Element& element);
  template <class T>
  bool add(std::map<std::string, Position, std::less<>>& names,
           std::vector<T>& all, const Element& element, const char* what);

  Program& program_;
  Findings& findings_;
  Names names_;
  std::map<std::string, Position> variable_positions_;
};

// Adds an empty entry of this name, or reports a duplicate. `all` is a list of
// the program; `names` has where each name was declared.
template <class T>
bool NameCollector::add(std::map<std::string, Position, std::less<>>& names,
                        std::vector<T>& all, const Element& element,
                        const char* what) {
  const auto name = element.value("name");
  const auto [place, is_new] = names.emplace(name, element.position);
  if (!is_new) {
    findings_.error(element.position,
                    there_already(what, name, findings_.place(place->second),
                                  findings_.place(element.position)));
    return false;
  }
  T entry;
  entry.name = name;
  entry.position = element.position;
  all.push_back(std::move(entry));
  return true;
}

// Session variables get consecutive indices in the order of the files.
void NameCollector::add_variable(const Element& element) {
  const auto name = element.value("name");
  if (const auto fault = variable_fault(name); !fault.empty())
    findings_.error(element.position, fault);
  const auto index = static_cast<std::uint32_t>(program_.variables.size());
  if (!names_.variables.emplace(name, index).second)
    return findings_.error(
        element.position,
        there_already("variable", name,
                      findings_.place(variable_positions_[name]),
                      findings_.place(element.position)));
  variable_positions_[name] = element.position;
  Variable variable;
  variable.name = name;
  variable.is_constant = element.is("const");
  variable.is_private = element.value("private") == "true";
  program_.variables.push_back(std::move(variable));
}

// The slots are collected with their topic, so that other topics' queries and
// phrases can refer to them.
void NameCollector::add_topic(const Element& element) {
  if (!add(names_.topics, program_.topics, element, "topic"))
    return;
  auto& topic = program_.topics.back();
  std::map<std::string, Position, std::less<>> slots;
  for (const auto& child : element.children)
    if (child.is("slot"))
      add(slots, topic.slots, child, "slot");
}

// Everything that a document declares directly, except functions.
void NameCollector::collect(const Element& root) {
  for (const auto& child : root.children) {
    if (child.is("var") || child.is("const"))
      add_variable(child);
    else if (child.is("handler"))
      add(names_.handlers, program_.handlers, child, "handler");
    else if (child.is("state"))
      add(names_.states, program_.states, child, "state");
    else if (child.is("topic"))
      add_topic(child);
  }
}

// Documents of the platform are added last and yield silently.
void NameCollector::add_functions(const FunctionNames& functions,
                                  bool platform) {
  for (const auto& [name, function] : functions) {
    const auto [place, is_new] = names_.functions.emplace(name, function);
    if (!is_new && !platform)
      findings_.error(function.position,
                      there_already("function", name,
                                    findings_.place(place->second.position),
                                    findings_.place(function.position)));
  }
}

} // namespace

// Functions are added in a second round: the application's names must be known
// before the platform's are.
Collected collect_names(const std::vector<Document>& documents,
                        Program& program, Findings& findings) {
  NameCollector collector(program, findings);
  Collected collected;
  for (const auto& document : documents) {
    collector.collect(document.root);
    collected.functions.push_back(
        collect_functions(document.root, program, findings));
  }
  for (const bool platform : {false, true})
    for (std::size_t i = 0; i < documents.size(); ++i)
      if (documents[i].platform == platform)
        collector.add_functions(collected.functions[i], platform);
  collected.names = collector.take();
  return collected;
}

// A reserved Code is empty until the second pass fills it; calls refer to it by
// its index already.
FunctionNames collect_functions(const Element& holder, Program& program,
                                Findings& findings) {
  FunctionNames functions;
  for_each_function(holder, [&](const Element& element) {
    const auto name = element.value("name");
    if (is_builtin(name))
      return findings.error(element.position, "there is a built-in function " +
                                                  quoted(name) +
                                                  "; choose another name");
    const auto found = functions.find(name);
    if (found != functions.end())
      return findings.error(
          element.position,
          there_already("function", name,
                        findings.place(found->second.position),
                        findings.place(element.position)));
    auto function = signature_of(element);
    function.code = static_cast<CodeId>(program.code.size());
    program.code.emplace_back();
    functions.emplace(name, std::move(function));
  });
  return functions;
}

} // namespace parlour::script
