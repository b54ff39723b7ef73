// Understanding by grammars, by names and values, and by what is learnt from
// examples when it is built (understanding, parts 1 to 3). What grammars found
// well stands; what is learnt fills in what they left open.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/base/understanding.hpp"

namespace parlour::adapters::nlu {

struct Understanding {
  // Acts as engine rule 5 wants them, in the order in which they were said;
  // empty where nothing was understood well enough. Beside the keys of
  // runtime/base/understanding.hpp a slot's map has `unmatched` true where the
  // words stand for a value of a set that has no such value.
  List acts;
  double score = 0; // of the best act
  // Why: tokens, islands, scores; a line each. Only where wanted.
  std::vector<std::string> explanation;
  std::size_t work = 0; // arcs tried, for tests of the bounds
};

// Immutable; any number of threads may ask it.
class Understander {
public:
  struct Options {
    double threshold = 0.4;
    std::vector<GrammarModel> generic; // the platform's: yes, no, help …
  };

  // Reads the columns that slots and grammars name. On failure all errors
  // there are.
  static tl::expected<Understander, std::vector<Error>>
  build(const UnderstandingModel& model, const ColumnReader& columns,
        Options options);

  Understander(Understander&&) noexcept;
  Understander& operator=(Understander&&) noexcept;
  ~Understander();

  // `context` is the map that travels with DoNLU, or unknown.
  Understanding understand(std::string_view text, const Value& context = {},
                           bool explain = false) const;

private:
  struct Implementation;

  explicit Understander(std::unique_ptr<const Implementation> implementation);

  std::unique_ptr<const Implementation> implementation_;
};

} // namespace parlour::adapters::nlu
