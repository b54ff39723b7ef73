// Builds the model from two sources: the program, which knows the slots'
// properties, and the trees, which have the literal values and examples as
// text.

#include "script/compiler/understanding_builder.hpp"

#include <algorithm>

#include "runtime/base/text/utf8.hpp"
#include "runtime/text/phones.hpp"
#include "runtime/text/words.hpp"
#include "script/source/text_positions.hpp"
#include "script/xml/source_reader.hpp"

namespace parlour::script {

namespace {

class UnderstandingBuilder {
public:
  UnderstandingBuilder(const Program& program, const ApplicationLoader& loader,
                       Findings& findings)
      : program_(program), loader_(loader), findings_(findings) {}

  void add(const Element& root);
  std::shared_ptr<const UnderstandingModel> take() {
    return std::make_shared<const UnderstandingModel>(std::move(model_));
  }

private:
  void add_topic(const Element& element);
  SlotModel slot_model(const Slot& slot, const Element* element) const;
  void add_grammar(const Element& element);
  void read_grammar(GrammarModel& grammar, const Attribute& file);
  void add_pronunciation(const Element& element);

  const Program& program_;
  const ApplicationLoader& loader_;
  Findings& findings_;
  UnderstandingModel model_;
};

// The values that are written literally. Computed ones are known at run time
// only.
std::vector<std::string> literal_values(const Element* parent) {
  std::vector<std::string> values;
  if (parent)
    for (const auto& value : parent->children)
      if (!value.attribute("expr"))
        values.push_back(collapsed(value.text));
  return values;
}

const Element* slot_element(const Element& topic, const std::string& name) {
  for (const auto& child : topic.children)
    if (child.is("slot") && child.value("name") == name)
      return &child;
  return nullptr;
}

// What is computed is not known yet.
std::int64_t whole_number(const Element& element, const char* attribute) {
  return parse_number(element.value(attribute)).integer_or(0);
}

// Whether a <by> of the topic uses the slot.
bool narrows_query(const Topic& topic, std::size_t slot) {
  for (const auto& query : topic.queries)
    for (const auto& by : query.by)
      if (by.slot == slot)
        return true;
  return false;
}

// Values that are computed are missing here; the slot itself checks them.
SlotModel UnderstandingBuilder::slot_model(const Slot& slot,
                                           const Element* element) const {
  SlotModel model;
  model.name = slot.name;
  model.type = slot.cardinality.type;
  model.source = slot.cardinality.source;
  model.functional = slot.functional;
  model.many = slot.many;
  if (slot.part != no_id)
    model.type = "part";
  const auto* cardinality = element ? element->child("cardinality") : nullptr;
  model.values = literal_values(cardinality);
  if (cardinality && model.type == "range") {
    model.least = whole_number(*cardinality, "from");
    model.most = whole_number(*cardinality, "to");
  }
  return model;
}

// The tree of a duplicate topic is skipped; positions tell which one counts.
void UnderstandingBuilder::add_topic(const Element& element) {
  const auto id = program_.topic(element.value("name"));
  if (id == no_id || program_.topics[id].position != element.position)
    return;
  const auto& topic = program_.topics[id];
  TopicModel model;
  model.name = topic.name;
  model.enquiry = topic.kind == TopicKind::enquiry;
  model.part = topic.is_part;
  for (std::size_t i = 0; i < topic.slots.size(); ++i) {
    const auto& slot = topic.slots[i];
    model.slots.push_back(slot_model(slot, slot_element(element, slot.name)));
    model.slots.back().relevant_to_query = narrows_query(topic, i);
  }
  for (const auto& child : element.children)
    if (child.is("examples"))
      for (auto& example : literal_values(&child))
        model.examples.push_back(std::move(example));
  model_.topics.push_back(std::move(model));
}

// The file is registered in the findings, so that mistakes in it can be shown
// with their lines.
void UnderstandingBuilder::read_grammar(GrammarModel& grammar,
                                        const Attribute& file) {
  const auto path = loader_.inside(file.value);
  if (!path)
    return findings_.error(file.value_position, path.error().message);
  auto text = read_bytes(*path);
  if (!text)
    return findings_.error(file.value_position,
                           file.value + ": " + text.error().message);
  grammar.text = std::move(*text);
  grammar.place = {path->string(), 1, 1};
  const auto index = findings_.add_file(path->string());
  if (const auto invalid = find_invalid_utf8(grammar.text))
    findings_.error(TextPositions(grammar.text, index).at(*invalid),
                    "this is not UTF-8; save the file as UTF-8");
}

// A grammar is text in the element or in a file.
void UnderstandingBuilder::add_grammar(const Element& element) {
  GrammarModel grammar;
  grammar.name = element.value("name");
  if (const auto* file = element.attribute("file"))
    read_grammar(grammar, *file);
  else {
    // Only leading blanks are removed, so that each line of the text is as far
    // from the next as in the file, and errors of the grammar find their line.
    const auto first = element.text.find_first_not_of(" \t\r\n");
    grammar.text = first == std::string::npos ? "" : element.text.substr(first);
    grammar.place = findings_.place(element.text_position);
    if (grammar.text.empty())
      findings_.error(element.position, "<grammar> is empty; expected JSGF "
                                        "text or 'file'");
  }
  model_.grammars.push_back(std::move(grammar));
}

// A word may have several.
void UnderstandingBuilder::add_pronunciation(const Element& element) {
  const auto words = split_words(element.value("word"));
  const auto* phones = element.attribute("as");
  if (words.size() != 1)
    return findings_.error(element.position,
                           "<pronounce> is about one word; for a name of "
                           "several write one for each word");
  if (const auto wrong = mistake_in_phones(phones->value))
    return findings_.error(phones->value_position, *wrong);
  model_.pronunciations.push_back({words[0], tidy_phones(phones->value)});
}

void UnderstandingBuilder::add(const Element& root) {
  for (const auto& child : root.children) {
    if (child.is("topic"))
      add_topic(child);
    else if (child.is("grammar"))
      add_grammar(child);
    else if (child.is("pronounce") && child.attribute("as"))
      add_pronunciation(child);
  }
}

} // namespace

std::shared_ptr<const UnderstandingModel>
build_understanding(const std::vector<Document>& documents,
                    const Program& program, const ApplicationLoader& loader,
                    Findings& findings) {
  UnderstandingBuilder builder(program, loader, findings);
  for (const auto& document : documents)
    builder.add(document.root);
  return builder.take();
}

void collect_grammars(const Element& root, std::vector<std::string>& names,
                      Findings& findings) {
  for (const auto& child : root.children) {
    if (!child.is("grammar"))
      continue;
    const auto name = child.value("name");
    if (std::find(names.begin(), names.end(), name) != names.end())
      findings.error(child.position,
                     "there is a grammar '" + name + "' already");
    names.push_back(name);
  }
}

} // namespace parlour::script
