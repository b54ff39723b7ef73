// A recursive descent parser with one function for each level of precedence,
// the loosest first (language rule 3.2).
//
//   choice  a ? b : c         logical     or, and      inversion  not
//   sum     + -               comparison  == < in …    product    * / %
//   access  a[i], a.name      negation    the sign
//   primary literals, names, calls, brackets
//
// There is no recovery: the first error ends the parsing, and the mistake rules
// explain it (expression_mistakes.hpp). After an error the functions return
// null or incomplete nodes quickly, and the loops check failed().
#include "script/expression/expression.hpp"

#include <limits>
#include <optional>
#include <utility>

#include "script/expression/lexer.hpp"

namespace parlour::script {

namespace {

// The operators have the same numbers as signs of the lexer, so a sign is
// converted by a cast.
static_assert(static_cast<int>(Sign::modulo) ==
              static_cast<int>(Operator::modulo));

constexpr int deepest = 200; // nested brackets, choices, signs

constexpr int longest_row = 2000; // operators, each a level of the tree

NodePointer make(NodeKind kind, std::uint32_t offset) {
  auto node = std::make_unique<Node>();
  node->kind = kind;
  node->offset = offset;
  return node;
}

class Parser {
public:
  explicit Parser(std::string_view text)
      : lexer_(text), token_(lexer_.next()) {}

  Parsed whole() {
    return finish(choice());
  }

  Parsed arguments() {
    auto node = make(NodeKind::list, 0);
    while (!failed() && peek().kind != TokenKind::end) {
      add(node, choice());
      if (!accept(Sign::comma))
        break;
    }
    return finish(std::move(node));
  }

private:
  using Level = NodePointer (Parser::*)();

  // Ends the parsing. An error of the lexer comes first, wherever it is: a text
  // with an unknown character would otherwise be explained by its consequences.
  // The rest of the tokens is read to find such an error.
  Parsed finish(NodePointer node) {
    if (peek().kind != TokenKind::end)
      unexpected(peek());
    while (peek().kind != TokenKind::end)
      take();
    if (!lexer_.error().empty())
      return {nullptr, lexer_.error(), lexer_.error_offset(), lexer_.fault()};
    return failed() ? std::move(failure_) : Parsed{std::move(node), {}};
  }

  bool failed() const {
    return failure_.fault != SyntaxFault::none;
  }
  void fail(std::string message, std::uint32_t offset,
            SyntaxFault fault = SyntaxFault::other, char sign = '\0') {
    if (!failed())
      failure_ = {nullptr, std::move(message), offset, fault, sign};
  }
  void unexpected(const Token& token) {
    fail("'" + std::string(token.text) + "' is not expected here", token.offset,
         SyntaxFault::unexpected, token.text.empty() ? '\0' : token.text[0]);
  }
  const Token& peek() const {
    return token_;
  }
  Token take() {
    return token_.kind == TokenKind::end ? token_
                                         : std::exchange(token_, lexer_.next());
  }
  bool is(Sign sign) const {
    return token_.sign == sign;
  }
  bool accept(Sign sign) {
    if (!is(sign))
      return false;
    take();
    return true;
  }
  void expect(Sign sign) {
    if (!accept(sign))
      fail("'" + std::string(spelling_of(sign)) + "' is missing", peek().offset,
           SyntaxFault::missing, spelling_of(sign)[0]);
  }
  // Called for each operator that makes the tree one level deeper to the left.
  void count_link() {
    if (++links_ > longest_row)
      fail("the expression is too long", peek().offset);
  }
  // Keeps the number of children right even where an operand is missing after
  // an error.
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
    if (!failed() && accept(Sign::question)) {
      auto node = make(NodeKind::choice, offset);
      add(node, std::move(condition));
      add(node, choice());
      expect(Sign::colon);
      add(node, choice());
      condition = std::move(node);
    }
    --depth_;
    return condition;
  }

