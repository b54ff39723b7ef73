// Branches and loops (language rule 5).
#include "script/statements.hpp"

namespace parlour::script {

void StatementCompiler::reached(const Element& element) {
  b_.at(element.position);
  b_.emit(Operation::reached);
}

// Jumps that are taken where the condition does not hold.
std::vector<Label> StatementCompiler::condition(const Element& element,
                                                const char* attribute) {
  std::vector<Label> otherwise;
  const auto* condition = required(element, attribute);
  if (!condition)
    return otherwise;
  const auto source = source_of(*condition);
  if (const auto node = expressions_.parse(source))
    expressions_.jump(*node, source, false, otherwise);
  return otherwise;
}

void StatementCompiler::if_(const Element& element) {
  std::vector<Label> done;
  auto otherwise = condition(element, "cond");
  reached(element);
  block(element, {"elseif", "else"});
  for (const auto& child : element.children) {
    const auto name = plain_name(child.name);
    if (name != "elseif" && name != "else")
      continue;
    done.push_back(b_.emit(Operation::jump));
    b_.land(otherwise);
    b_.at(child.position);
    otherwise =
        name == "elseif" ? condition(child, "cond") : std::vector<Label>{};
    reached(child);
    block(child);
  }
  b_.land(otherwise);
  b_.land(done);
}

// All tests first, then the bodies; no fall-through.
void StatementCompiler::switch_(const Element& element) {
  const auto mark = b_.mark();
  const auto value = b_.allocate();
  if (const auto* subject = required(element, "expr"))
    expressions_.expression(source_of(*subject), value);
  std::vector<std::pair<const Element*, Label>> cases;
  const Element* otherwise = nullptr;
  for (const auto& child : element.children) {
    if (plain_name(child.name) == "default")
      otherwise = &child;
    const auto* candidate = child.attribute("value");
    if (plain_name(child.name) != "case" || !candidate)
      continue;
    b_.at(child.position);
    const auto test = b_.allocate();
    expressions_.text_or_expression(source_of(*candidate), test);
    cases.emplace_back(&child,
                       b_.emit(Operation::jump_if_equal, value, test, 0, true));
    b_.release(test);
  }
  std::vector<Label> done;
  if (otherwise) {
    reached(*otherwise);
    block(*otherwise);
  }
  done.push_back(b_.emit(Operation::jump));
  for (const auto& [child, label] : cases) {
    b_.land(label);
    reached(*child);
    block(*child);
    done.push_back(b_.emit(Operation::jump));
  }
  b_.land(done);
  b_.release(mark);
}

void StatementCompiler::end_loop() {
  b_.land(loops_.back().breaks);
  loops_.pop_back();
}

void StatementCompiler::for_(const Element& element) {
  if (element.attribute("each"))
    return for_each(element);
  b_.open_scope();
  const auto base = b_.allocate(4); // machine_operations.cpp, for_prepare
  if (const auto* from = required(element, "from"))
    expressions_.expression(source_of(*from), static_cast<Register>(base + 1));
  b_.load(static_cast<Register>(base + 2), Box::small(1));
  if (const auto* step = element.attribute("step"))
    expressions_.expression(source_of(*step), static_cast<Register>(base + 2));
  if (const auto* to = required(element, "to"))
    expressions_.expression(source_of(*to), static_cast<Register>(base + 3));
  const auto* name = required(element, "name");
  b_.declare(name ? name->value : " ");
  b_.at(element.position);
  const auto none = b_.emit(Operation::for_prepare, base);
  const auto body = b_.here();
  loops_.push_back({{}, {}, transactions_.size()});
  block(element);
  b_.land(loops_.back().continues);
  b_.at(element.position);
  b_.back(Operation::for_next, base, body);
  b_.land(none);
  end_loop();
  b_.close_scope();
}

void StatementCompiler::for_each(const Element& element) {
  b_.open_scope();
  const auto base = b_.allocate(2); // what is walked over, and the position
  if (const auto* collection = required(element, "in"))
    expressions_.expression(source_of(*collection), base);
  b_.emit(Operation::each_prepare, base, base);
  const auto* index = element.attribute("index");
  b_.declare(element.attribute("each")->value);
  b_.declare(index ? index->value : " ");
  const auto next = b_.here();
  const auto done = b_.emit(Operation::each_next, base);
  loops_.push_back({{}, {}, transactions_.size()});
  block(element);
  b_.land(loops_.back().continues);
  b_.at(element.position);
  b_.back(Operation::loop, 0, next);
  b_.land(done);
  end_loop();
  b_.close_scope();
}

void StatementCompiler::while_(const Element& element) {
  const auto start = b_.here();
  const auto otherwise = condition(element, "cond");
  loops_.push_back({{}, {}, transactions_.size()});
  block(element);
  b_.land(loops_.back().continues);
  b_.at(element.position);
  b_.back(Operation::loop, 0, start);
  b_.land(otherwise);
  end_loop();
}

void StatementCompiler::break_(const Element& element) {
  if (loops_.empty())
    return error(element.position, "<break> stands outside of a loop");
  end_transactions(loops_.back().transactions);
  loops_.back().breaks.push_back(b_.emit(Operation::jump));
}

void StatementCompiler::continue_(const Element& element) {
  if (loops_.empty())
    return error(element.position, "<continue> stands outside of a loop");
  end_transactions(loops_.back().transactions);
  loops_.back().continues.push_back(b_.emit(Operation::jump));
}

} // namespace parlour::script
