#include "adapters/nlu/grammar/jsgf.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include "adapters/nlu/grammar/jsgf_lexer.hpp"
#include "adapters/nlu/text/tokens.hpp"

namespace parlour::adapters::nlu::jsgf {

namespace {

// The parser is recursive; this bounds its stack.
constexpr int deepest_group = 100;

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos)
    return {};
  const auto last = text.find_last_not_of(" \t\r\n");
  return std::string(text.substr(first, last - first + 1));
}

std::string unquoted(std::string text) {
  if (text.size() >= 2 && (text[0] == '\'' || text[0] == '"') &&
      text.back() == text[0])
    return text.substr(1, text.size() - 2);
  return text;
}

// A recursive-descent parser:
//
//  grammar      = definition*
//  definition   = "grammar" name ";" | ["public"] <name> "=" alternatives ";"
//  alternatives = [weight] sequence ("|" [weight] sequence)*
//  sequence     = item+
//  item         = primary ("*" | "+" | tag)*
//  primary      = word | <name> | reference | "(" alternatives ")"
//               | "[" alternatives "]"
//
// After an error it goes on behind the next ";", so that later errors are
// found.
class Parser {
public:
  Parser(std::vector<Lexeme> lexemes, std::vector<Error>& errors)
      : lexemes_(std::move(lexemes)), errors_(errors) {}

  Grammar run() {
    while (next().kind != LexemeKind::end) {
      const auto before = errors_.size();
      definition();
      if (errors_.size() > before)
        skip_definition();
    }
    return std::move(grammar_);
  }

private:
  // The lexeme that take() will return.
  const Lexeme& next() const {
    return lexemes_[at_];
  }

  // The lexeme `end` is never passed.
  const Lexeme& take() {
    const auto& lexeme = lexemes_[at_];
    if (lexeme.kind != LexemeKind::end)
      ++at_;
    return lexeme;
  }

  bool take_word(std::string_view word) {
    const bool found = next().kind == LexemeKind::word && next().text == word;
    if (found)
      take();
    return found;
  }

  bool take_symbol(char symbol) {
    const bool found = next().is(symbol);
    if (found)
      take();
    return found;
  }

  void error(const SourceLocation& place, std::string message) {
    errors_.push_back({ErrorKind::compile, std::move(message), place});
  }

  void expect(char symbol) {
    if (!take_symbol(symbol))
      error(next().place, std::string{'\'', symbol, '\''}
                              .append(" is expected here, not ")
                              .append(described(next())));
  }

  // A lexeme as an error message shows it.
  static std::string described(const Lexeme& lexeme) {
    switch (lexeme.kind) {
    case LexemeKind::end:
      return "the end of the grammar";
    case LexemeKind::rule:
      return "<" + lexeme.text + ">";
    case LexemeKind::tag:
      return "{" + lexeme.text + "}";
    case LexemeKind::reference:
      return "@" + lexeme.text;
    default:
      return "'" + lexeme.text + "'";
    }
  }

  // Moves behind the next semicolon.
  void skip_definition() {
    while (next().kind != LexemeKind::end && !take().is(';')) {
    }
  }

  // The name of the grammar or a rule. JSGF's import is not supported.
  void definition() {
    if (take_word("grammar"))
      return grammar_name();
    if (next().kind == LexemeKind::word && next().text == "import")
      return error(next().place,
                   "import is not supported: write the rules into this "
                   "grammar");
    rule();
  }

  void grammar_name() {
    grammar_.name = take().text;
    expect(';');
  }

  void rule() {
    Rule made;
    made.is_public = take_word("public");
    made.place = next().place;
    if (next().kind != LexemeKind::rule)
      return error(next().place, "a rule's name such as <greeting> is expected "
                                 "here, not " +
                                     described(next()));
    // "< name >" may have blanks.
    made.name = trimmed(take().text);
    expect('=');
    const auto before = errors_.size();
    made.body = alternatives(0);
    if (errors_.size() == before)
      expect(';');
    check_new(made);
    grammar_.rules.push_back(std::move(made));
  }

  void check_new(const Rule& made) {
    for (const auto& other : grammar_.rules)
      if (other.name == made.name)
        error(made.place, "the rule <" + made.name +
                              "> is there already, in line " +
                              std::to_string(other.place.line));
  }

  // A single alternative is returned without a node around it.
  Node alternatives(int depth) {
    Node node{NodeKind::alternatives, "", {}, {}, {}, next().place};
    do {
      node.weights.push_back(weight());
      node.children.push_back(sequence(depth));
    } while (take_symbol('|'));
    if (node.children.size() == 1)
      return std::move(node.children[0]);
    return node;
  }

