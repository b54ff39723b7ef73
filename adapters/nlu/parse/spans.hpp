// Finds the places in an utterance where a value stands, for each entity that
// the grammars mention.
#pragma once

#include <span>
#include <vector>

#include "adapters/nlu/grammar/utterance.hpp"
#include "adapters/nlu/values/schema.hpp"

namespace parlour::adapters::nlu {

// From this confidence on the words are the value's own; below the other one,
// they only sound or look like it.
inline constexpr float certain_value = 0.95F;
inline constexpr float guessed_value = 0.9F;

// A value at a place of the utterance.
struct Span {
  EntityId entity = words_entity;
  // Tokens, including titles and determiners before the value.
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  // The token at which the value itself begins.
  std::uint32_t core = 0;
  // Of a normal form.
  Value value;
  // Of a set: the values that fit equally well.
  std::vector<std::uint32_t> values;
  float confidence = 1;
  // Counts only where a value of this entity is expected.
  bool weak = false;
  // Words in the place of a value, of which the set has none.
  bool unmatched = false;
  // Words that sound like a name as a whole (heard_names).
  bool only_heard = false;
  // Added to the score of a match.
  float gain = 0;
  // Added to the share of the utterance that is understood.
  float covered = 0;

  // Whether the words are those of a known value.
  bool is_certain() const {
    return !unmatched && confidence >= certain_value;
  }
};

// Built for one utterance. Refers to schema and utterance, which must outlive
// it. Spans are addressed by index, since open() adds to the list.
class Spans {
public:
  // `entities` are those that the grammars mention, sorted. Of what was
  // `heard`, and not written, words may be names that only sound like them, and
  // whole names others of the same sound; not while one is chosen of several.
  Spans(const Schema& schema, const Utterance& utterance,
        const std::vector<EntityId>& entities, Now now, bool heard = false,
        bool chooses = false);

  // Indices of spans, valid until more are opened.
  using Indices = std::span<const std::uint32_t>;

  // The spans of known values of this entity that begin at `position`.
  Indices at(EntityId entity, std::size_t position) const;
  // The bits of all entities of which a known value begins there.
  std::uint64_t entities_at(std::size_t position) const {
    return entities_[position];
  }

  // The spans of words that are no known value, one for each length up to
  // `most` words. For any words (words_entity) they are the value. For a set
  // they are an unknown value; no span begins at or inside a known value.
  // For a normal form they are numbers that are not of this form: "25:00" for a
  // time.
  Indices open(EntityId entity, std::size_t position, std::size_t most);

  // The same words, of which only these values are meant. The new span is in
  // all(), but at() does not find it.
  std::uint32_t with_values(std::uint32_t index,
                            std::vector<std::uint32_t> values);

  // The words from `position` on, whatever they mean: up to each word of the
  // clause, but no more than a sentence has.
  Indices rest(std::size_t position);
  // Whether open() may find words there for any entity but a normal form.
  bool may_open(std::size_t position) const;
  const Span& operator[](std::uint32_t index) const {
    return spans_[index];
  }
  const std::vector<Span>& all() const {
    return spans_;
  }

private:
  void add_forms(const std::vector<EntityId>& entities, Now now);
  void add_values(const std::vector<EntityId>& entities, bool with_same_sound);
  void add_heard_names(const std::vector<EntityId>& entities);
  void add_heard_name(EntityId entity, ValueMatch&& match);
  void add(Span span);
  void order();
  Indices all_at(std::size_t position) const;
  void lean_on_time_before(Value& time) const;
  void mark_plain(const Span& span);
  // Whether a value of any set begins here and is clearly meant.
  bool is_known(std::size_t position) const;
  bool inside_name(std::size_t position) const;
  bool value_near(EntityId entity, std::size_t first, std::size_t last) const;
  std::size_t behind_leading(std::size_t position) const;
  // They add what is open there to spans_.
  void make_open(EntityId entity, std::size_t position, std::size_t most);
  void open_words(EntityId entity, std::size_t position, std::size_t most);
  void open_number(EntityId entity, std::size_t position, std::size_t most);
  void rest_of_clause(std::size_t position);
  float open_gain(std::size_t position) const;

  // What open() has returned, for the next call with the same arguments.
  struct Opened {
    EntityId entity;
    std::size_t most;
    std::size_t begin; // in indices_
    std::size_t count;
    std::size_t before; // the one before at this position; 0: none
  };

  const Schema& schema_;
  const Utterance& utterance_;
  std::vector<Span> spans_;
  // Utterance::plain, and the tokens of normal forms.
  std::vector<bool> plain_;
  // By token: whether it is a title or a determiner, which may stand before a
  // value, and whether open words may begin or end with it.
  std::vector<bool> leads_;
  std::vector<bool> stands_;
  // Of known spans by their begin and entity, then of those that were opened.
  std::vector<std::uint32_t> indices_;
  // By position: where its known spans begin in indices_, with one more behind
  // the last; and the bits of their entities.
  std::vector<std::uint32_t> first_at_;
  std::vector<std::uint64_t> entities_;
  // The last one of a position; 0: none, as entry 0 is not used.
  std::vector<std::size_t> last_opened_;
  std::vector<Opened> opened_;
};

} // namespace parlour::adapters::nlu
