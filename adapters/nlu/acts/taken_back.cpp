#include "adapters/nlu/acts/taken_back.hpp"

#include <algorithm>
#include <string_view>

#include "adapters/nlu/text/word_set.hpp"
#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

// "leave out the chips", "a burger without chips", "cola instead of beer"
bool takes_back(std::string_view word, std::string_view before) {
  static const WordSet alone{"not",  "without", "scrap", "skip",
                             "drop", "forget",  "minus", "cancel"};
  return alone.contains(word) ||
         ((word == "out" || word == "off") && before == "leave") ||
         (word == "of" && before == "instead") ||
         (word == "than" && before == "rather") ||
         (word == "about" && before == "forget");
}

// "A burger and no beer": before a "no" that begins no clause.
bool leads_to_no(std::string_view word) {
  static const WordSet words{"no", "and",  "but",     "oh",
                             "so", "with", "actually"};
  return words.contains(word);
}

// Between a value and the one that takes its place: "no, sorry, I mean".
bool leads_to_another(std::string_view word) {
  static const WordSet words{"no", "sorry", "actually", "mean", "rather"};
  return words.contains(word);
}

// A value of a list, by the numbers of its act and fill.
struct Item {
  std::size_t act = 0;
  std::size_t fill = 0;
  bool is_denied = false;
  bool takes_back = false; // another one
  bool is_out = false;     // of its act
};

// "No, nothing else", "no, that's all": what was said is all that is wanted.
bool closes(const BuiltAct& last, const Utterance& utterance) {
  static const WordSet words{"nothing", "all",   "else",       "more",
                             "thanks",  "thank", "everything", "further"};
  const auto& list = utterance.tokens.list;
  return std::any_of(
      list.begin() + last.begin, list.end(),
      [](const Token& token) { return words.contains(token.word); });
}

// The last word, about no topic: "no, don't", "never mind". "I'd rather have
// nothing" only says why.
bool withdraws(const BuiltAct& last, const Utterance& utterance,
               const Context& context) {
  static const WordSet bare{"no", "nope", "nah", "not", "do", "dont", "never"};
  if (last.topic != no_topic ||
      utterance.has_content(last.end,
                            static_cast<std::uint32_t>(utterance.size())))
    return false;
  auto first = last.begin;
  while (first + 1 < last.end && utterance.tokens.list[first].word == "i")
    ++first;
  const bool is_asked =
      context.asked_topic != no_topic || !context.confirms.empty();
  return last.act == "cancel" || last.act == "abandon" ||
         (last.act == "deny" && !is_asked && !closes(last, utterance) &&
          bare.contains(utterance.tokens.list[first].word));
}

// "Two towels. Do I have to pay for them? No." answers that.
bool answers_between(const BuiltAct& act, const BuiltAct& last,
                     const Utterance& utterance) {
  const auto& list = utterance.tokens.list;
  return std::count_if(list.begin() + act.end, list.begin() + last.begin + 1,
                       [](const Token& token) {
                         return token.before == Break::sentence;
                       }) > 1;
}

// Of another sentence nothing that may be a question is withdrawn, "Where is
// the remote? Don't bring it.", and only an order with values called off: "My
// husband can do that. Drop it." is one wish.
bool is_withdrawn(const BuiltAct& act, const BuiltAct& last,
                  const Utterance& utterance, const Schema& schema) {
  if (act.topic == no_topic || schema.at(act.topic).enquiry ||
      act.end > last.begin)
    return false;
  const auto sentence =
      stretch_of(utterance.tokens, {last.begin, last.end}, Break::sentence);
  if (act.end > sentence.begin)
    return true;
  const bool has_value = std::ranges::any_of(
      act.fills, [](const Fill& fill) { return !fill.literal; });
  return act.act != "request" &&
         (last.act == "deny" ? !answers_between(act, last, utterance)
                             : has_value);
}

class TakenBack {
public:
  TakenBack(std::vector<BuiltAct>& acts, const Utterance& utterance,
            const Spans& spans, const Schema& schema, const Context& context)
      : acts_(acts), utterance_(utterance), spans_(spans), schema_(schema),
        context_(context) {}

  void run() {
    find_items();
    for (auto item = items_.begin(); item != items_.end(); ++item)
      judge(item);
    if (std::ranges::any_of(items_, &Item::is_out))
      change_acts();
  }

private:
  using Items = std::vector<Item>;

  const Fill& fill(const Item& item) const {
    return acts_[item.act].fills[item.fill];
  }
  TopicNumber topic(const Item& item) const {
    return acts_[item.act].topic;
  }

  // All values of lists, in the order of the utterance.
  void find_items() {
    for (std::size_t at = 0; at < acts_.size(); ++at) {
      const auto& act = acts_[at];
      const bool denies = act.act == "deny";
      if (act.topic == no_topic || act.negated ||
          (!denies && act.act != "inform" && act.act != "correct"))
        continue;
      for (std::size_t fill = 0; fill < act.fills.size(); ++fill)
        if (schema_.at(act.topic).takes_many(act.fills[fill].slot))
          items_.push_back({at, fill, denies || is_denied(act.fills[fill])});
    }
    std::ranges::stable_sort(
        items_, {}, [this](const Item& item) { return fill(item).begin; });
  }

