#include "adapters/nlu/values/renewed_nlu.hpp"

#include <algorithm>

namespace parlour::adapters::nlu {

namespace {

bool is_of_data(const Error& error) {
  return error.kind == ErrorKind::database || error.kind == ErrorKind::file;
}

// With the column, where it is known.
std::string with_place(const Error& error) {
  const auto& place = error.place;
  if (place.file.empty() || place.column == 0)
    return to_string(error);
  return place.file + ':' + std::to_string(place.line) + ':' +
         std::to_string(place.column) + ": " + error.message;
}

} // namespace

Error joined(const std::vector<Error>& errors) {
  const auto data = std::ranges::find_if(errors, is_of_data);
  if (data != errors.end())
    return *data;
  auto all = errors.front();
  for (std::size_t at = 1; at < errors.size(); ++at)
    all.message += '\n' + with_place(errors[at]);
  return all;
}

} // namespace parlour::adapters::nlu
