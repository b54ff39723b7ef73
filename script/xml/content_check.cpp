// An <if> in both notations, which gather_parts makes equal:
//
//   <if cond="a">                      <if cond="a">
//     <print param="one"/>               <print param="one"/>
//     <elseif cond="b"/>                 <elseif cond="b">
//     <print param="two"/>                 <print param="two"/>
//     <else/>                            </elseif>
//     <print param="three"/>             <else><print param="three"/></else>
//   </if>                              </if>

#include "script/xml/content_check.hpp"

#include <optional>
#include <utility>

namespace parlour::script {

namespace {

std::string tag(const std::string& name) {
  return "<" + name + ">";
}

void error(Findings& findings, Position position, std::string message) {
  findings.add({Severity::error, {position}, std::move(message), "element"});
}

// Collects the children of an element that has parts, one after the other. A
// statement behind an empty part moves into that part; a statement behind a
// part that holds its own belongs to none and is a mistake.
class Parts {
public:
  Parts(const ElementRule& rule, Findings& findings)
      : rule_(rule), findings_(findings) {}

  void take(Element&& child) {
    // A part begins; otherwise the child belongs to what came before.
    if (rule_.last_place(child.name) != 0)
      begin(std::move(child));
    else if (part_ == Part::none)
      children_.push_back(std::move(child));
    else if (part_ == Part::in_front)
      add(std::move(child));
    else if (!stray_)
      stray_ = Stray{std::move(child), children_.back().name};
  }

  // Reports at most one mistake of this kind for an element.
  std::vector<Element> finish() {
    if (!in_front_.empty() && around_)
      error(findings_, around_->position,
            tag(around_->name) + " holds its statements, and <" + in_front_ +
                "/> stands in front of them; write one " + tag(rule_.name) +
                " in one of both ways");
    else if (stray_)
      error(findings_, stray_->element.position,
            tag(stray_->element.name) + " stands behind " +
                tag(stray_->behind) + "; put it in front of that, or into it");
    return std::move(children_);
  }

private:
  enum class Part { none, around, in_front };
  struct Named {
    std::string name;
    Position position;
  };
  struct Stray {
    Element element;
    std::string behind;
  };

  // A part without children is written in front of its statements.
  void begin(Element&& part) {
    part_ = part.children.empty() ? Part::in_front : Part::around;
    if (part_ == Part::around && !around_)
      around_ = Named{part.name, part.position};
    children_.push_back(std::move(part));
  }
  void add(Element&& child) {
    in_front_ = children_.back().name;
    children_.back().children.push_back(std::move(child));
  }

  const ElementRule& rule_;
  Findings& findings_;
  std::vector<Element> children_;
  Part part_ = Part::none;      // how the latest part is written
  std::string in_front_;        // a part in front of its statements
  std::optional<Named> around_; // the first part around its statements
  std::optional<Stray> stray_;  // the first statement in no part
};

// Checks the children of one element in their order.
class Children {
public:
  Children(const Element& parent, const ElementRule& rule, Findings& findings)
      : parent_(parent), rule_(rule), findings_(findings) {}

  bool is_wrong(const Element& child) {
    return is_behind_the_last(child) || is_second(child);
  }

private:
  // The last children have places in order (LAST of the table); all others have
  // place 0. Places may only grow.
  bool is_behind_the_last(const Element& child) {
    const auto place = rule_.last_place(child.name);
    if (place >= place_) {
      place_ = place;
      last_ = child.name;
      return false;
    }
    error(findings_, child.position,
          tag(child.name) + " stands behind " + tag(last_) +
              "; put it in front of that" + (place == 0 ? ", or into it" : ""));
    return true;
  }

  // A child that the table allows only once and that was seen before.
  bool is_second(const Element& child) {
    if (!rule_.holds_once(child.name))
      return false;
    const auto [first, is_first] = seen_.emplace(child.name, child.position);
    if (!is_first)
      error(findings_, child.position,
            "a second " + tag(child.name) + " in " + tag(parent_.name) +
                ", after the one in line " +
                std::to_string(first->second.line) +
                "; put both into one, or take one out");
    return !is_first;
  }

  const Element& parent_;
  const ElementRule& rule_;
  Findings& findings_;
  std::size_t place_ = 0; // the highest place so far
  std::string last_;
  ByName<Position> seen_;
};

} // namespace

void gather_parts(Element& element, const ElementRule& rule,
                  Findings& findings) {
  if (!rule.in_parts)
    return;
  Parts parts(rule, findings);
  for (auto& child : element.children)
    parts.take(std::move(child));
  element.children = parts.finish();
}

void check_children(Element& element, const ElementRule& rule,
                    Findings& findings) {
  if (rule.once.empty() && rule.last.empty())
    return;
  Children children(element, rule, findings);
  std::erase_if(element.children,
                [&](const Element& child) { return children.is_wrong(child); });
}

} // namespace parlour::script
