// The parser: one function for each level of precedence, loosest first
// (language rule 3).
#include "script/expression.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "script/lexer.hpp"

namespace parlour::script {

namespace {

constexpr int deepest = 200;

struct Spelling {
  std::string_view text;
  Operator operation;
};

constexpr std::array comparisons{Spelling{"==", Operator::equal},
                                 Spelling{"eq", Operator::equal},
                                 Spelling{"!=", Operator::unequal},
                                 Spelling{"ne", Operator::unequal},
                                 Spelling{"<", Operator::less},
                                 Spelling{"lt", Operator::less},
                                 Spelling{"<=", Operator::less_equal},
                                 Spelling{"le", Operator::less_equal},
                                 Spelling{">", Operator::greater},
                                 Spelling{"gt", Operator::greater},
                                 Spelling{">=", Operator::greater_equal},
                                 Spelling{"ge", Operator::greater_equal},
                                 Spelling{"in", Operator::in}};
constexpr std::array sums{Spelling{"+", Operator::add},
                          Spelling{"-", Operator::subtract}};
constexpr std::array products{Spelling{"*", Operator::multiply},
                              Spelling{"/", Operator::divide},
                              Spelling{"%", Operator::modulo}};
constexpr std::array<std::string_view, 13> reserved{
    "and", "or", "not", "eq",   "ne",    "lt",     "le",
    "gt",  "ge", "in",  "true", "false", "unknown"};

constexpr int longest_row = 2000; // of operators; a tree as deep as that

NodePointer make(NodeKind kind, std::uint32_t offset) {
  auto node = std::make_unique<Node>();
  node->kind = kind;
  node->offset = offset;
  return node;
}

std::string unexpected(const Token& token) {
  return "'" + std::string(token.text) + "' is not expected here";
}

class Parser {
public:
  explicit Parser(std::string_view text) : lexed_(tokenize(text)) {
    if (!lexed_.error.empty())
      fail(lexed_.error, lexed_.error_offset);
    if (lexed_.tokens.empty() || lexed_.tokens.back().kind != TokenKind::end)
      lexed_.tokens.emplace_back();
  }

  Parsed whole() {
    auto node = failed() ? nullptr : choice();
    return finish(std::move(node));
  }

  Parsed arguments() {
    auto node = make(NodeKind::list, 0);
    while (!failed() && peek().kind != TokenKind::end) {
      add(node, choice());
      if (!accept(","))
        break;
    }
    return finish(std::move(node));
  }

private:
  using Level = NodePointer (Parser::*)();

  Parsed finish(NodePointer node) {
    if (peek().kind != TokenKind::end)
      fail(unexpected(peek()), peek().offset);
    if (failed())
      return {nullptr, error_, error_offset_};
    return {std::move(node), {}, 0};
  }

  bool failed() const {
    return !error_.empty();
  }
  void fail(std::string message, std::uint32_t offset) {
    if (!failed()) {
      error_ = std::move(message);
      error_offset_ = offset;
    }
  }
  const Token& peek() const {
    return lexed_.tokens[at_];
  }
  const Token& take() {
    const auto& token = lexed_.tokens[at_];
    if (token.kind != TokenKind::end)
      ++at_;
    return token;
  }
  bool is(std::string_view text) const {
    const auto& token = peek();
    return (token.kind == TokenKind::symbol || token.kind == TokenKind::word) &&
           token.text[0] == text[0] && token.text == text;
  }
  bool accept(std::string_view text) {
    if (!is(text))
      return false;
    take();
    return true;
  }
  void expect(std::string_view text) {
    if (!accept(text))
      fail("'" + std::string(text) + "' is missing", peek().offset);
  }
  void count_link() {
    if (++links_ > longest_row)
      fail("the expression is too long", peek().offset);
  }
  static void add(NodePointer& node, NodePointer child) {
    node->children.push_back(child ? std::move(child)
                                   : make(NodeKind::unknown, 0));
  }

  NodePointer choice() {
    if (++depth_ > deepest)
      fail("the expression is nested too deep", peek().offset);
    if (failed())
      return nullptr;
    auto condition = logical(0);
    const auto offset = peek().offset;
    if (!failed() && accept("?")) {
      auto node = make(NodeKind::choice, offset);
      add(node, std::move(condition));
      add(node, choice());
      expect(":");
      add(node, choice());
      condition = std::move(node);
    }
    --depth_;
    return condition;
  }

  // `or`, then `and`.
  NodePointer logical(int level) {
    if (level == 2)
      return inversion();
    const auto* word = level == 0 ? "or" : "and";
    const auto* sign = level == 0 ? "||" : "&&";
    auto left = logical(level + 1);
    while (!failed() && (is(word) || is(sign))) {
      count_link();
      auto node =
          make(level == 0 ? NodeKind::either : NodeKind::both, take().offset);
      add(node, std::move(left));
      add(node, logical(level + 1));
      left = std::move(node);
    }
    return left;
  }

  NodePointer inversion() {
    if (!is("not") && !is("!"))
      return comparison();
    auto node = make(NodeKind::invert, take().offset);
    if (++depth_ > deepest)
      fail("the expression is nested too deep", node->offset);
    add(node, failed() ? nullptr : inversion());
    --depth_;
    return node;
  }

  template <std::size_t size>
  std::optional<Operator> one_of(const std::array<Spelling, size>& spellings) {
    for (const auto& spelling : spellings)
      if (is(spelling.text))
        return spelling.operation;
    return {};
  }

