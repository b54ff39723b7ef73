// The buffer of OutputStream: passes everything on to the C stream.
#include "tools/parlour/console/output_stream.hpp"

#include <cerrno>

namespace parlour::tools {

// The buffer is a member, so it exists only after the base class.
OutputStream::OutputStream(std::FILE* file)
    : std::ostream(nullptr), buffer_(file) {
  rdbuf(&buffer_);
}

std::streambuf::int_type OutputStream::Buffer::overflow(int_type character) {
  if (traits_type::eq_int_type(character, traits_type::eof()))
    return traits_type::not_eof(character);
  return note(std::fputc(character, file_) != EOF) ? character
                                                   : traits_type::eof();
}

std::streamsize OutputStream::Buffer::xsputn(const char* text,
                                             std::streamsize size) {
  const auto bytes = static_cast<std::size_t>(size);
  const auto written = std::fwrite(text, 1, bytes, file_);
  note(written == bytes);
  return static_cast<std::streamsize>(written);
}

int OutputStream::Buffer::sync() {
  return note(std::fflush(file_) == 0) ? 0 : -1;
}

// Only the first failure is kept: later ones follow from it.
bool OutputStream::Buffer::note(bool written) {
  const auto why = errno;
  if (int none = 0; !written)
    trouble.compare_exchange_strong(none, why);
  return written;
}

} // namespace parlour::tools
