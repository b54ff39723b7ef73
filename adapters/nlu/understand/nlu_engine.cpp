// Building: all sources of rules go into one automaton, whose vocabulary the
// examples are learnt with. Understanding: see NluEngine::understand.
#include "adapters/nlu/understand/nlu_engine.hpp"

#include <algorithm>
#include <future>
#include <iterator>
#include <utility>

#include "adapters/nlu/acts/act_value.hpp"
#include "adapters/nlu/acts/acts.hpp"
#include "adapters/nlu/acts/correction.hpp"
#include "adapters/nlu/acts/courtesies.hpp"
#include "adapters/nlu/acts/named_slot.hpp"
#include "adapters/nlu/acts/parts_of_values.hpp"
#include "adapters/nlu/acts/taken_back.hpp"
#include "adapters/nlu/grammar/merged_states.hpp"
#include "adapters/nlu/parse/clause_filters.hpp"
#include "adapters/nlu/parse/island_filters.hpp"
#include "adapters/nlu/parse/mentions.hpp"
#include "adapters/nlu/parse/number_filters.hpp"
#include "adapters/nlu/parse/open_words.hpp"
#include "adapters/nlu/parse/preferences.hpp"
#include "adapters/nlu/parse/unmatched_values.hpp"
#include "adapters/nlu/text/words.hpp"
#include "adapters/nlu/understand/alternatives.hpp"
#include "adapters/nlu/understand/better_reading.hpp"
#include "adapters/nlu/understand/explanation.hpp"
#include "adapters/nlu/understand/heard_texts.hpp"
#include "adapters/nlu/understand/hypotheses.hpp"
#include "adapters/nlu/understand/likeness.hpp"
#include "adapters/nlu/understand/rule_sources.hpp"
#include "adapters/nlu/understand/sentences_apart.hpp"

namespace parlour::adapters::nlu {

namespace {

// How much lower the score of a chain about another topic may be.
constexpr double fit_range = 0.35;
// Of what the rules say, so many sentences are remembered.
constexpr std::size_t rule_sentences = 8000;
// What was learnt must reach beside sentences about nothing, beside others.
constexpr double likely_by_itself = 0.7;
constexpr double likely_beside_others = 0.9;
// Where rules understood less of a question, it may be read by itself.
constexpr double mostly_understood = 0.75;

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