  NodePointer binary(Operator operation, NodePointer left, Level right) {
    count_link();
    auto node = make(NodeKind::binary, take().offset);
    node->operation = operation;
    add(node, std::move(left));
    add(node, (this->*right)());
    return node;
  }

  NodePointer comparison() {
    auto left = sum();
    const auto operation = one_of(comparisons);
    if (failed() || !operation)
      return left;
    left = binary(*operation, std::move(left), &Parser::sum);
    if (one_of(comparisons))
      fail("comparisons do not chain; join them with 'and'", peek().offset);
    return left;
  }

  NodePointer sum() {
    auto left = product();
    while (!failed()) {
      const auto operation = one_of(sums);
      if (!operation)
        break;
      left = binary(*operation, std::move(left), &Parser::product);
    }
    return left;
  }

  NodePointer product() {
    auto left = negation();
    while (!failed()) {
      const auto operation = one_of(products);
      if (!operation)
        break;
      left = binary(*operation, std::move(left), &Parser::negation);
    }
    return left;
  }

  NodePointer negation() {
    if (!is("-"))
      return access();
    auto node = make(NodeKind::negate, take().offset);
    if (++depth_ > deepest)
      fail("the expression is nested too deep", node->offset);
    auto operand = failed() ? nullptr : negation();
    --depth_;
    if (operand && operand->kind == NodeKind::integer &&
        operand->integer != std::numeric_limits<std::int64_t>::min()) {
      operand->integer = -operand->integer;
      return operand;
    }
    if (operand && operand->kind == NodeKind::number) {
      // The least integer, whose digits alone are too many for one.
      if (operand->text == "9223372036854775808") {
        operand->kind = NodeKind::integer;
        operand->integer = std::numeric_limits<std::int64_t>::min();
        return operand;
      }
      operand->number = -operand->number;
      return operand;
    }
    add(node, std::move(operand));
    return node;
  }

  NodePointer access() {
    auto node = primary();
    while (!failed()) {
      const auto offset = peek().offset;
      if (is("[") || is("."))
        count_link();
      if (accept("[")) {
        auto outer = make(NodeKind::index, offset);
        add(outer, std::move(node));
        add(outer, choice());
        expect("]");
        node = std::move(outer);
      } else if (accept(".")) {
        auto outer = make(NodeKind::field, peek().offset);
        if (peek().kind != TokenKind::word)
          fail("a name is missing after '.'", peek().offset);
        outer->text = take().text;
        add(outer, std::move(node));
        node = std::move(outer);
      } else {
        break;
      }
    }
    return node;
  }

  NodePointer primary() {
    const auto& token = peek();
    switch (token.kind) {
    case TokenKind::integer:
    case TokenKind::number:
    case TokenKind::string:
      return literal();
    case TokenKind::word:
      return word();
    case TokenKind::symbol:
      return bracketed();
    case TokenKind::end:
      fail("the expression ends too early", token.offset);
    }
    return nullptr;
  }

  NodePointer literal() {
    const auto& token = take();
    const auto kind = token.kind == TokenKind::integer  ? NodeKind::integer
                      : token.kind == TokenKind::number ? NodeKind::number
                                                        : NodeKind::string;
    auto node = make(kind, token.offset);
    node->integer = token.integer;
    node->number = token.number;
    node->text = token.text;
    return node;
  }

  NodePointer word() {
    const auto& token = take();
    if (token.text == "unknown")
      return make(NodeKind::unknown, token.offset);
    if (token.text == "true" || token.text == "false") {
      auto node = make(NodeKind::boolean, token.offset);
      node->flag = token.text == "true";
      return node;
    }
    if (is_reserved(token.text))
      fail(unexpected(token), token.offset);
    auto node = make(NodeKind::name, token.offset);
    node->text = token.text;
    if (accept("(")) {
      node->kind = NodeKind::call;
      elements(node, ")");
    }
    return node;
  }

  // A trailing comma is allowed (language rule 7).
  void elements(NodePointer& node, std::string_view close) {
    while (!failed() && !accept(close)) {
      add(node, choice());
      if (!is(close))
        expect(",");
    }
  }

  NodePointer bracketed() {
    const auto offset = peek().offset;
    if (accept("(")) {
      auto node = choice();
      expect(")");
      return node;
    }
    if (accept("[")) {
      auto node = make(NodeKind::list, offset);
      elements(node, "]");
      return node;
    }
    if (accept("{"))
      return map(offset);
    fail(unexpected(peek()), offset);
    return nullptr;
  }

  NodePointer map(std::uint32_t offset) {
    auto node = make(NodeKind::map, offset);
    while (!failed() && !accept("}")) {
      const auto& key = take();
      if (key.kind != TokenKind::string && key.kind != TokenKind::word &&
          key.kind != TokenKind::integer)
        fail("a key is missing", key.offset);
      node->keys.emplace_back(key.text);
      expect(":");
      add(node, choice());
      if (!is("}"))
        expect(",");
    }
    return node;
  }

  Tokens lexed_;
  std::size_t at_ = 0;
  int depth_ = 0;
  int links_ = 0;
  std::string error_;
  std::uint32_t error_offset_ = 0;
};

} // namespace

bool is_reserved(std::string_view word) {
  return std::find(reserved.begin(), reserved.end(), word) != reserved.end();
}

Parsed parse_expression(std::string_view text) {
  return Parser(text).whole();
}

Parsed parse_arguments(std::string_view text) {
  return Parser(text).arguments();
}

} // namespace parlour::script
