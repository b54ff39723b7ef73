#include "adapters/nlu/parse/islands.hpp"

#include <algorithm>

namespace parlour::adapters::nlu {

namespace {

// Replays the trace of a match. Tags are properly nested, so a stack of open
// tags is enough, of those with an extent; a tag takes effect when it closes.
class IslandReader {
public:
  IslandReader(const std::vector<Trace>& traces, const Spans& spans,
               const Automaton& automaton, const Schema& schema,
               const Context& context)
      : traces_(traces), spans_(spans), automaton_(automaton), schema_(schema),
        context_(context) {}

  // Nothing if the match makes no sense, or the context excludes it.
  std::optional<Island> read(const Match& match) {
    const auto& rule = automaton_.rules[match.rule];
    island_ = {&rule,      match.begin, match.end, match.score, match.covered,
               match.weak, false,       false,     "",          {},
               {}};
    // The reader is used for many matches; its vectors keep their memory.
    opened_.clear();
    seen_.clear();
    topic_ = rule.topic;
    walk(match.trace);
    for (const auto& trace : way_)
      follow(trace);
    if (!find_topics() || !allowed(rule))
      return {};
    return std::move(island_);
  }

private:
  struct Opened {
    std::uint32_t position = 0;
    // How many spans had been seen when the tag was opened.
    std::size_t spans = 0;
  };

  // Puts the trace, which is stored newest first, in order.
  void walk(std::uint32_t last) {
    way_.clear();
    for (auto at = last; at != 0; at = traces_[at].before)
      way_.push_back(traces_[at]);
    std::ranges::reverse(way_);
  }

  void follow(const Trace& trace) {
    switch (trace.kind) {
    case Trace::Kind::open:
      if (has_extent(automaton_.tags[trace.what].kind))
        opened_.push_back({trace.position, seen_.size()});
      return;
    case Trace::Kind::span:
      seen_.push_back(trace.what);
      return;
    case Trace::Kind::close:
      close(automaton_.tags[trace.what], trace.position);
    }
  }

  void close(const TagInfo& tag, std::uint32_t end) {
    Opened opened;
    if (has_extent(tag.kind) && !opened_.empty()) {
      opened = opened_.back();
      opened_.pop_back();
    }
    apply(tag, opened, end);
  }

  void apply(const TagInfo& tag, const Opened& opened, std::uint32_t end) {
    switch (tag.kind) {
    case TagKind::act:
      island_.act = tag.name;
      return;
    case TagKind::topic:
      topic_ = tag.topic;
      return;
    case TagKind::denies:
      island_.denies = true;
      return;
    case TagKind::asked:
      island_.asked = true;
      if (context_.waiting_topic != no_topic)
        fill(context_.waiting_slot, context_.waiting_topic, tag, opened, end);
      else
        fill(context_.asked_slot, context_.asked_topic, tag, opened, end);
      return;
    case TagKind::slot:
      fill(tag.name, tag.topic, tag, opened, end);
    }
  }

  // The value of the slot is the tag's own, or that of the last span within the
  // tag, or the words within the tag.
  void fill(const std::string& slot, TopicNumber topic, const TagInfo& tag,
            const Opened& opened, std::uint32_t end) {
    Fill made{slot, topic, {}, {}, opened.position, end, false};
    if (tag.has_value)
      made.literal = tag.value;
    else if (seen_.size() > opened.spans)
      made.span = seen_.back();
    // The words of the value, without titles and determiners.
    if (made.span) {
      made.begin = spans_[*made.span].core;
      made.end = spans_[*made.span].end;
    }
    made.open = is_open(made, spans_);
    island_.fills.push_back(std::move(made));
  }

  // Finds the topics that have all the slots. False if slots of different
  // topics are mixed.
  bool find_topics() {
    for (const auto& fill : island_.fills)
      if (fill.topic != no_topic && topic_ == no_topic)
        topic_ = fill.topic;
    // A topic by tag or grammar, or of a slot that names it, excludes all
    // others.
    if (topic_ != no_topic) {
      island_.topics = {topic_};
      return has_all(topic_);
    }
    if (island_.fills.empty())
      return true;
    for (TopicNumber topic = 0; topic < schema_.topics().size(); ++topic)
      if (has_all(topic))
        island_.topics.push_back(topic);
    return !island_.topics.empty();
  }

  bool has_all(TopicNumber topic) const {
    return std::ranges::all_of(island_.fills, [&](const Fill& fill) {
      return (fill.topic == no_topic || fill.topic == topic) &&
             schema_.at(topic).find(fill.slot);
    });
  }

  // If the context names a grammar, a value is not read from the generic acts.
  bool allowed(const RuleInfo& rule) const {
    return context_.grammar.empty() || !rule.generic || island_.fills.empty();
  }

  const std::vector<Trace>& traces_;
  const Spans& spans_;
  const Automaton& automaton_;
  const Schema& schema_;
  const Context& context_;
  Island island_;
  TopicNumber topic_ = no_topic;
  std::vector<Trace> way_;
  std::vector<Opened> opened_;
  // The spans so far.
  std::vector<std::uint32_t> seen_;
};

} // namespace

bool is_open(const Fill& fill, const Spans& spans) {
  return !fill.literal && !fill.is_name &&
         (!fill.span || spans[*fill.span].entity == words_entity);
}

bool is_unmatched(const Fill& fill, const Spans& spans) {
  return fill.span && spans[*fill.span].unmatched;
}

bool is_before_sentence(const Island& one, const Island& other,
                        const Tokens& tokens) {
  const auto sentence =
      stretch_of(tokens, {other.begin, other.end}, Break::sentence);
  return one.end <= sentence.begin;
}

const Fill* Island::find(std::string_view slot) const {
  const auto found = std::ranges::find(fills, slot, &Fill::slot);
  return found == fills.end() ? nullptr : &*found;
}

std::vector<Island> read_islands(const std::vector<Match>& matches,
                                 const std::vector<Trace>& traces,
                                 const Spans& spans, const Automaton& automaton,
                                 const Schema& schema, const Context& context) {
  IslandReader reader(traces, spans, automaton, schema, context);
  std::vector<Island> islands;
  islands.reserve(matches.size());
  for (const auto& match : matches)
    if (auto island = reader.read(match))
      islands.push_back(std::move(*island));
  return islands;
}

} // namespace parlour::adapters::nlu
