#include "adapters/nlu/grammar/marked_text.hpp"

namespace parlour::adapters::nlu {

std::optional<MarkedText> read_marks(std::string_view example) {
  MarkedText made;
  // Each round copies the text up to the next mark, then the words of the mark.
  while (true) {
    const auto open = example.find('[');
    made.text += example.substr(0, open);
    if (open == std::string_view::npos)
      return made;
    const auto middle = example.find("](", open);
    const auto close = example.find(')', open);
    if (middle == std::string_view::npos || close == std::string_view::npos ||
        close < middle)
      return {};
    const auto begin = made.text.size();
    made.text += example.substr(open + 1, middle - open - 1);
    made.marks.push_back(
        {begin, made.text.size(),
         std::string(example.substr(middle + 2, close - middle - 2))});
    example.remove_prefix(close + 1);
  }
}

} // namespace parlour::adapters::nlu
