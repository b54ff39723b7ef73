#include "adapters/web/protocol.hpp"

#include <algorithm>
#include <limits>

#include <nlohmann/json.hpp>

#include "adapters/web/bounds.hpp"
#include "runtime/base/text/utf8.hpp"
#include "runtime/text/json_text.hpp"

namespace parlour::adapters::web {

namespace {

using nlohmann::json;

// What a Value can hold, too.
constexpr std::uint64_t max_number = std::numeric_limits<std::int64_t>::max();

tl::unexpected<Error> wrong(const std::string& message) {
  return fail(ErrorKind::network, message);
}

// A member that is a whole number; `missing` where there is none.
Expected<std::uint64_t> number_of(const json& object, const char* name,
                                  std::uint64_t missing) {
  const auto found = object.find(name);
  if (found == object.end())
    return missing;
  if (!found->is_number_unsigned() || found->get<std::uint64_t>() > max_number)
    return wrong(std::string("\"") + name +
                 "\" is a whole number from 0, such as 1");
  return found->get<std::uint64_t>();
}

// Members that nobody knows are ignored: later versions may have more.
Expected<Heard> read_hello(const json& object) {
  const auto version = number_of(object, "version", protocol_version);
  if (!version || *version != protocol_version)
    return wrong("this server speaks version 1: {\"type\": \"hello\", "
                 "\"version\": 1}");
  Hello hello;
  const auto session = object.find("session");
  if (session != object.end() && !session->is_string())
    return wrong("\"session\" is the text that welcome told; leave it out for "
                 "a new session");
  if (session != object.end())
    hello.session = session->get<std::string>();
  const auto turn = number_of(object, "turn", 0);
  const auto output = number_of(object, "output", 0);
  if (!turn || !output)
    return tl::make_unexpected((turn ? output : turn).error());
  hello.turn = *turn;
  hello.output = *output;
  return hello;
}

// A list of texts is a row: lines that are said in one breath.
Expected<Heard> read_turn(const json& object) {
  const auto number = number_of(object, "turn", 0);
  if (!number)
    return tl::make_unexpected(number.error());
  if (*number == 0)
    return wrong("a turn has a number from 1: {\"type\": \"turn\", \"turn\": "
                 "1, \"say\": \"hello\"}");
  Turn turn{*number, {}};
  const auto say = object.find("say");
  const auto is_text = [](const json& value) { return value.is_string(); };
  if (say != object.end() && say->is_string())
    turn.lines = {say->get<std::string>()};
  else if (say != object.end() && say->is_array() && !say->empty() &&
           say->size() <= max_lines &&
           std::all_of(say->begin(), say->end(), is_text))
    turn.lines = say->get<std::vector<std::string>>();
  else
    return wrong("\"say\" is a text, or a list of 1 to " +
                 std::to_string(max_lines) + " texts");
  return turn;
}

// Without the exception's own beginning, "[json.exception.parse_error.101] ".
// Visitors see this text.
std::string words_of(const json::exception& error) {
  const std::string text = error.what();
  const auto end = text.find("] ");
  return end == std::string::npos ? text : text.substr(end + 2);
}

// The type decides; what else is in the object, each kind reads by itself.
Expected<Heard> read_object(const json& object) {
  if (!object.is_object())
    return wrong("a message is an object: {\"type\": \"turn\", …}");
  const auto found = object.find("type");
  const auto type = found != object.end() && found->is_string()
                        ? found->get<std::string>()
                        : std::string();
  if (type == "hello")
    return read_hello(object);
  if (type == "turn")
    return read_turn(object);
  if (type == "end")
    return Goodbye();
  if (type == "ping")
    return Ping();
  return wrong("\"type\" is \"hello\", \"turn\", \"end\" or \"ping\"");
}

// A text as JSON, and the beginning of a message.
std::string quoted(const std::string& text) {
  return json_text(Value(text));
}
std::string number(const char* name, std::uint64_t value) {
  return std::string(", \"") + name + "\": " + std::to_string(value);
}

// Written by hand: the members always stand in the order of PROTOCOL.md.
//
// {"type": "say", "turn": 1, "output": 2, "act": "answer", "text": "Hello."}
struct Json {
  std::string operator()(const Welcome& what) const {
    return "{\"type\": \"welcome\"" + number("version", protocol_version) +
           ", \"session\": " + quoted(what.session) +
           number("turn", what.turn) +
           ", \"resumed\": " + (what.resumed ? "true" : "false") +
           ", \"lost\": " + (what.lost ? "true" : "false") +
           ", \"clock\": " + quoted(what.clock) +
           number("process", what.process) + "}";
  }
  std::string operator()(const Said& what) const {
    return "{\"type\": \"say\"" + number("turn", what.turn) +
           number("output", what.output) + ", \"act\": " + quoted(what.act) +
           ", \"text\": " + quoted(what.text) + "}";
  }
  std::string operator()(const Done& what) const {
    return "{\"type\": \"done\"" + number("turn", what.turn) + "}";
  }
  std::string operator()(const Ended&) const {
    return "{\"type\": \"end\"}";
  }
  std::string operator()(const Pong&) const {
    return "{\"type\": \"pong\"}";
  }
  std::string operator()(const Refused& what) const {
    return "{\"type\": \"error\", \"code\": " + quoted(what.code) +
           ", \"message\": " + quoted(what.message) +
           (what.turn != 0 ? number("turn", what.turn) : "") + "}";
  }
};

// A person sees what is said and what is refused; the rest is for programs.
struct Line {
  std::string operator()(const Said& what) const {
    auto text = what.text;
    std::ranges::replace(text, '\n', ' ');
    return text;
  }
  std::string operator()(const Refused& what) const {
    return "! " + what.message;
  }
  std::string operator()(const auto&) const {
    return {};
  }
};

} // namespace

// The library throws where the text is no JSON, and says at which byte.
Expected<Heard> read_heard(std::string_view text) {
  if (const auto bad = find_invalid_utf8(text))
    return wrong("byte " + std::to_string(*bad + 1) + " is no UTF-8");
  try {
    return read_object(json::parse(text));
  } catch (const json::exception& error) {
    return wrong("this is no JSON: " + words_of(error));
  }
}

bool is_structured(std::string_view line) {
  return line.starts_with('{');
}

Expected<std::string> read_typed(std::string_view line) {
  if (line.ends_with('\r'))
    line.remove_suffix(1);
  if (const auto bad = find_invalid_utf8(line))
    return wrong("byte " + std::to_string(*bad + 1) +
                 " of this line is no UTF-8; it was not taken. Type it again");
  return std::string(line);
}

std::string to_json(const Told& told) {
  return std::visit(Json(), told);
}

std::string to_line(const Told& told) {
  return std::visit(Line(), told);
}

} // namespace parlour::adapters::web
