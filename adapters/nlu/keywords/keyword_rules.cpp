#include "adapters/nlu/keywords/keyword_rules.hpp"

#include <algorithm>
#include <utility>

#include <pugixml.hpp>

#include "runtime/message/act_kinds.hpp"

namespace parlour::adapters::nlu {

namespace {

// Words in the form in which texts are compared with them.
Words words_in(std::string_view text) {
  Words words;
  for (auto& token : tokenize(text).list)
    words.push_back(std::move(token.word));
  return words;
}

// Names in an error message, separated by commas.
template <class Names>
std::string listed(const Names& names) {
  std::string text;
  for (const auto& name : names)
    text += (text.empty() ? "" : ", ") + std::string(name);
  return text.empty() ? "none" : text;
}

// Reads the whole file and collects all errors.
class Reader {
public:
  Reader(std::string_view text, const std::string& file,
         const UnderstandingModel& model, const ColumnReader& columns)
      : text_(text), file_(file), schema_(model, columns, errors_) {}

  tl::expected<KeywordRules, std::vector<Error>> run() {
    pugi::xml_document document;
    // pugixml keeps offsets into the buffer, from which lines are counted.
    const auto read = document.load_buffer(text_.data(), text_.size());
    if (!read) {
      error(read.offset, std::string("this is no XML: ") + read.description());
      return tl::make_unexpected(errors_);
    }
    const auto root = document.document_element();
    if (std::string_view(root.name()) != "keywords")
      error(root, "the file's element is <keywords>, not <" +
                      std::string(root.name()) + ">");
    for (const auto child : root.children())
      if (is(child, "rule", "a <rule>"))
        read_rule(child);
    if (!errors_.empty())
      return tl::make_unexpected(errors_);
    return KeywordRules{std::move(schema_), std::move(rules_)};
  }

private:
  // Rules with errors are kept: the errors prevent their use.
  void read_rule(pugi::xml_node node) {
    check_attributes(node, {"topic", "act"});
    KeywordRule rule;
    rule.topic = topic_of(node);
    rule.act = act_of(node, rule.topic);
    for (const auto child : node.children())
      if (std::string_view(child.name()) == "slot")
        read_slot(child, rule);
      else if (is(child, "keyword", "a <keyword> or a <slot>"))
        read_keyword(child, rule);
    if (rule.keywords.empty())
      error(node, "a rule has at least one <keyword>");
    rules_.push_back(std::move(rule));
  }

  // A keyword may have several words, which must follow each other.
  void read_keyword(pugi::xml_node node, KeywordRule& rule) {
    check_attributes(node, {});
    auto words = words_in(node.child_value());
    if (words.empty())
      error(node, "this keyword has no word");
    else
      rule.keywords.push_back(std::move(words));
  }

  // Checks that the topic has the slot.
  void read_slot(pugi::xml_node node, KeywordRule& rule) {
    check_attributes(node, {"name", "after", "value"});
    if (rule.topic == no_topic) {
      // A rule with an unknown topic has been reported already.
      if (!node.parent().attribute("topic"))
        error(node, "a rule without a topic has no slots");
      return;
    }
    const std::string name = node.attribute("name").value();
    const auto& topic = schema_.at(rule.topic);
    const auto* known = topic.find(name);
    if (!known)
      return error(node, "the topic " + topic.name + " has no slot '" + name +
                             "'; there are " +
                             listed(schema_.slot_names(rule.topic)));
    KeywordSlot slot{
        name, known->entity, words_in(node.attribute("after").value()), {}};
    if (const auto value = node.attribute("value"))
      slot.value = value.value();
    check_slot(node, slot);
    rule.slots.push_back(std::move(slot));
  }

  void check_slot(pugi::xml_node node, const KeywordSlot& slot) {
    if (slot.value && !slot.after.empty())
      error(node, "a slot has a value or stands after something, not both");
    if (!slot.value && slot.after.empty() && slot.entity == words_entity)
      error(node, "any words can be the slot " + slot.name +
                      ": say what they stand after, or its value");
  }

  TopicNumber topic_of(pugi::xml_node node) {
    const auto attribute = node.attribute("topic");
    if (!attribute)
      return no_topic;
    const auto topic = schema_.topic(attribute.value());
    if (topic == no_topic)
      error(node, "there is no topic '" + std::string(attribute.value()) +
                      "'; there are " + listed(schema_.topic_names()));
    return topic;
  }

  // The act of a rule about a topic has a default.
  std::string act_of(pugi::xml_node node, TopicNumber topic) {
    std::string act = node.attribute("act").value();
    if (act.empty() && topic == no_topic && !node.attribute("topic"))
      error(node, "a rule has a topic, an act, or both");
    if (!act.empty() && !act_kind(act))
      error(node,
            "there is no act '" + act + "'; there are " + listed(act_names()));
    if (!act.empty() || topic == no_topic)
      return act;
    return schema_.at(topic).usual_act();
  }

  // Whether the node is the expected element. Reports another element; text and
  // comments may stand anywhere.
  bool is(pugi::xml_node node, std::string_view name, const char* expected) {
    if (node.type() != pugi::node_element)
      return false;
    if (node.name() == name)
      return true;
    error(node, "<" + std::string(node.name()) + "> is not known here; " +
                    expected + " is");
    return false;
  }

  // Reports attributes that the element does not have.
  void check_attributes(pugi::xml_node node,
                        const std::vector<std::string_view>& known) {
    for (const auto attribute : node.attributes())
      if (std::find(known.begin(), known.end(), attribute.name()) ==
          known.end())
        error(node, "<" + std::string(node.name()) + "> has no attribute '" +
                        attribute.name() + "'; there are " + listed(known));
  }

  void error(pugi::xml_node node, std::string message) {
    error(node.offset_debug(), std::move(message));
  }
  // Turns an offset into a line.
  void error(std::ptrdiff_t offset, std::string message) {
    const auto end = std::clamp<std::ptrdiff_t>(
        offset, 0, static_cast<std::ptrdiff_t>(text_.size()));
    const auto before = text_.substr(0, static_cast<std::size_t>(end));
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    errors_.push_back({ErrorKind::settings,
                       std::move(message),
                       {file_, static_cast<std::uint32_t>(line), 1}});
  }

  std::string_view text_;
  const std::string& file_;
  // Before the schema, whose constructor adds to it.
  std::vector<Error> errors_;
  Schema schema_;
  std::vector<KeywordRule> rules_;
};

} // namespace

tl::expected<KeywordRules, std::vector<Error>>
read_keyword_rules(std::string_view text, const std::string& file,
                   const UnderstandingModel& model,
                   const ColumnReader& columns) {
  return Reader(text, file, model, columns).run();
}

} // namespace parlour::adapters::nlu
