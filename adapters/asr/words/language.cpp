#include "adapters/asr/words/language.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "adapters/asr/words/sentences.hpp"
#include "adapters/asr/words/spoken_words.hpp"
#include "adapters/nlu/grammar/examples.hpp"
#include "adapters/nlu/grammar/jsgf.hpp"
#include "adapters/nlu/grammar/marked_text.hpp"
#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::asr {

namespace {

constexpr std::array contracted{
    "i'm",    "i'd",      "i'll",     "i've",    "you're",  "you'd",  "you'll",
    "we're",  "we'd",     "we'll",    "we've",   "they're", "he's",   "she's",
    "it's",   "that's",   "there's",  "what's",  "where's", "who's",  "how's",
    "when's", "don't",    "doesn't",  "didn't",  "isn't",   "aren't", "can't",
    "won't",  "wouldn't", "couldn't", "haven't", "let's"};

// What is said counts more than what is drawn from grammars.
constexpr double weight_of_said = 20;
constexpr double weight_of_wording = 5;
constexpr std::uint64_t seed = 1;
// Utterances of several sentences, of those drawn.
constexpr std::size_t one_in = 4;

// Behind an empty move from the start: several graphs stand side by side.
void copy(const WordGraph& graph, GraphBuilder& to) {
  std::vector<GraphBuilder::State> states;
  for (std::size_t i = 0; i < graph.states.size(); ++i)
    states.push_back(to.add());
  to.link(GraphBuilder::start, states[0]);
  for (std::size_t i = 0; i < graph.states.size(); ++i) {
    for (const auto& arc : graph.states[i].arcs)
      to.take(states[i], states[arc.target], arc.symbol);
    if (graph.states[i].is_final)
      to.accept(states[i]);
  }
}

std::vector<Symbol> symbols_of(std::string_view text, Symbols& symbols) {
  std::vector<Symbol> made;
  for (const auto& word : spoken_words(text))
    made.push_back(symbols.word(word));
  return made;
}

// What stands in marked places may be said wherever their slots are open.
void add_marked(const nlu::MarkedText& marked, ValueSets& sets) {
  for (const auto& mark : marked.marks)
    sets.add(sets.open_set(mark.slot),
             std::string_view(marked.text)
                 .substr(mark.begin, mark.end - mark.begin));
}

} // namespace

// The order matters: forms and values come before the grammars that name them,
// and bare values last, when all sets are known.
Language::Language(const LanguageSources& sources) {
  ValueSets sets(sources.model, sources.columns, symbols_, spellings_);
  GrammarReader reader(symbols_, sets, spellings_);
  std::vector<Error> ignored;
  for (const auto* const both : contracted) {
    const auto words = spoken_words(nlu::contraction(both));
    if (words.size() == 2)
      contractions_.push_back({symbols_.word(words[0]), symbols_.word(words[1]),
                               symbols_.word(both)});
  }
  if (sources.forms)
    reader.add_forms(nlu::jsgf::parse(*sources.forms, ignored));
  for (const auto& topic : sources.model.topics)
    add_example_values(topic, sets);
  add_conversations(sources, sets);
  for (const auto& grammar : sources.model.grammars)
    add_grammar(grammar, reader);
  if (sources.generic) {
    GraphBuilder generic;
    reader.add(nlu::jsgf::parse(*sources.generic, ignored), generic);
    for (const auto phrase : nlu::filler_phrases())
      generic.add_sentence(symbols_of(phrase, symbols_));
    generic_ = generic.finish();
  }
  GraphBuilder examples;
  for (const auto& topic : sources.model.topics)
    add_examples(topic, reader, examples);
  for (const auto& line : said_)
    examples.add_sentence(line);
  parts_["<examples>"] = examples.finish();
  add_wordings(sources, sets);
  add_bare_values(sources.model, sets);
  sets_ = sets.graphs();
  put_together();
}

void Language::add_example_values(const TopicModel& topic, ValueSets& sets) {
  for (const auto& example : topic.examples)
    if (const auto marked = nlu::read_marks(example))
      add_marked(*marked, sets);
}

// A value that a conversation expects in a slot may be said in it.
void Language::add_conversations(const LanguageSources& sources,
                                 ValueSets& sets) {
  for (const auto& [slot, value] : sources.conversations.values)
    sets.add(sets.open_set(slot.substr(slot.rfind('.') + 1)), value);
  for (const auto& line : sources.conversations.lines) {
    auto words = symbols_of(line, symbols_);
    spellings_.note(line, true);
    if (!words.empty())
      said_.push_back(std::move(words));
  }
}

// Of unknown topics and slots there are none.
void Language::add_wordings(const LanguageSources& sources, ValueSets& sets) {
  for (const auto& wording : sources.wordings) {
    const auto topic = std::ranges::find(sources.model.topics, wording.topic,
                                         &TopicModel::name);
    const auto marked = nlu::read_marks(wording.text);
    if (topic == sources.model.topics.end() || !marked)
      continue;
    add_marked(*marked, sets);
    const std::string_view text = marked->text;
    std::vector<Symbol> sentence;
    std::size_t at = 0;
    const auto add_up_to = [&](std::size_t end) {
      const auto words = symbols_of(text.substr(at, end - at), symbols_);
      sentence.insert(sentence.end(), words.begin(), words.end());
      at = end;
    };
    for (const auto& mark : marked->marks) {
      const auto slot =
          std::ranges::find(topic->slots, mark.slot, &SlotModel::name);
      if (slot == topic->slots.end())
        continue;
      add_up_to(mark.begin);
      sentence.push_back(sets.set_of(*topic, *slot));
      at = mark.end;
    }
    add_up_to(text.size());
    wordings_.push_back(std::move(sentence));
  }
}

