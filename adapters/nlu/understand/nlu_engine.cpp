// Building: all sources of rules go into one automaton, then the examples are
// learnt, which needs the automaton's vocabulary. Understanding: see
// NluEngine::understand.
#include "adapters/nlu/understand/nlu_engine.hpp"

#include <algorithm>
#include <future>
#include <utility>

#include <fmt/format.h>

#include "adapters/nlu/acts/act_value.hpp"
#include "adapters/nlu/acts/acts.hpp"
#include "adapters/nlu/acts/choice.hpp"
#include "adapters/nlu/acts/correction.hpp"
#include "adapters/nlu/acts/courtesies.hpp"
#include "adapters/nlu/acts/taken_back.hpp"
#include "adapters/nlu/grammar/merged_states.hpp"
#include "adapters/nlu/parse/island_filters.hpp"
#include "adapters/nlu/parse/open_words.hpp"
#include "adapters/nlu/parse/preferences.hpp"
#include "adapters/nlu/parse/unmatched_values.hpp"
#include "adapters/nlu/text/words.hpp"
#include "adapters/nlu/understand/better_reading.hpp"
#include "adapters/nlu/understand/explanation.hpp"
#include "adapters/nlu/understand/heard_texts.hpp"
#include "adapters/nlu/understand/hypotheses.hpp"
#include "adapters/nlu/understand/left_sentences.hpp"
#include "adapters/nlu/understand/likeness.hpp"
#include "adapters/nlu/understand/rule_sources.hpp"

namespace parlour::adapters::nlu {

namespace {

// How close to the best score an alternative is. It is less than what the
// context is worth, so that of equals the expected topic wins. Scores are sums
// of decimals, hence a tolerance.
constexpr double alternative_range = 0.1;
constexpr double tolerance = 1e-6;
// How much lower the score of a chain about another topic may be.
constexpr double fit_range = 0.35;
// Of what the rules say, so many sentences are remembered.
constexpr std::size_t rule_sentences = 8000;
// What was learnt must reach beside other sentences.
constexpr double likely_by_itself = 0.7;

// Acts about other topics that score almost as high as the best one. The engine
// may ask the user which was meant.
struct Alternatives {
  std::vector<BuiltAct> acts;
  // They say the same of the same slot, so the dialogue engine chooses the
  // topic.
  bool same_slots = false;
};

double coverage_of(const Chain& chain, const Utterance& utterance) {
  double covered = 0;
  for (const auto& link : chain.links)
    covered += link.island->covered;
  const auto all = utterance.weight_of(0, utterance.size());
  return all > 0 ? covered / all : 0;
}

// The same slots from the same words.
bool equal_slots(const BuiltAct& left, const BuiltAct& right) {
  return left.act == right.act && left.fills.size() == right.fills.size() &&
         std::ranges::equal(left.fills, right.fills, {}, &Fill::slot,
                            &Fill::slot) &&
         std::ranges::equal(left.fills, right.fills, {}, &Fill::begin,
                            &Fill::begin) &&
         std::ranges::equal(left.fills, right.fills, {}, &Fill::end,
                            &Fill::end);
}

// Only a chain of exactly one act is an alternative.
void add_alternative(Alternatives& alternatives, const BuiltAct& best,
                     std::vector<BuiltAct> acts) {
  if (acts.size() != 1 || acts[0].topic == no_topic ||
      acts[0].topic == best.topic ||
      acts[0].score < best.score - alternative_range + tolerance)
    return;
  alternatives.same_slots =
      alternatives.same_slots ||
      (equal_slots(best, acts[0]) && acts[0].score == best.score);
  alternatives.acts.push_back(std::move(acts[0]));
}

// Puts the alternatives into the act, or leaves its topic open.
void add_alternatives(Understanding& made, const Alternatives& alternatives,
                      const Utterance& utterance, const Spans& spans,
                      const Schema& schema) {
  if (made.acts.size() != 1 || alternatives.acts.empty())
    return;
  auto first = *made.acts[0].if_map();
  List others;
  for (const auto& act : alternatives.acts)
    others.push_back(act_value(act, utterance, spans, schema));
  if (alternatives.same_slots)
    first.set(act_key::topic, Value());
  else
    first.set(act_key::alternatives, std::move(others));
  made.acts[0] = std::move(first);
}

} // namespace

// What does not hang on the values that columns have just now.
struct NluEngine::Taught {
  TrainedModel learned;
  Likeness likeness;
};

// Everything that was built. It does not change any more.
struct NluEngine::Implementation {
  Schema schema;
  Automaton automaton;
  std::shared_ptr<const Taught> taught;
  double threshold;