  Spans spans_of(const Utterance& utterance, const Context& context) const {
    return {schema,      utterance,     entities(context),
            context.now, context.heard, !context.choices.empty()};
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

  // What a sentence means by itself, if what was learnt finds that likely. The
  // act's words are those of the sentence.
  void add_left_sentence(std::string_view sentence, double likely,
                         const Context& context, Understanding& made) const {
    const auto utterance = make_utterance(sentence, automaton);
    auto spans = spans_of(utterance, context);
    const auto found = hypotheses(utterance, spans, context, false);
    if (!found.empty() && found[0].topic != no_topic &&
        found[0].score >= likely)
      add(found[0], utterance, spans, made);
  }

  // Whether other acts than this one are about the same.
  bool is_said_by_others(const Understanding& read, std::size_t act,
                         const std::vector<BuiltAct>& acts) const {
    return std::ranges::all_of(read.acts, [&](const Value& one) {
      const auto topic = schema.topic(one[act_key::topic].text());
      for (std::size_t i = 0; i < acts.size(); ++i)
        if (i != act && acts[i].topic == topic)
          return true;
      return false;
    });
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
    const auto more = explanation.learnt(taught->learned, taught->likeness);
    lines.insert(lines.end() - std::ssize(acts), more.begin(), more.end());
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
  leave_out_counts(islands, utterance, spans);
  leave_out_past_orders(islands, utterance, schema);
  leave_out_small_numbers(islands, utterance, spans, schema, context);
  leave_out_rivals_of_answers(islands, spans, context);
  leave_out_lookalikes(islands, utterance, spans, context);
  leave_out_unlikely_values(islands, utterance, spans, schema, context);
  leave_out_stories(islands, utterance, spans, context);
  leave_out_mentions(islands, utterance);
  leave_out_acts_inside(islands, utterance, spans);
  trust_whole_values(islands, utterance, spans);
  leave_out_parts(islands, schema, context);
  prefer_answers(islands, context);
  prefer_application(islands);
  prefer_literals(islands, spans);
  drop_implausible(islands, utterance, spans);
}

// More than a value, and of a question most of the words.
bool is_understood(const BuiltAct& act, bool is_question) {
  return !act.elliptical && (!is_question || act.score >= mostly_understood);
}

bool is_about_one(const std::vector<BuiltAct>& acts) {
  return acts.size() == 1 && acts[0].topic != no_topic;
}

bool is_one_far_fetched(const std::vector<BuiltAct>& acts,
                        const Utterance& utterance, const Spans& spans,
                        const Context& context) {
  return std::ranges::any_of(acts, [&](const BuiltAct& act) {
    return is_far_fetched(act, utterance, spans, context);
  });
}

// Whether all that was wanted is taken back.
bool apply_corrections(std::vector<BuiltAct>& acts, const Utterance& utterance,
                       Spans& spans, const Schema& schema,
                       const Context& context) {
  join_parts_of_values(acts, utterance, spans);
  for (auto& act : acts)
    correct_what_was_said(act, spans, context);
  join_corrections(acts, schema);
  leave_out_taken_back(acts, utterance, spans, schema, context);
  return leave_out_withdrawn(acts, utterance, schema, context);
}

} // namespace

Understanding NluEngine::read(std::string_view text, const Value& context_value,
                              bool explain) const {
  const auto& self = *implementation_;
  const auto& schema = self.schema;
  const auto& [learned, likeness] = *self.taught;
  // tokens -> spans (values) -> matches (rules) -> islands (meaning) -> chains
  // -> acts, completed by hypotheses of the examples
  const auto context = read_context(context_value, schema);
  const auto utterance = make_utterance(text, self.automaton);
  auto spans = self.spans_of(utterance, context);
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
  const auto choice = choice_or_named_slot(utterance, context);
  if (choice)
    acts = {*choice};
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
  const bool is_withdrawn =
      apply_corrections(acts, utterance, spans, schema, context);
  Understanding made;
  made.is_learnt = guessed;
  made.work = matcher.work();
  made.coverage = guessed ? 0 : chains[0].coverage(utterance);
  if (explain)
    made.explanation =
        self.explain(utterance, spans, islands, chains, acts, is_other);
  for (const auto& act : acts)
    self.add(act, utterance, spans, made);
  if (!is_withdrawn)
    read_sentences(meant, acts, context_value, made);
  // Alternatives come from the source that was chosen.
  if (guessed)
    add_alternatives(made, {{hypotheses.begin() + 1, hypotheses.end()}, false},
                     utterance, spans, schema);
  else if (!made.is_learnt && !choice && is_about_one(acts))
    add_alternatives(made,
                     self.other_chains(chains, acts[0], utterance, context),
                     utterance, spans, schema);
  return made;
}

// Sentences of which rules understood nothing, or what was learnt knows better.
void NluEngine::read_sentences(const Utterance& meant,
                               const std::vector<BuiltAct>& acts,
                               const Value& context_value,
                               Understanding& made) const {
  const auto sentences =
      sentences_apart(meant, made.is_learnt ? std::vector<BuiltAct>() : acts);
  if (sentences.empty() || !implementation_->taught->learned.is_well_taught())
    return;
  if (made.is_learnt)
    return read_alone(sentences, context_value, made);
  const bool any_says_what = std::ranges::any_of(
      acts, [](const BuiltAct& act) { return act.topic != no_topic; });
  const auto context = read_context(context_value, implementation_->schema);
  std::vector<List> instead(acts.size());
  const auto needed = any_says_what ? likely_beside_others : likely_by_itself;
  for (const auto& [text, said, is_question] : sentences) {
    if (said.empty() && (is_question || !any_says_what))
      implementation_->add_left_sentence(text, needed, context, made);
    if (said.size() != 1 || is_understood(acts[said[0]], is_question))
      continue;
    auto alone = read(text, context_value, false);
    if (!alone.is_learnt ||
        alone.score < (is_question ? likely_by_itself : likely_beside_others) ||
        implementation_->is_said_by_others(alone, said[0], acts))
      continue;
    instead[said[0]] = std::move(alone.acts);
    made.is_learnt = true;
    made.score = std::max(made.score, alone.score);
  }
  List all;
  for (std::size_t i = 0; i < made.acts.size(); ++i)
    if (i < instead.size() && !instead[i].empty())
      all.insert(all.end(), instead[i].begin(), instead[i].end());
    else
      all.push_back(std::move(made.acts[i]));
  made.acts = std::move(all);
  if (made.acts.empty())
    read_alone(sentences, context_value, made);
}

// "Not before evening? Then a coffee it is": by rules, and courtesies aside. Or
// beside a question that was learnt: "I arrive tomorrow, my booking number is
// 4733. Could you check which kind of room I've got?"
void NluEngine::read_alone(const std::vector<SentenceApart>& sentences,
                           const Value& context, Understanding& made) const {
  List alone;
  for (const auto& sentence : sentences)
    if (auto one = read(sentence.text, context, false); !one.is_learnt)
      for (auto& act : one.acts)
        if (is_said_alone(act, made.acts)) {
          made.score =
              std::max(made.score, act[act_key::confidence].number_or(0));
          alone.push_back(std::move(act));
        }
  put_before(std::move(alone), made.acts);
}

} // namespace parlour::adapters::nlu