  // Level 0 is `or`, level 1 is `and`; both are left-associative.
  NodePointer logical(int level) {
    if (level == 2)
      return inversion();
    const auto sign = level == 0 ? Sign::either : Sign::both;
    auto left = logical(level + 1);
    while (!failed() && is(sign)) {
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
    if (!is(Sign::invert))
      return comparison();
    auto node = make(NodeKind::invert, take().offset);
    if (++depth_ > deepest)
      fail("the expression is nested too deep", node->offset);
    add(node, failed() ? nullptr : inversion());
    --depth_;
    return node;
  }

  // The operator at this place, if it is one of [first, last].
  std::optional<Operator> one_of(Sign first, Sign last) const {
    if (token_.sign < first || token_.sign > last)
      return {};
    return static_cast<Operator>(token_.sign);
  }
  std::optional<Operator> comparing() const {
    return one_of(Sign::equal, Sign::in);
  }

  NodePointer binary(Operator operation, NodePointer left, Level right) {
    count_link();
    auto node = make(NodeKind::binary, take().offset);
    node->operation = operation;
    add(node, std::move(left));
    add(node, (this->*right)());
    return node;
  }

  // A second comparison in a row gets an error of its own, since authors expect
  // chains from mathematics and Python (language rule 3.3).
  NodePointer comparison() {
    auto left = sum();
    const auto operation = comparing();
    if (failed() || !operation)
      return left;
    left = binary(*operation, std::move(left), &Parser::sum);
    if (comparing())
      fail("comparisons do not chain; join them with 'and'", peek().offset);
    return left;
  }

  NodePointer sum() {
    auto left = product();
    while (!failed()) {
      const auto operation = one_of(Sign::add, Sign::subtract);
      if (!operation)
        break;
      left = binary(*operation, std::move(left), &Parser::product);
    }
    return left;
  }

  NodePointer product() {
    auto left = negation();
    while (!failed()) {
      const auto operation = one_of(Sign::multiply, Sign::modulo);
      if (!operation)
        break;
      left = binary(*operation, std::move(left), &Parser::negation);
    }
    return left;
  }

  // The sign of a literal is folded into the literal here, so that -5 is one
  // constant. Also only this way the smallest integer can be written: its
  // digits without the sign do not fit and were read as a number.
  NodePointer negation() {
    if (!is(Sign::subtract))
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
      // The smallest integer; its digits alone do not fit.
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

  // Any number of [i] and .name behind a primary expression. Calls are no part
  // of this: only a plain name can be called.
  NodePointer access() {
    auto node = primary();
    while (!failed()) {
      const auto offset = peek().offset;
      if (is(Sign::open_square) || is(Sign::point))
        count_link();
      if (accept(Sign::open_square)) {
        auto outer = make(NodeKind::index, offset);
        add(outer, std::move(node));
        add(outer, choice());
        expect(Sign::close_square);
        node = std::move(outer);
      } else if (accept(Sign::point)) {
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
      fail("the expression ends too early", token.offset,
           SyntaxFault::ends_early);
    }
    return nullptr;
  }

  NodePointer literal() {
    const auto token = take();
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
    const auto token = take();
    if (token.sign == Sign::unknown)
      return make(NodeKind::unknown, token.offset);
    if (token.sign == Sign::truth || token.sign == Sign::falsehood) {
      auto node = make(NodeKind::boolean, token.offset);
      node->flag = token.sign == Sign::truth;
      return node;
    }
    if (token.sign != Sign::none)
      unexpected(token);
    auto node = make(NodeKind::name, token.offset);
    node->text = token.text;
    if (accept(Sign::open_round)) {
      node->kind = NodeKind::call;
      elements(node, Sign::close_round);
    }
    return node;
  }

  // Elements up to the closing bracket. A comma behind the last one is allowed
  // (language rule 3.12).
  void elements(NodePointer& node, Sign close) {
    while (!failed() && !accept(close)) {
      add(node, choice());
      if (!is(close))
        expect(Sign::comma);
    }
  }

  NodePointer bracketed() {
    const auto offset = peek().offset;
    if (accept(Sign::open_round)) {
      auto node = choice();
      expect(Sign::close_round);
      return node;
    }
    if (accept(Sign::open_square)) {
      auto node = make(NodeKind::list, offset);
      elements(node, Sign::close_square);
      return node;
    }
    if (accept(Sign::open_curly))
      return map(offset);
    unexpected(peek());
    return nullptr;
  }

  // Keys are strings, words (also reserved ones, language rule 3.12) or
  // integers.
  NodePointer map(std::uint32_t offset) {
    auto node = make(NodeKind::map, offset);
    while (!failed() && !accept(Sign::close_curly)) {
      const auto key = take();
      if (key.kind != TokenKind::string && key.kind != TokenKind::word &&
          key.kind != TokenKind::integer)
        fail("a key is missing", key.offset);
      node->keys.emplace_back(key.text);
      node->flag |= key.kind == TokenKind::string;
      expect(Sign::colon);
      add(node, choice());
      if (!is(Sign::close_curly))
        expect(Sign::comma);
    }
    return node;
  }

  Lexer lexer_;
  Token token_; // the next token
  int depth_ = 0;
  int links_ = 0;
  Parsed failure_;
};

} // namespace

bool is_reserved(std::string_view word) {
  return sign_of_word(word) != Sign::none;
}

Parsed parse_expression(std::string_view text) {
  return Parser(text).whole();
}

Parsed parse_arguments(std::string_view text) {
  return Parser(text).arguments();
}

} // namespace parlour::script