  // The entities to look for: those of the grammars, and those of the context.
  std::vector<EntityId> entities(const Context& context) const {
    auto all = automaton.entities;
    all.push_back(context.asked_entity_id);
    for (const auto& slot : context.said)
      all.push_back(slot.entity);
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  std::vector<BuiltAct> acts_of(const Chain& chain, const Utterance& utterance,
                                const Context& context) const {
    return build_acts(chain, utterance, schema, context, threshold);
  }

  // If the context names one grammar, examples are not used. The last resort,
  // where nothing else is understood, is what the utterance is most like.
  std::vector<BuiltAct> hypotheses(const Utterance& utterance, Spans& spans,
                                   const Context& context,
                                   bool nothing_else) const {
    if (!context.grammar.empty())
      return {};
    auto made = hypothesised_acts(taught->learned, utterance, spans, schema,
                                  context, threshold);
    if (made.empty() && nothing_else)
      made = taught->likeness.acts(utterance, spans,
                                   taught->learned.words(utterance, spans),
                                   schema, context, threshold);
    return made;
  }

  void add(const BuiltAct& act, const Utterance& utterance, const Spans& spans,
           Understanding& made) const {
    made.score = std::max(made.score, act.score);
    made.acts.push_back(act_value(act, utterance, spans, schema));
  }

  // What a sentence means of which rules understood nothing, if many wordings
  // were learnt, and it is likely. The act's words are those of the sentence.
  void add_left_sentences(const Utterance& said,
                          const std::vector<BuiltAct>& acts,
                          const Context& context, Understanding& made) const {
    if (!taught->learned.is_well_taught())
      return;
    for (const auto sentence : left_sentences(said, acts)) {
      const auto utterance = make_utterance(sentence, automaton);
      Spans spans(schema, utterance, entities(context), context.now);
      const auto found = hypotheses(utterance, spans, context, false);
      if (!found.empty() && found[0].topic != no_topic &&
          found[0].score >= likely_by_itself)
        add(found[0], utterance, spans, made);
    }
  }

  // The chains that end in other topics and score nearly as high.
  Alternatives other_chains(const std::vector<Chain>& chains,
                            const BuiltAct& best, const Utterance& utterance,
                            const Context& context) const {
    Alternatives alternatives;
    for (std::size_t at = 1;
         at < chains.size() && chains[at].score >= chains[0].score - fit_range;
         ++at)
      add_alternative(alternatives, best,
                      acts_of(chains[at], utterance, context));
    return alternatives;
  }

  std::vector<std::string>
  explain(const Utterance& utterance, const Spans& spans,
          const std::vector<Island>& islands, const std::vector<Chain>& chains,
          const std::vector<BuiltAct>& acts, bool is_other_talk) const {
    const Explanation explanation(utterance, spans, schema);
    auto lines = explanation.lines(islands, chains, acts);
    const auto learnt = explanation.learnt(taught->learned);
    const auto before_acts = [&] {
      return lines.end() - static_cast<std::ptrdiff_t>(acts.size());
    };
    lines.insert(before_acts(), learnt.begin(), learnt.end());
    for (const auto& like : taught->likeness.likes(
             utterance, taught->learned.words(utterance, spans)))
      lines.insert(before_acts(),
                   fmt::format("alike {:.2f} {} \"{}\"", like.similarity,
                               schema.at(like.meaning.topic).name,
                               like.sentence));
    if (is_other_talk)
      lines.emplace_back("more like other talk than like any rule");
    return lines;
  }
};

NluEngine::NluEngine(std::shared_ptr<const Implementation> implementation)
    : implementation_(std::move(implementation)) {}

Expected<NluEngine::SharedTaught>
NluEngine::teach(const UnderstandingModel& model, const Schema& schema,
                 const Automaton& automaton, const Options& options) {
  const auto sentences = sample_sentences(automaton, schema, rule_sentences);
  return TrainedModel::train(model.topics, schema, automaton, options.threshold,
                             {}, options.language,
                             {options.wordings, sentences, options.other_talk})
      .map([&](TrainedModel learned) -> SharedTaught {
        return std::make_shared<const Taught>(
            Taught{std::move(learned),
                   Likeness(automaton, sentences, options.other_talk)});
      });
}

tl::expected<NluEngine, std::vector<Error>>
NluEngine::build(const UnderstandingModel& model, const ColumnReader& columns,
                 const Options& options, const NluEngine* taught) {
  std::vector<Error> errors;
  Schema schema(model, columns, errors);
  AutomatonBuilder builder(schema, errors);
  add_rules(model, options.generic, schema, builder, errors);
  const auto unmerged = builder.finish();
  if (!errors.empty())
    return tl::make_unexpected(std::move(errors));
  // Both take long, and neither needs what the other makes.
  auto merged = std::async(std::launch::async, merge_states, unmerged);
  auto known = taught ? Expected<SharedTaught>(taught->implementation_->taught)
                      : teach(model, schema, unmerged, options);
  auto automaton = merged.get();
  if (!known)
    return tl::make_unexpected(std::vector{known.error()});
  for (const auto word : all_hesitations())
    if (schema.values().has_word(word))
      automaton.own_hesitations.emplace(word);
  // Not before: what is learnt is learnt of the words of the examples.
  add_synonyms(
      options.synonyms,
      [&](auto word) { return schema.values().has_word(word); }, automaton);
  schema.add_synonyms(options.synonyms);
  return NluEngine(std::shared_ptr<const Implementation>(
      new Implementation{std::move(schema), std::move(automaton),
                         std::move(*known), options.threshold}));
}

Understanding NluEngine::understand(std::string_view text, const Value& context,
                                    bool explain) const {
  auto best = read(text, context, explain);
  const auto others = other_texts(context, text);
  if (others.empty() || is_settled(best))
    return best;
  Understanding chosen;
  for (const auto& other : others)
    if (auto made = read(other, context, explain);
        makes_more_sense(made, best, context) &&
        (chosen.acts.empty() || made.score > chosen.score))
      chosen = std::move(made);
  if (chosen.acts.empty())
    return best;
  make_doubtful(chosen);
  return chosen;
}

namespace {

// Each of these sees what the ones before it have left.
void leave_out_what_nobody_means(std::vector<Island>& islands,
                                 const Utterance& utterance, const Spans& spans,
                                 const Schema& schema, const Context& context) {
  leave_out_guesses(islands, spans, schema);
  leave_out_unnamed(islands, utterance, spans);
  leave_out_strangers(islands, utterance, spans, context);
  leave_out_pieces_of_values(islands, spans);
  leave_out_lookalikes(islands, utterance, spans, context);
  leave_out_unlikely_values(islands, utterance, spans, schema, context);
  leave_out_stories(islands, utterance, spans, context);
  leave_out_acts_inside(islands, utterance, spans);
  trust_whole_values(islands, utterance, spans);
  leave_out_parts(islands, schema, context);
  prefer_answers(islands, context);
  prefer_application(islands);
  prefer_literals(islands, spans);
  drop_implausible(islands, utterance, spans);
}

bool is_one_far_fetched(const std::vector<BuiltAct>& acts,
                        const Utterance& utterance, const Spans& spans,
                        const Context& context) {
  return std::ranges::any_of(acts, [&](const BuiltAct& act) {
    return is_far_fetched(act, utterance, spans, context);
  });
}

void apply_corrections(std::vector<BuiltAct>& acts, const Utterance& utterance,
                       const Spans& spans, const Schema& schema,
                       const Context& context) {
  for (auto& act : acts)
    correct_what_was_said(act, spans, context);
  join_corrections(acts, schema);
  leave_out_taken_back(acts, utterance, spans, schema, context);
}

} // namespace

Understanding NluEngine::read(std::string_view text, const Value& context_value,
                              bool explain) const {
  const auto& self = *implementation_;
  const auto& schema = self.schema;
  const auto& [learned, likeness] = *self.taught;
  // The stages, each on the result of the one before:
  //  tokens -> spans (values) -> matches (rules) -> islands (meaning)
  //  -> chains -> acts, completed by hypotheses of the examples
  const auto context = read_context(context_value, schema);
  const auto utterance = make_utterance(text, self.automaton);
  Spans spans(schema, utterance, self.entities(context), context.now);
  Matcher matcher(self.automaton, utterance, spans, context.asked_entity_id,
                  context.grammar);
  auto islands = read_islands(matcher.run(), matcher.traces(), spans,
                              self.automaton, schema, context);
  leave_out_what_nobody_means(islands, utterance, spans, schema, context);
  auto chains = best_chains(islands, utterance.size(), context);
  auto acts = self.acts_of(chains[0], utterance, context);
  if (is_one_far_fetched(acts, utterance, spans, context)) {
    leave_out_unknown_values(islands, spans);
    chains = best_chains(islands, utterance.size(), context);
    acts = self.acts_of(chains[0], utterance, context);
  }
  const auto choice = choice_of(utterance, context);
  if (choice)
    acts = {*choice};
  // Only if grammars left something open.
  std::vector<BuiltAct> hypotheses;
  const auto meant = without_courtesies(utterance, chains[0], context);
  const BetterReading better(schema, context, meant, spans,
                             learned.is_well_taught());
  if (!choice && better.leaves_open(acts))
    hypotheses =
        self.hypotheses(meant, spans, context, better.are_openings(acts));
  const bool guessed =
      !hypotheses.empty() && better.choose(acts, hypotheses[0]);
  const bool is_other =
      !(guessed && learned.is_well_taught()) &&
      likeness.leave_out_other_talk(acts, meant, spans, learned, context);
  apply_corrections(acts, utterance, spans, schema, context);
  Understanding made;
  made.work = matcher.work();
  made.coverage = guessed ? 0 : coverage_of(chains[0], utterance);
  if (explain)
    made.explanation =
        self.explain(utterance, spans, islands, chains, acts, is_other);
  for (const auto& act : acts)
    self.add(act, utterance, spans, made);
  self.add_left_sentences(meant, acts, context, made);
  // Alternatives come from the source that was chosen.
  if (guessed)
    add_alternatives(made, {{hypotheses.begin() + 1, hypotheses.end()}, false},
                     utterance, spans, schema);
  else if (!choice && acts.size() == 1 && acts[0].topic != no_topic)
    add_alternatives(made,
                     self.other_chains(chains, acts[0], utterance, context),
                     utterance, spans, schema);
  return made;
}

} // namespace parlour::adapters::nlu