// Each grammar is a part of its own, so that a turn can be narrowed to it.
void Language::add_grammar(const GrammarModel& model, GrammarReader& reader) {
  std::vector<Error> ignored;
  const auto grammar = nlu::jsgf::parse(model, ignored);
  GraphBuilder whole;
  reader.add(grammar, whole);
  parts_[model.name] = whole.finish();
}

// As it was written and, by the rules that the understanding makes of it, with
// other values in the marked places.
void Language::add_examples(const TopicModel& topic, GrammarReader& reader,
                            GraphBuilder& to) {
  std::vector<Error> ignored;
  for (const auto& example : topic.examples) {
    if (const auto marked = nlu::read_marks(example)) {
      spellings_.note(marked->text, true);
      said_.push_back(symbols_of(marked->text, symbols_));
    }
    const auto rules = nlu::example_rules(topic, example, ignored);
    if (!rules.whole.children.empty())
      reader.add(rules.whole, to);
    for (const auto& part : rules.parts)
      reader.add(part, to);
  }
}

// Answers of one value.
void Language::add_bare_values(const UnderstandingModel& model,
                               ValueSets& sets) {
  for (const auto& topic : model.topics)
    for (const auto& slot : topic.slots) {
      GraphBuilder bare;
      bare.add_sentence({sets.set_of(topic, slot)});
      parts_[topic.name + "." + slot.name] = bare.finish();
    }
}

void Language::put_together() {
  for (const auto& [set, graph] : sets_)
    if (!parts_.contains(symbols_.text(set))) {
      GraphBuilder bare;
      bare.add_sentence({set});
      parts_[symbols_.text(set)] = bare.finish();
    }
  std::vector<const WordGraph*> all;
  for (const auto& [name, graph] : parts_)
    all.push_back(&graph);
  own_ = joined(all);
  all.push_back(&generic_);
  sentences_ = joined(all);
}

// Contractions are put in here, as they may reach from one part of a sentence
// to the next.
WordGraph Language::joined(const std::vector<const WordGraph*>& graphs) const {
  GraphBuilder builder(400'000);
  for (const auto* graph : graphs)
    if (!graph->states.empty())
      copy(*graph, builder);
  for (const auto& [first, second, both] : contractions_)
    builder.contract(first, second, both);
  return builder.finish();
}

// Unknown names are passed over where another one is known.
std::optional<WordGraph>
Language::sentences(const std::vector<std::string>& names) const {
  std::vector<const WordGraph*> found;
  for (const auto& name : names)
    if (const auto part = parts_.find(name); part != parts_.end())
      found.push_back(&part->second);
  if (found.empty())
    return {};
  found.push_back(&generic_);
  return joined(found);
}

FsgText Language::fsg(const WordGraph& graph) const {
  return fsg_text(graph, symbols_, sets_);
}

// Drawn with a fixed seed: equal sources give the same model.
TrigramCounts Language::counts(std::size_t count) const {
  TrigramCounts counts;
  auto sentences = cover_arcs(sentences_, seed);
  // The platform's grammar says yes in many ways; what the application is about
  // is said as often, however few rules it has.
  for (const auto* graph : {&sentences_, &own_})
    for (auto& sentence : draw_sentences(*graph, count, seed))
      sentences.push_back(std::move(sentence));
  auto drawn = fill_sets(sentences, symbols_, sets_, seed);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    // Every so often two in one breath.
    if (i % one_in == 0 && i > 0)
      drawn[i].insert(drawn[i].end(), drawn[i - 1].begin(), drawn[i - 1].end());
    counts.add(drawn[i]);
  }
  for (const auto& line : said_)
    counts.add(line, weight_of_said);
  for (const auto& line : fill_sets(wordings_, symbols_, sets_, seed + 2))
    counts.add(line, weight_of_wording);
  // Of large sets, what was not drawn.
  for (const auto& [set, values] : sets_) {
    const std::vector<Sentence> alone(values.arc_count(), Sentence{set});
    for (const auto& value : fill_sets(alone, symbols_, sets_, seed + 1))
      counts.add(value, 0.5);
  }
  counts.unite();
  return counts;
}

// A value set is that of a slot or a column: its name has a point. It has no
// ring, as each value is added by itself.
Language::Phrases Language::phrases(const WordGraph& graph,
                                    std::size_t most_values) const {
  Phrases made;
  std::set<Symbol> seen;
  for (const auto& state : graph.states)
    for (const auto& arc : state.arcs) {
      if (!seen.insert(arc.symbol).second)
        continue;
      const auto& text = symbols_.text(arc.symbol);
      const auto set = sets_.find(arc.symbol);
      if (!symbols_.is_set(arc.symbol))
        made.words.push_back(written(text));
      else if (set != sets_.end() && text.find('.') != std::string::npos)
        add_values(set->second, 0, "", most_values, made.values);
    }
  return made;
}

// Depth first, with the words so far in `before`.
void Language::add_values(const WordGraph& set, std::uint32_t state,
                          const std::string& before, std::size_t most,
                          std::vector<std::string>& values) const {
  if (set.states[state].is_final && values.size() < most)
    values.push_back(before);
  for (const auto& arc : set.states[state].arcs)
    if (values.size() < most && !symbols_.is_set(arc.symbol))
      add_values(set, arc.target,
                 before + (before.empty() ? "" : " ") +
                     written(symbols_.text(arc.symbol)),
                 most, values);
}

std::set<std::string> Language::words() const {
  std::set<std::string> words;
  for (Symbol symbol = 0; symbol < symbols_.size(); ++symbol)
    if (!symbols_.is_set(symbol))
      words.insert(symbols_.text(symbol));
  return words;
}

} // namespace parlour::adapters::asr