  // 1 if no weight is written.
  double weight() {
    if (next().kind != LexemeKind::weight)
      return 1;
    const auto& lexeme = take();
    const auto text = trimmed(lexeme.text);
    double value = 0;
    const auto* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end || !(value > 0) ||
        value > 1e6) {
      error(lexeme.place, "'" + text + "' is no weight: a number above 0");
      return 1;
    }
    return value;
  }

  bool ends_sequence() const {
    const auto& lexeme = next();
    return lexeme.kind == LexemeKind::end || lexeme.is('|') || lexeme.is(')') ||
           lexeme.is(']') || lexeme.is(';') || lexeme.is('=');
  }

  Node sequence(int depth) {
    Node node{NodeKind::sequence, "", {}, {}, {}, next().place};
    while (!ends_sequence()) {
      const auto before = errors_.size();
      add_item(node, depth);
      if (errors_.size() > before)
        return node;
    }
    if (node.children.empty())
      error(next().place, "words are expected here, not " + described(next()));
    return node;
  }

  // A word, reference or group with the repeats and tags behind it.
  void add_item(Node& sequence, int depth) {
    auto item = primary(depth);
    while (true) {
      if (next().is('*') || next().is('+')) {
        const auto kind = next().is('*') ? NodeKind::star : NodeKind::plus;
        auto place = take().place;
        item = Node{kind, "", {std::move(item)}, {}, {}, std::move(place)};
      } else if (next().kind == LexemeKind::tag) {
        item.tags.push_back(tag());
      } else {
        break;
      }
    }
    sequence.children.push_back(std::move(item));
  }

  Node primary(int depth) {
    const auto& lexeme = take();
    switch (lexeme.kind) {
    case LexemeKind::word:
    case LexemeKind::quoted:
      return words(lexeme);
    case LexemeKind::rule:
      return rule_reference(lexeme);
    case LexemeKind::reference:
      return {NodeKind::reference, lexeme.text, {}, {}, {}, lexeme.place};
    default:
      return group(lexeme, depth);
    }
  }

  // <NULL> and <VOID> are special rules of JSGF.
  static Node rule_reference(const Lexeme& lexeme) {
    const auto name = trimmed(lexeme.text);
    const auto kind = name == "NULL"   ? NodeKind::nothing
                      : name == "VOID" ? NodeKind::never
                                       : NodeKind::rule;
    return {kind, name, {}, {}, {}, lexeme.place};
  }

  // The tokenizer may split a word of the grammar: "o'clock", "coffee-shop".
  Node words(const Lexeme& lexeme) {
    Node node{NodeKind::sequence, "", {}, {}, {}, lexeme.place};
    for (auto& token : tokenize(lexeme.text).list)
      node.children.push_back(
          {NodeKind::word, std::move(token.word), {}, {}, {}, lexeme.place});
    if (node.children.size() == 1)
      return std::move(node.children[0]);
    if (node.children.empty())
      node.kind = NodeKind::nothing;
    return node;
  }

  Node group(const Lexeme& opening, int depth) {
    if (depth >= deepest_group) {
      error(opening.place, "groups are nested too deep");
      return {};
    }
    if (opening.is('(')) {
      auto inner = alternatives(depth + 1);
      expect(')');
      return {NodeKind::sequence, "", {std::move(inner)}, {}, {},
              opening.place};
    }
    if (opening.is('[')) {
      auto inner = alternatives(depth + 1);
      expect(']');
      return {NodeKind::optional, "", {std::move(inner)}, {}, {},
              opening.place};
    }
    error(opening.place, described(opening) + " is not expected here");
    return {};
  }

  // Splits {name=value} at its first "=".
  Tag tag() {
    const auto& lexeme = take();
    const auto sign = lexeme.text.find('=');
    Tag made;
    made.place = lexeme.place;
    made.name = trimmed(std::string_view(lexeme.text).substr(0, sign));
    made.has_value = sign != std::string::npos;
    if (made.has_value)
      made.value =
          unquoted(trimmed(std::string_view(lexeme.text).substr(sign + 1)));
    if (made.name.empty())
      error(lexeme.place, "a tag is {Slot}, {Slot=value}, {act=…} or "
                          "{topic=…}");
    return made;
  }

  std::vector<Lexeme> lexemes_;
  std::size_t at_ = 0;
  std::vector<Error>& errors_;
  Grammar grammar_;
};

} // namespace

Grammar parse(const GrammarModel& model, std::vector<Error>& errors) {
  auto grammar = Parser(scan(model.text, model.place, errors), errors).run();
  // The name in the settings or script wins over the one in the text.
  if (!model.name.empty())
    grammar.name = model.name;
  return grammar;
}

Value literal(const std::string& text) {
  if (text == "true" || text == "false")
    return text == "true";
  auto number = parse_number(text);
  return number.is_unknown() ? Value(text) : number;
}

} // namespace parlour::adapters::nlu::jsgf