  // A denied value takes back the last one that is the same, and needs no
  // saying any more.
  void judge(Items::iterator item) {
    if (item->is_denied) {
      const auto same =
          std::find_if(std::make_reverse_iterator(item), items_.rend(),
                       [&](const Item& other) {
                         return !other.is_denied && !other.is_out &&
                                are_same(fill(other), fill(*item));
                       });
      item->takes_back = same != items_.rend();
      if (item->takes_back)
        same->is_out = true;
      item->is_out = item->takes_back || acts_[item->act].act != "deny" ||
                     is_needless(*item);
    } else if (item != items_.begin()) {
      auto& before = *std::prev(item);
      before.is_out = before.is_out || is_replaced(fill(before), fill(*item));
    }
  }

  // Whether nothing was said of the topic before this utterance, which says
  // more of it.
  bool is_needless(const Item& denied) const {
    return !context_.goes_on(topic(denied)) &&
           std::ranges::any_of(items_, [&](const Item& item) {
             return !item.is_denied && topic(item) == topic(denied);
           });
  }

  // Whether the words right before it take it back. A "no" begins its clause,
  // and the value follows at once: "no, the towels" and "we have no towels" are
  // something else.
  bool is_denied(const Fill& value) const {
    const auto& tokens = utterance_.tokens.list;
    auto at = value.begin;
    while (at > 0 && tokens[at].before == Break::none &&
           is_determiner(tokens[at - 1].word))
      --at;
    if (at == 0 || tokens[at].before != Break::none)
      return false;
    const bool no_more = at > 1 && tokens[at - 1].word == "more" &&
                         tokens[at - 1].before == Break::none &&
                         tokens[at - 2].word == "no";
    const auto last = no_more ? at - 2 : at - 1;
    const auto word = std::string_view(tokens[last].word);
    const bool begins = last == 0 || tokens[last].before != Break::none;
    const auto before =
        begins ? std::string_view() : std::string_view(tokens[last - 1].word);
    return takes_back(word, before) || (word == "no" && at == value.begin &&
                                        (begins || leads_to_no(before)));
  }

  // Whether only words that mend stand between the two.
  bool is_replaced(const Fill& value, const Fill& next) const {
    const auto& tokens = utterance_.tokens.list;
    bool is_mended = false;
    for (auto at = value.end; at < next.begin; ++at) {
      const auto word = std::string_view(tokens[at].word);
      if (leads_to_another(word))
        is_mended = true;
      else if (!utterance_.filler[at] && !is_determiner(word) && word != "i" &&
               word != "make" && word != "it")
        return false;
    }
    return is_mended && value.slot == next.slot;
  }

  // What a rule writes, or one of a list.
  bool are_same(const Fill& one, const Fill& other) const {
    if (one.slot != other.slot)
      return false;
    if (one.literal || other.literal)
      return one.literal && other.literal && *one.literal == *other.literal;
    return one.span && other.span && !spans_[*one.span].values.empty() &&
           spans_[*one.span].entity == spans_[*other.span].entity &&
           spans_[*one.span].values == spans_[*other.span].values;
  }

  void change_acts() {
    std::vector<BuiltAct> made;
    for (std::size_t at = 0; at < acts_.size(); ++at) {
      auto denied = denied_of(at);
      const bool lost = take_out(at);
      if (!denied.fills.empty())
        made.push_back(std::move(denied));
      if (!lost || !acts_[at].fills.empty())
        made.push_back(std::move(acts_[at]));
    }
    acts_ = std::move(made);
  }

  // What an act that wants other values says not to be wanted, and was not said
  // before. What it wants is in addition, then.
  BuiltAct denied_of(std::size_t act) {
    auto denied = acts_[act];
    denied.act = "deny";
    denied.fills.clear();
    if (acts_[act].act == "deny" || !context_.goes_on(denied.topic))
      return denied;
    for (const auto& item : items_)
      if (item.act == act && item.is_denied && !item.takes_back)
        denied.fills.push_back(fill(item));
    if (!denied.fills.empty())
      acts_[act].act = "inform";
    return denied;
  }

  // Whether the act has lost a value.
  bool take_out(std::size_t act) {
    auto& fills = acts_[act].fills;
    std::vector<bool> out(fills.size());
    for (const auto& item : items_)
      if (item.act == act)
        out[item.fill] = item.is_out;
    std::size_t at = 0;
    return std::erase_if(fills, [&](const Fill&) { return out[at++]; }) > 0;
  }

  std::vector<BuiltAct>& acts_;
  const Utterance& utterance_;
  const Spans& spans_;
  const Schema& schema_;
  const Context& context_;
  Items items_;
};

} // namespace

bool leave_out_withdrawn(std::vector<BuiltAct>& acts,
                         const Utterance& utterance, const Schema& schema,
                         const Context& context) {
  if (acts.size() < 2 || !withdraws(acts.back(), utterance, context))
    return false;
  const auto last = acts.back();
  return std::erase_if(acts, [&](const BuiltAct& act) {
           return is_withdrawn(act, last, utterance, schema);
         }) > 0;
}

void leave_out_taken_back(std::vector<BuiltAct>& acts,
                          const Utterance& utterance, const Spans& spans,
                          const Schema& schema, const Context& context) {
  TakenBack(acts, utterance, spans, schema, context).run();
}

} // namespace parlour::adapters::nlu
