// One member function parses each kind of line. It reports an error or appends
// a step.
#include "tools/parlour/conversation_test/conversation_file.hpp"

#include <algorithm>
#include <charconv>
#include <map>

#include <re2/re2.h>

#include "runtime/base/outside/file_bytes.hpp"
#include "runtime/base/text/utf8.hpp"
#include "tools/parlour/conversation_test/directive_reader.hpp"

namespace parlour::tools {

namespace {

using script::Finding;
using script::Severity;

const std::vector<std::string> directives = {
    "U:", "R:", "R~", "wait", "event", "expect", "clock", "seed", "P:", "B:"};
const std::vector<std::string> expectations = {"post", "slot", "state", "sql",
                                               "first-sound"};
constexpr const char* usual_voice = "rms";

std::string in_quotes(std::string_view text) {
  return "'" + std::string(text) + "'";
}

class Parser {
public:
  explicit Parser(std::string file) {
    auto& conversation = result_.conversation;
    conversation.name = std::filesystem::path(file).stem().string();
    conversation.file = std::move(file);
    conversation.start = default_start();
  }

  ParsedConversation parse(std::string_view text) {
    // Invalid UTF-8 is one error, with its line; nothing else is parsed then.
    if (const auto invalid = find_invalid_utf8(text)) {
      line_ = 1 + static_cast<std::uint32_t>(
                      std::count(text.begin(), text.begin() + *invalid, '\n'));
      error("this is not UTF-8; save the file as UTF-8");
      text = {};
    }
    while (!text.empty()) {
      ++line_;
      const auto end = text.find('\n');
      line(trimmed(text.substr(0, end)));
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return std::move(result_);
  }

private:
  // Parses what follows the line's first word.
  using Handler = void (Parser::*)(std::string_view rest);

  // Dispatches a line by its first word.
  void line(std::string_view text) {
    if (text.empty() || text.front() == '#')
      return;
    written_ = text;
    if (text.size() > 1 && text[1] == '(' &&
        std::string_view("UPB").find(text[0]) != std::string_view::npos)
      return spoken(text);
    for (const auto& [word, handler] : handlers())
      if (text.substr(0, word.size()) == word && ends(text, word))
        return (this->*handler)(trimmed(text.substr(word.size())));
    const auto first = text.substr(0, text.find_first_of(" \t"));
    error(
        "unknown directive " + in_quotes(first) +
        script::did_you_mean(first, directives) +
        "; expected U:, R:, R~, P:, B:, wait, event, expect, clock, seed or #");
  }

  // A directive of letters must be followed by a blank. "U:" and "R~" need
  // none.
  static bool ends(std::string_view text, std::string_view word) {
    const auto last = word.back();
    return last == ':' || last == '~' || text.size() == word.size() ||
           text[word.size()] == ' ' || text[word.size()] == '\t';
  }

  // No directive is the beginning of another one, so the order of the search
  // does not matter.
  static const std::map<std::string_view, Handler>& handlers() {
    static const std::map<std::string_view, Handler> table = {
        {"U:", &Parser::user},     {"R:", &Parser::robot},
        {"R~", &Parser::pattern},  {"wait", &Parser::wait},
        {"event", &Parser::event}, {"expect", &Parser::expect},
        {"clock", &Parser::clock}, {"seed", &Parser::seed},
        {"P:", &Parser::partial},  {"B:", &Parser::barge_in}};
    return table;
  }

  // "U(voice=rms, noise=babble@20): words", and so P and B.
  void spoken(std::string_view text) {
    const auto close = text.find("):");
    if (close == std::string_view::npos)
      return error("expected " + std::string(text.substr(0, 1)) +
                   "(voice=NAME, noise=KIND@DB): words");
    const auto count = result_.conversation.steps.size();
    const auto colon = std::string(text.substr(0, 1)) + ":";
    (this->*handlers().at(colon))(trimmed(text.substr(close + 2)));
    if (result_.conversation.steps.size() == count)
      return; // an error
    auto& made = result_.conversation.steps.back();
    made.voice = usual_voice;
    auto rest = text.substr(2, close - 2);
    while (!rest.empty()) {
      const auto end = rest.find(',');
      how(made, trimmed(rest.substr(0, end)));
      rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
  }

  void how(Step& made, std::string_view text) {
    const auto equals = std::min(text.find('='), text.size());
    const auto name = trimmed(text.substr(0, equals));
    const std::string value(
        trimmed(text.substr(std::min(equals + 1, text.size()))));
    if (name == "voice" && !value.empty())
      made.voice = value;
    else if (name == "noise" && !value.empty())
      made.noise = value;
    else
      error("a line is spoken with voice=NAME and noise=KIND@DB, not " +
            in_quotes(text));
  }

  void user(std::string_view rest) {
    words(StepKind::user, rest, "U: needs what the user says");
  }
  void robot(std::string_view rest) {
    words(StepKind::robot, rest, "R: needs what the robot says");
  }
  // The pattern is compiled here only to find errors.
  void pattern(std::string_view rest) {
    RE2 pattern(std::string(rest), RE2::Quiet);
    if (!pattern.ok())
      return error("not a regular expression: " + pattern.error());
    words(StepKind::robot_pattern, rest, "R~ needs a regular expression");
  }
  // A step whose text is the rest of the line; `otherwise` is the error if
  // there is none.
  void words(StepKind kind, std::string_view rest, const char* otherwise) {
    if (rest.empty())
      return error(otherwise);
    step(kind).text = rest;
  }

  void wait(std::string_view rest) {
    const auto duration = parse_duration(rest);
    if (!duration || *duration < Milliseconds(0))
      return error("wait needs a duration such as 3s or 500ms, found " +
                   in_quotes(rest));
    step(StepKind::wait).duration = *duration;
  }

  void event(std::string_view rest) {
    message(StepKind::event, rest, "event SOURCE COMMAND param…");
  }

  // "SOURCE COMMAND param…": of `event` and of `expect post`.
  void message(StepKind kind, std::string_view rest, const std::string& form) {
    DirectiveReader reader(rest);
    auto target = reader.word();
    auto command = reader.word();
    std::vector<Value> params;
    while (auto word = reader.word())
      params.push_back(word->value());
    if (reader.open_quote())
      return error("a quote is left open");
    if (!target || !command)
      return error("expected " + form);
    auto& made = step(kind);
    made.target = std::move(target->text);
    made.command = std::move(command->text);
    made.params = std::move(params);
  }

  // "expect post|slot|state|sql …": dispatches by the second word.
  void expect(std::string_view rest) {
    DirectiveReader reader(rest);
    const auto what = reader.word().value_or(Word{}).text;
    if (what == "post")
      return message(StepKind::expect_post, reader.rest(),
                     "expect post MODULE COMMAND param…");
    if (what == "slot")
      return expect_slot(reader.rest());
    if (what == "state")
      return words(StepKind::expect_state, reader.rest(),
                   "expected: expect state NAME");
    if (what == "sql")
      return expect_sql(reader.rest());
    if (what == "first-sound")
      return expect_first_sound(reader.rest());
    error("expect what? post, slot, state, sql or first-sound, not " +
          in_quotes(what) + script::did_you_mean(what, expectations));
  }

  // "Topic.Slot = value". A slot's name has no " = ", so the first one counts.
  void expect_slot(std::string_view rest) {
    const auto sides = split_at_first_equals(rest);
    const auto dot = sides ? sides->left.find('.') : std::string_view::npos;
    if (dot == std::string_view::npos || dot == 0 ||
        dot + 1 == sides->left.size() || sides->right.empty())
      return error("expected: expect slot Topic.Slot = value");
    auto& made = step(StepKind::expect_slot);
    made.text = sides->left.substr(0, dot);
    made.target = sides->left.substr(dot + 1);
    made.value = parse_literal(sides->right);
  }

  // Splits at the last " = ", because a query may contain one.
  void expect_sql(std::string_view rest) {
    const auto sides = split_at_last_equals(rest);
    if (!sides || sides->left.empty() || sides->right.empty())
      return error("expected: expect sql QUERY = value");
    auto& made = step(StepKind::expect_sql);
    made.text = sides->left;
    made.value = parse_literal(sides->right);
  }

  void expect_first_sound(std::string_view rest) {
    const auto is_bound = rest.starts_with('<');
    const auto most =
        parse_duration(is_bound ? trimmed(rest.substr(1)) : std::string_view());
    if (!most || *most <= Milliseconds(0))
      return error("expected: expect first-sound < 1s");
    step(StepKind::expect_first_sound).duration = *most;
  }

  // Before the first step it sets the start of the conversation; later, time
  // passes until then.
  void clock(std::string_view rest) {
    const auto time = parse_timestamp(rest);
    if (!time)
      return error("clock needs a time such as 2026-11-21 09:00, found " +
                   in_quotes(rest));
    auto& conversation = result_.conversation;
    if (conversation.steps.empty())
      conversation.start = *time;
    else
      step(StepKind::clock).time = *time;
  }

  void seed(std::string_view rest) {
    auto& conversation = result_.conversation;
    const auto [end, code] = std::from_chars(
        rest.data(), rest.data() + rest.size(), conversation.seed);
    if (code != std::errc() || end != rest.data() + rest.size())
      return error("seed needs a whole number, found " + in_quotes(rest));
    if (!conversation.steps.empty())
      error("seed stands before the first turn");
  }

  void partial(std::string_view rest) {
    words(StepKind::partial, rest, "P: needs what the user is just saying");
  }
  // "[words heard]" is optional.
  void barge_in(std::string_view rest) {
    auto& made = step(StepKind::barge_in);
    if (rest.substr(0, 1) == "[") {
      const auto end = rest.find(']');
      if (end == std::string_view::npos)
        return error("B: [words heard] is left open");
      made.target = trimmed(rest.substr(1, end - 1));
      rest = trimmed(rest.substr(end + 1));
    }
    made.text = rest;
  }

  // Appends a step for the current line.
  Step& step(StepKind kind) {
    auto& made = result_.conversation.steps.emplace_back();
    made.kind = kind;
    made.line = line_;
    made.written = written_;
    return made;
  }

  // Reports an error at the current line; parsing goes on with the next.
  void error(std::string message) {
    result_.errors.push_back({Severity::error,
                              {result_.conversation.file, line_, 1},
                              std::move(message)});
  }

  ParsedConversation result_;
  std::uint32_t line_ = 0;
  std::string_view written_;
};

} // namespace

Timestamp default_start() {
  return parse_timestamp("2026-11-21 09:00").value();
}

bool is_spoken(const Conversation& conversation) {
  return std::ranges::any_of(conversation.steps, [](const Step& step) {
    return !step.voice.empty() || step.kind == StepKind::expect_first_sound;
  });
}

ParsedConversation parse_conversation(std::string_view text, std::string file) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.substr(0, byte_order_mark.size()) == byte_order_mark)
    text.remove_prefix(byte_order_mark.size());
  return Parser(std::move(file)).parse(text);
}

ParsedConversation read_conversation(const std::filesystem::path& file) {
  // A larger file is no conversation.
  constexpr std::size_t most = 16 << 20;
  const auto text = read_file(file, most);
  auto parsed = parse_conversation(text.value_or(""), file.string());
  if (!text)
    parsed.errors.push_back(
        {Severity::error, text.error().place, text.error().message});
  return parsed;
}

// Text behind a closing quote makes the whole an unquoted text.
Value parse_literal(std::string_view text) {
  DirectiveReader reader(text);
  const auto word = reader.word();
  if (word && word->quoted && reader.rest().empty())
    return word->text;
  return Word{std::string(trimmed(text)), false}.value();
}

bool is_wildcard(const Value& value) {
  const auto* text = value.if_string();
  return text && *text == "*";
}

} // namespace parlour::tools
