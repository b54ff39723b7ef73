// Puts the source together, from the inside out: types and calls, handlers, the
// class, the file. clang-format is not needed: lines are wrapped here.
#include "tools/parlour/plugin_template/plugin_source.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include "runtime/plugin/parameters.hpp"
#include "runtime/text/words.hpp"

namespace parlour::tools {

namespace {

// Roles with an adaptor class of their own in runtime/plugin/adaptors.hpp.
constexpr std::array tailored = {"Microphone", "VAD", "ASR",      "TTS",
                                 "NLU",        "NLG", "Database", "Knowledge"};

bool is_tailored(const Role& role) {
  return std::ranges::find(tailored, role.name) != tailored.end();
}

constexpr std::size_t line_length = 80;

// `head`, the items separated by commas, and `tail`. Items that do not fit in
// 80 columns continue on the next line, below the first item.
std::string wrapped(const std::string& head,
                    const std::vector<std::string>& items,
                    const std::string& tail) {
  auto text = head;
  auto used = head.size();
  for (const auto& item : items) {
    const bool is_last = &item == &items.back();
    const auto piece = item + (is_last ? tail : ",");
    const auto blank = text == head ? 0u : 1u;
    if (used + blank + piece.size() <= line_length) {
      text += (blank ? " " : "") + piece;
      used += blank + piece.size();
    } else {
      text += '\n' + std::string(head.size(), ' ') + piece;
      used = head.size() + piece.size();
    }
  }
  return items.empty() ? text + tail : text;
}

// The sentence as a comment, wrapped to 80 columns.
std::string comment(const std::string& sentence) {
  std::string text = "//";
  auto used = text.size();
  for (const auto& word : split_words(sentence)) {
    if (used + 1 + word.size() > line_length) {
      text += "\n//";
      used = 2;
    }
    text += ' ' + word;
    used += 1 + word.size();
  }
  return text + '\n';
}

// How a kind of parameter is written in C++.
struct Type {
  const char* passed;  // as a handler's parameter
  const char* held;    // as a value type
  const char* nothing; // some value of it
};

Type type_of(ParameterKind kind) {
  switch (kind) {
  case ParameterKind::text:
    return {"const std::string&", "std::string", "\"\""};
  case ParameterKind::integer:
    return {"std::int64_t", "std::int64_t", "0"};
  case ParameterKind::number:
    return {"double", "double", "0.5"};
  case ParameterKind::boolean:
    return {"bool", "bool", "false"};
  case ParameterKind::list:
    return {"const parlour::List&", "parlour::List", "parlour::List{}"};
  case ParameterKind::map:
    return {"const parlour::Map&", "parlour::Map", "parlour::Map{}"};
  case ParameterKind::audio:
    return {"const parlour::Binary&", "parlour::Binary", "parlour::Binary{}"};
  case ParameterKind::rows:
    return {"const parlour::ResultSet&", "parlour::ResultSet",
            "parlour::ResultSet{}"};
  case ParameterKind::value:
    break;
  }
  return {"const parlour::Value&", "parlour::Value", "parlour::Value{}"};
}

// The C++ name of a parameter: "text or act" becomes "text".
std::string identifier(const std::string& parameter) {
  return parameter.substr(0, parameter.find(' '));
}

// The event that answers a command: of those that end a request, the one with
// the longest common prefix with the command's name (Stopped for stop_mic,
// Grasped for Grasp), otherwise the role's first. Null if the role has none.
// `alike` is the length of the longest prefix found so far.
const RoleEvent* answer_to(const RoleCommand& command, const Role& role) {
  const RoleEvent* best = nullptr;
  std::ptrdiff_t alike = -1;
  for (const auto& event : role.events) {
    if (event.reply != Reply::answer)
      continue;
    const auto end = std::ranges::mismatch(
        command.name, event.name, [](unsigned char one, unsigned char other) {
          return std::tolower(one) == std::tolower(other);
        });
    const auto same = end.in1 - command.name.begin();
    if (same > alike) {
      best = &event;
      alike = same;
    }
  }
  return best;
}

// Whether the event has a required parameter of the same name, so that the
// command's value can be passed on.
bool repeats(const RoleEvent& event, const Parameter& given) {
  return !given.optional &&
         std::ranges::any_of(read_parameters(event.parameters),
                             [&](const Parameter& said) {
                               return said.name == given.name && !said.optional;
                             });
}

// The call that fires an event, up to its arguments: the adaptor's function for
// a role with an adaptor, otherwise fire_event.
std::string firing(const RoleEvent& event, const Role& role) {
  if (!is_tailored(role))
    return "fire_event(\"" + event.name + "\", {";
  return "fire_" +
         (event.name == "RecognitionResult" ? "result"
                                            : snake_case(event.name)) +
         '(';
}

// The whole statement that fires the event. Parameters that the command does
// not give get some value of their type.
std::string fired(const RoleEvent& event, const Role& role,
                  const std::vector<Parameter>& given) {
  std::vector<std::string> params;
  for (const auto& parameter : read_parameters(event.parameters)) {
    const bool has = std::ranges::any_of(given, [&](const Parameter& one) {
      return one.name == parameter.name && repeats(event, one);
    });
    if (!parameter.optional)
      params.push_back(has ? identifier(parameter.name)
                           : type_of(parameter.kind).nothing);
  }
  return wrapped("    " + firing(event, role), params,
                 is_tailored(role) ? ");\n" : "});\n");
}

// A parameter's type in a handler. The adaptor of TTS has a type of its own for
// the number of an utterance.
std::string type_of(const Parameter& parameter, const Role& role) {
  const bool is_utterance = role.name == "TTS" && parameter.name == "utterance";
  const auto type = type_of(parameter.kind);
  const std::string held = is_utterance ? "Utterance" : type.held;
  if (parameter.optional)
    return "std::optional<" + held + ">";
  return is_utterance ? held : type.passed;
}

// One handler. The names of parameters that it does not use are commented out,
// so that the plug-in compiles without warnings.
std::string handler(const RoleCommand& command, const Role& role) {
  const auto parameters = read_parameters(command.parameters);
  const auto* answer = command.answered ? answer_to(command, role) : nullptr;
  const auto body = answer ? fired(*answer, role, parameters) : std::string();
  std::vector<std::string> list;
  for (const auto& parameter : parameters) {
    const auto name = identifier(parameter.name);
    const bool is_used = answer && repeats(*answer, parameter);
    list.push_back(type_of(parameter, role) +
                   (is_used ? " " + name : " /*" + name + "*/"));
  }
  const std::string end = is_tailored(role) ? ") override {" : ") {";
  return wrapped("  void on_" + snake_case(command.name) + "(", list, end) +
         "\n" + body + "  }\n";
}

// The constructor of a class that derives from RolePlugin: it registers a
// handler for each command.
std::string constructor(const std::string& name, const Role& role) {
  auto text =
      "public:\n  " + name + "() : RolePlugin(\"" + role.name + "\") {\n";
  for (const auto& command : role.commands)
    text += "    on(\"" + command.name + "\", &" + name + "::on_" +
            snake_case(command.name) + ");\n";
  return text + "  }\n\nprivate:\n";
}

// The class's body. NLU and NLG override one function with a result instead of
// handlers that fire events.
std::string body(const std::string& name, const Role& role) {
  if (role.name == "NLU")
    return "protected:\n"
           "  std::vector<parlour::Value> understand(\n"
           "      const std::string& text, const parlour::Map& /*context*/)"
           " const override {\n"
           "    return {parlour::Map{{\"act\", \"inform\"}, {\"text\", text}}"
           "};\n  }\n";
  if (role.name == "NLG")
    return "protected:\n"
           "  std::optional<std::string>\n"
           "  generate(const parlour::Value& what,\n"
           "           const parlour::Value& /*data*/) const override {\n"
           "    return what.text();\n  }\n";
  auto text =
      is_tailored(role) ? std::string("protected:\n") : constructor(name, role);
  for (const auto& command : role.commands)
    text += (&command == &role.commands.front() ? "" : "\n") +
            handler(command, role);
  return text;
}

} // namespace

std::string plugin_source(const std::string& name, const Role& role) {
  return comment(name + " (role " + role.name + "): " + role.sentence + ".") +
         "#include \"runtime/plugin/adaptors.hpp\"\n"
         "#include \"runtime/plugin/export.hpp\"\n"
         "\n"
         "namespace {\n"
         "\n"
         "class " +
         name + " : public parlour::" +
         (is_tailored(role) ? role.name : std::string("Role")) + "Plugin {\n" +
         body(name, role) +
         "};\n"
         "\n"
         "} // namespace\n"
         "\n"
         "PARLOUR_PLUGIN(" +
         name + ", {.name = \"" + name +
         "\",\n"
         "    .roles = {\"" +
         role.name +
         "\"},\n"
         "    .sentence = \"" +
         role.sentence + "\"})\n";
}

// An underscore goes before a capital that follows a small letter, or that
// begins a word after an abbreviation ("TTSPlugin" becomes "tts_plugin").
std::string snake_case(const std::string& name) {
  auto is = [&](std::size_t at, int (*kind)(int)) {
    return at < name.size() && kind(static_cast<unsigned char>(name[at])) != 0;
  };
  std::string snake;
  for (std::size_t at = 0; at < name.size(); ++at) {
    const bool begins = at > 0 && name[at - 1] != '_' && is(at, std::isupper) &&
                        (!is(at - 1, std::isupper) || is(at + 1, std::islower));
    snake += begins ? "_" : "";
    snake +=
        static_cast<char>(std::tolower(static_cast<unsigned char>(name[at])));
  }
  return snake;
}

} // namespace parlour::tools
