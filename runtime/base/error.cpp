#include "runtime/base/error.hpp"

namespace parlour {

std::string_view name_of(ErrorKind kind) {
  switch (kind) {
#define X(name, text, sentence)                                                \
  case ErrorKind::name:                                                        \
    return text;
    PARLOUR_ERROR_KINDS(X)
#undef X
  }
  return "Thrown";
}

std::string to_string(const Error& error) {
  if (error.place.file.empty())
    return error.message;
  auto text = error.place.file;
  if (error.place.line > 0)
    text += ":" + std::to_string(error.place.line);
  return text + ": " + error.message;
}

} // namespace parlour
