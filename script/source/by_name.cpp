#include "script/source/by_name.hpp"

namespace parlour::script {

// The multiplicative hash of Java's String: fast for names, which are short.
// The first letter is hashed as if it were small, to agree with NameEqual.
std::size_t NameHash::operator()(std::string_view name) const {
  constexpr std::size_t letter_case = 0x20;
  std::size_t hash = 0;
  for (std::size_t i = 0; i < name.size(); ++i)
    hash = hash * 31 +
           (static_cast<unsigned char>(name[i]) | (i == 0 ? letter_case : 0));
  return hash;
}

} // namespace parlour::script
